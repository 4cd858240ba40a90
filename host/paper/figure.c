/* SPDX-License-Identifier: MIT */
#include "paper/figure.h"

#include <stdlib.h>
#include <string.h>

#include "base/folder.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "paper/plot.h"

static const char *base64(const unsigned char *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
    char *text = allocate((size + 2) / 3 * 4 + 1, 1), *at = text;
    for (size_t i = 0; i < size; i += 3) {
        const size_t left = size - i;
        const unsigned group = (unsigned)bytes[i] << 16 | (left > 1 ? (unsigned)bytes[i + 1] << 8 : 0) |
                               (left > 2 ? (unsigned)bytes[i + 2] : 0);
        *at++ = digits[group >> 18];
        *at++ = digits[group >> 12 & 63];
        *at++ = digits[left > 1 ? group >> 6 & 63 : 64];
        *at++ = digits[left > 2 ? group & 63 : 64];
    }
    *at = 0;
    return text;
}

static void draw(struct paper *paper, const char *part, int width, int height, const char *script, json_t *figure)
{
    const bool png = strcmp(paper->terminal, "pngcairo") == 0;
    char script_name[32], image_name[32];
    snprintf(script_name, sizeof script_name, "%s.gp", part);
    snprintf(image_name, sizeof image_name, "%s.%s", part, png ? "png" : "svg");

    struct output *output = paper_file(paper, script_name);
    fprintf(output->stream,
            "# gnuplot %s >%s\n"
            "set terminal %s size %d,%d font 'sans,11' background rgb 'white'\n"
            "set datafile separator ','\n"
            "set datafile columnheaders\n"
            "set encoding utf8\n"
            "set grid\n%s",
            script_name, image_name, paper->terminal, width, height, script);
    output_close(output);

    size_t size;
    char *picture = plot_run(folder_work(paper->folder), script_name, &size);
    output = paper_file(paper, image_name);
    fwrite(picture, 1, size, output->stream);
    output_close(output);
    const char *text = base64((unsigned char *)picture, size);
    json_object_set_new(figure, "image", json_string(image_name));
    json_object_set_new(figure, "data", json_sprintf("data:image/%s;base64,%s", png ? "png" : "svg+xml", text));
    free((char *)text);
    free(picture);
}

void paper_figure(struct paper *paper, const char *part, const char *title, int width, int height, const char *script,
                  json_t *caption)
{
    json_t *figure = json_pack("{s:s,s:s,s:o,s:o}", "part", part, "title", title, "caption", caption, "csv",
                               json_sprintf("%s.csv", part));
    if (paper->terminal)
        draw(paper, part, width, height, script, figure);
    if (!figure || json_array_append_new(paper->figures, figure) != 0)
        fail("out of memory");
}
