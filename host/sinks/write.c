/* SPDX-License-Identifier: MIT */
#include "sinks/write.h"

#include <errno.h>
#include <limits.h>
#include <poll.h>
#include <string.h>
#include <unistd.h>

#include "base/message.h"
#include "base/stop.h"

enum { TICK_MS = 100, PATIENCE_MS = 1000 };

/* Writes only what is taken at once, so that no write blocks and a signal is noticed within TICK_MS: once a pipe polls as
 * writable it has room for PIPE_BUF bytes. A signal leaves the rest PATIENCE_MS, counted from the last byte taken. */
int sink_write_error(int descriptor, const void *bytes, size_t count)
{
    const uint8_t *from = bytes;
    unsigned waited_ms = 0;
    for (size_t done = 0; done < count;) {
        struct pollfd ready = {.fd = descriptor, .events = POLLOUT};
        const int polled = poll(&ready, 1, TICK_MS);
        if (polled < 0) /* a signal */
            continue;
        if (polled == 0) {
            waited_ms = stream_stopped() ? waited_ms + TICK_MS : 0;
            if (waited_ms > PATIENCE_MS)
                return EINTR;
            continue;
        }
        const size_t left = count - done;
        const ssize_t written = write(descriptor, from + done, left < PIPE_BUF ? left : PIPE_BUF);
        if (written >= 0) {
            done += (size_t)written;
            waited_ms = 0;
        } else if (errno != EINTR && errno != EAGAIN) {
            return errno;
        }
    }
    return 0;
}

enum sink_result sink_write(int descriptor, const char *name, const void *bytes, size_t count)
{
    const int error = sink_write_error(descriptor, bytes, count);
    if (error && error != EINTR)
        fail("%s: could not be written: %s", name, strerror(error));
    return error ? SINK_INTERRUPTED : SINK_SENT;
}
