/* SPDX-License-Identifier: MIT
 * Sink none: no device; what would be sent to a USB display, for --stats. */
#include <stdlib.h>

#include "image.h"
#include "sink.h"

static struct sink *open_none(const struct sink_wish *wish)
{
    struct sink *sink = allocate(1, sizeof *sink);
    *sink = (struct sink){.kind = &sink_none,
                          .width = wish->width ? wish->width : wish->default_width,
                          .height = wish->height ? wish->height : wish->default_height,
                          .format = wish->format < 0 ? GLINT_RGB565 : (enum glint_format)wish->format,
                          .align_x = 1,
                          .lz4 = true,
                          .max_bytes = SIZE_MAX,
                          .cost = {usb_rectangle_s, usb_rates[USB_RATES - 1]},
                          .name = "no device"};
    return sink;
}

static enum sink_result send_none(struct sink *sink, const struct frame *frame, const struct piece *pieces,
                                  size_t count)
{
    (void)sink;
    (void)frame;
    (void)pieces;
    (void)count;
    return SINK_SENT;
}

static void close_none(struct sink *sink)
{
    free(sink);
}

const struct sink_kind sink_none = {
    .name = "none",
    .summary = "nowhere: --stats tells what a USB display would be sent",
    .nature = SINK_PIPE,
    .open = open_none,
    .send = send_none,
    .close = close_none,
};
