/* SPDX-License-Identifier: MIT
 * Frames as files: their names, their pixels as pictures; and bytes to standard output. */
#include <ctype.h>
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/stop.h"
#include "image/levels.h"
#include "image/levels.h"
#include "image/picture.h"
#include "sinks/sink.h"

/* A conversion at `text`, which begins with %: its length, 0 where it is none of ours. %%: a percent sign. */
static size_t conversion(const char *text, unsigned *digits)
{
    *digits = 0;
    if (text[1] == '%')
        return 2;
    size_t at = 1;
    if (text[at] == '0' && isdigit((unsigned char)text[at + 1]))
        *digits = (unsigned)(text[++at] - '0');
    if (*digits)
        at++;
    return text[at] == 'd' ? at + 1 : 0;
}

bool frame_pattern(const struct argp_state *state, const char *option, const char *pattern)
{
    int numbers = 0;
    for (const char *at = strchr(pattern, '%'); at; at = strchr(at, '%')) {
        unsigned digits;
        const size_t length = conversion(at, &digits);
        if (!length)
            refuse(state,
                   "%s: '%s' has a %% that is neither %%d nor %%04d (up to 9 digits); a %% itself is written %%%%",
                   option, pattern);
        numbers += at[1] != '%';
        at += length;
    }
    if (numbers > 1)
        refuse(state, "%s: '%s' has %d places for the frame's number; it takes one", option, pattern, numbers);
    return numbers == 1;
}

char *frame_name(const char *pattern, unsigned long index)
{
    const size_t size = strlen(pattern) + 32;
    char *name = allocate(size, 1), *to = name;
    for (const char *at = pattern; *at;) {
        unsigned digits;
        const size_t length = *at == '%' ? conversion(at, &digits) : 0;
        if (length && at[1] != '%')
            to += sprintf(to, "%0*lu", (int)digits, index);
        else
            *to++ = *at;
        at += length ? length : 1;
    }
    return name;
}

struct picture *frame_picture(const struct frame *frame)
{
    struct levels *levels = levels_of_pixels(frame->width, frame->height, frame->format, frame->pixels);
    struct picture *picture = levels_picture(levels);
    levels_free(levels);
    return picture;
}

enum sink_result standard_output_write(const void *bytes, size_t count)
{
    const uint8_t *from = bytes;
    for (size_t done = 0; done < count;) {
        if (stream_stopped())
            return SINK_INTERRUPTED;
        const ssize_t written = write(STDOUT_FILENO, from + done, count - done);
        if (written >= 0)
            done += (size_t)written;
        else if (errno == EAGAIN)
            poll(&(struct pollfd){.fd = STDOUT_FILENO, .events = POLLOUT}, 1, -1);
        else if (errno != EINTR)
            fail("standard output: could not be written: %s", strerror(errno));
    }
    return SINK_SENT;
}
