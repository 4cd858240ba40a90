/* SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"
#include "base/output.h"
#include "paper/paper.h"

const char *const verdict_names[] = {"confirmed", "confirmed with limits", "not confirmed"};

enum verdict verdict_of(bool in_full, bool in_part)
{
    return in_full ? CONFIRMED : in_part ? WITH_LIMITS : NOT_CONFIRMED;
}

static void append(json_t *array, json_t *object)
{
    if (!object || json_array_append_new(array, object) != 0)
        fail("out of memory");
}

void paper_claim(struct paper *paper, const char *part, const char *where, const char *claim, enum verdict verdict,
                 json_t *computed)
{
    append(paper->claims, json_pack("{s:s,s:s,s:s,s:o,s:s}", "part", part, "where", where, "claim", claim, "computed",
                                    computed, "verdict", verdict_names[verdict]));
}

void paper_choice(struct paper *paper, const char *part, const char *silent, json_t *chosen, json_t *other)
{
    append(paper->choices,
           json_pack("{s:s,s:s,s:o,s:o}", "part", part, "silent", silent, "chosen", chosen, "other", other));
}

void paper_number(struct paper *paper, const char *name, double value)
{
    if (json_object_set_new(paper->numbers, name, json_real(value)) != 0)
        fail("paper: the number %s is %g", name, value);
}

void paper_count(struct paper *paper, const char *name, long value)
{
    if (json_object_set_new(paper->numbers, name, json_integer(value)) != 0)
        fail("out of memory");
}

json_t *paper_table_new(struct paper *paper, const char *part, const char *title, const char *const *head)
{
    json_t *columns = json_array();
    for (; *head; head++)
        append(columns, json_string(*head));
    json_t *table = json_pack("{s:s,s:o,s:[]}", "title", title, "head", columns, "rows");
    if (!table || json_object_set_new(paper->tables, part, table) != 0)
        fail("out of memory");
    return table;
}

void paper_table_row(json_t *table, int count, ...)
{
    json_t *row = json_array();
    va_list cells;
    va_start(cells, count);
    for (int i = 0; i < count; i++)
        append(row, va_arg(cells, json_t *));
    va_end(cells);
    append(json_object_get(table, "rows"), row);
}

/* ---- files ---- */

static char *path_of(const struct paper *paper, const char *name)
{
    char *path;
    if (asprintf(&path, "%s/%s", paper->directory, name) < 0)
        fail("out of memory");
    return path;
}

struct output *paper_file(const struct paper *paper, const char *name)
{
    char *path = path_of(paper, name);
    struct output *output = output_open(path);
    free(path);
    return output;
}

static const char *base64(const unsigned char *bytes, size_t size)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    char *text = malloc((size + 2) / 3 * 4 + 1), *at = text;
    if (!text)
        fail("out of memory");
    for (size_t i = 0; i < size; i += 3) {
        const size_t left = size - i;
        const unsigned group = (unsigned)bytes[i] << 16 | (left > 1 ? (unsigned)bytes[i + 1] << 8 : 0) |
                               (left > 2 ? (unsigned)bytes[i + 2] : 0);
        *at++ = digits[group >> 18];
        *at++ = digits[group >> 12 & 63];
        *at++ = left > 1 ? digits[group >> 6 & 63] : '=';
        *at++ = left > 2 ? digits[group & 63] : '=';
    }
    *at = 0;
    return text;
}

static json_t *draw(struct paper *paper, const char *part, int width, int height, const char *script, json_t *figure)
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
    char *picture = plot_run(paper->directory, script_name, &size);
    output = paper_file(paper, image_name);
    fwrite(picture, 1, size, output->stream);
    output_close(output);
    const char *text = base64((unsigned char *)picture, size);
    json_object_set_new(figure, "image", json_string(image_name));
    json_object_set_new(figure, "data", json_sprintf("data:image/%s;base64,%s", png ? "png" : "svg+xml", text));
    free((char *)text);
    free(picture);
    return figure;
}

void paper_figure(struct paper *paper, const char *part, const char *title, int width, int height, const char *script,
                  json_t *caption)
{
    json_t *figure = json_pack("{s:s,s:s,s:o,s:o}", "part", part, "title", title, "caption", caption, "csv",
                               json_sprintf("%s.csv", part));
    if (paper->terminal)
        draw(paper, part, width, height, script, figure);
    append(paper->figures, figure);
}

/* ---- the library's values ---- */

double q16_from_t(enum glint_model model, double n, double x)
{
    const double half = sin(x / 2);
    return glint_eval_t(model, (uint32_t)n, (uint32_t)lround(2 * half * half * GLINT_T_ONE)) / (double)GLINT_C_ONE;
}

double q16_from_c(enum glint_model model, double n, double x)
{
    return glint_eval(model, (uint32_t)n, (int32_t)lround(cos(x) * GLINT_C_ONE)) / (double)GLINT_C_ONE;
}

double q16_cutoff_angle_t(enum glint_model model, double n, unsigned q)
{
    return 2 * asin(sqrt(glint_cutoff_t(model, (uint32_t)n, q) / (2.0 * GLINT_T_ONE)));
}

double q16_cutoff_angle_c(enum glint_model model, double n, unsigned q)
{
    return acos(glint_cutoff(model, (uint32_t)n, q) / (double)GLINT_C_ONE);
}
