/* SPDX-License-Identifier: MIT
 * Sinks png and ppm: each frame a file. */
#include <stdlib.h>

#include "base/memory.h"
#include "base/output.h"
#include "image/picture.h"
#include "image/write.h"
#include "sinks/frames.h"
#include "sinks/outputs.h"

struct files {
    struct sink sink;
    enum image_kind kind;
    const char *pattern;
    unsigned long next;
};

static struct sink *open_files(const struct sink_wish *wish, enum image_kind image)
{
    struct files *files = allocate(1, sizeof *files);
    files->sink = (struct sink){.format = wish->format < 0 ? GLINT_RGB888 : (enum glint_format)wish->format,
                                .align_x = 1,
                                .whole_frames = true,
                                .max_bytes = SIZE_MAX,
                                .name = wish->output};
    sink_size(&files->sink, wish);
    files->kind = image;
    files->pattern = wish->output;
    return &files->sink;
}

static struct sink *open_png(const struct sink_wish *wish)
{
    return open_files(wish, IMAGE_PNG);
}

static struct sink *open_ppm(const struct sink_wish *wish)
{
    frames_without_alpha(wish, "ppm");
    return open_files(wish, IMAGE_PPM);
}

static enum sink_result send_file(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                  size_t count)
{
    (void)pieces;
    (void)count;
    struct files *files = (struct files *)sink;
    struct picture *picture = frame_picture(frame);
    char *name = frame_name(files->pattern, files->next++);
    struct output *output = output_open(name);
    picture_write(picture, output, files->kind);
    output_close(output);
    free(name);
    picture_free(picture);
    return SINK_SENT;
}

static void close_files(struct sink *sink)
{
    free(sink);
}

const struct sink_kind sink_png = {
    .name = "png",
    .summary = "PNG files, one a frame: -o frame-%04d.png",
    .output = &output_file_a_frame,
    .every_frame = true,
    .examples = "  glint stream dial --to png -o dial-%03d.png --fps 10\n",
    .pixels = {.open = open_png, .send = send_file, .close = close_files},
};

const struct sink_kind sink_ppm = {
    .name = "ppm",
    .summary = "the same as PPM (PGM and PBM for grey8 and mono)",
    .output = &output_file_a_frame,
    .every_frame = true,
    .examples = "  glint stream --height wall.png --to ppm -o wall-%d.ppm --lights light.txt\n",
    .pixels = {.open = open_ppm, .send = send_file, .close = close_files},
};
