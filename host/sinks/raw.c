/* SPDX-License-Identifier: MIT
 * Sink raw: whole frames as they are in memory, to standard output. */
#include <stdlib.h>

#include "base/memory.h"
#include "sinks/sink.h"

static struct sink *open_raw(const struct sink_wish *wish)
{
    struct sink *sink = allocate(1, sizeof *sink);
    *sink = (struct sink){.kind = &sink_raw,
                          .width = wish->width ? wish->width : wish->default_width,
                          .height = wish->height ? wish->height : wish->default_height,
                          .format = wish->format < 0 ? GLINT_RGB565 : (enum glint_format)wish->format,
                          .align_x = 1,
                          .whole_frames = true,
                          .max_bytes = SIZE_MAX,
                          .name = "standard output"};
    return sink;
}

static enum sink_result send_raw(struct sink *sink, const struct frame *frame, const struct piece *pieces, size_t count)
{
    (void)pieces;
    (void)count;
    (void)sink;
    return standard_output_write(frame->pixels, frame->line_bytes * frame->height);
}

static void close_raw(struct sink *sink)
{
    free(sink);
}

const struct sink_kind sink_raw = {
    .name = "raw",
    .summary = "pixels to standard output, frame after frame, lines packed",
    .nature = SINK_PIPE,
    .takes_standard_output = true,
    .examples = "  glint stream sphere --to raw --format rgb888 | ffplay -f rawvideo \\\n"
                "      -pixel_format rgb24 -video_size 320x240 -\n",
    .open = open_raw,
    .send = send_raw,
    .close = close_raw,
};
