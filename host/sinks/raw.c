/* SPDX-License-Identifier: MIT
 * Sink raw: whole frames as they are in memory, to standard output. */
#include <stdlib.h>
#include <unistd.h>

#include "base/memory.h"
#include "sinks/outputs.h"
#include "sinks/sink.h"
#include "sinks/write.h"

static const char name[] = "standard output";

static struct sink *open_raw(const struct sink_wish *wish)
{
    struct sink *sink = allocate(1, sizeof *sink);
    *sink = (struct sink){.format = wish->format < 0 ? GLINT_RGB565 : (enum glint_format)wish->format,
                          .align_x = 1,
                          .whole_frames = true,
                          .max_bytes = SIZE_MAX,
                          .name = name};
    sink_size(sink, wish);
    return sink;
}

static enum sink_result send_raw(struct sink *sink, const struct frame *frame, const struct piece *pieces, size_t count)
{
    (void)pieces;
    (void)count;
    (void)sink;
    return sink_write(STDOUT_FILENO, name, frame->pixels, frame->line_bytes * frame->height);
}

static void close_raw(struct sink *sink)
{
    free(sink);
}

const struct sink_kind sink_raw = {
    .name = "raw",
    .summary = "pixels to standard output, frame after frame, lines packed",
    .output = &output_standard,
    .examples = "  glint stream sphere --to raw --format rgb888 | ffplay -f rawvideo \\\n"
                "      -pixel_format rgb24 -video_size 320x240 -\n",
    .pixels = {.open = open_raw, .send = send_raw, .close = close_raw},
};
