/* SPDX-License-Identifier: MIT
 * Sink raw: whole frames as they are in memory, to standard output. */
#include <errno.h>
#include <poll.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "host.h"
#include "image.h"
#include "sink.h"

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
    const size_t bytes = frame->line_bytes * frame->height;
    for (size_t done = 0; done < bytes;) {
        if (stream_stopped())
            return SINK_INTERRUPTED;
        const ssize_t written = write(STDOUT_FILENO, frame->pixels + done, bytes - done);
        if (written >= 0)
            done += (size_t)written;
        else if (errno == EAGAIN)
            poll(&(struct pollfd){.fd = STDOUT_FILENO, .events = POLLOUT}, 1, -1);
        else if (errno != EINTR)
            fail("%s: could not be written: %s", sink->name, strerror(errno));
    }
    return SINK_SENT;
}

static void close_raw(struct sink *sink)
{
    free(sink);
}

const struct sink_kind sink_raw = {
    .name = "raw",
    .summary = "pixels to standard output, frame after frame, lines packed (default: rgb565)",
    .nature = SINK_PIPE,
    .open = open_raw,
    .send = send_raw,
    .close = close_raw,
};
