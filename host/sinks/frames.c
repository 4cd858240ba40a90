/* SPDX-License-Identifier: MIT */
#include "sinks/frames.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/output.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/picture.h"

/* The length of the conversion at `text`, which begins with %: %d, %4d to %09d, or %% for a percent sign; 0 for any other. */
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

/* A frame beyond those that are tried here is still refused when it is opened. */
void frames_check(const char *pattern, unsigned long count)
{
    enum { TRIED = 100000 };
    const unsigned long end = !strchr(pattern, '%') ? 1 : count && count < TRIED ? count : TRIED;
    for (unsigned long i = 0; i < end; i++) {
        char *name = frame_name(pattern, i);
        output_check(name);
        free(name);
    }
}

struct picture *frame_picture(const struct frame *frame)
{
    struct levels *levels = levels_of_pixels(frame->width, frame->height, frame->format, frame->pixels);
    struct picture *picture = levels_picture(levels, WIDEN_NEAREST);
    levels_free(levels);
    picture_add_alpha(picture, frame->format, frame->pixels);
    return picture;
}

uint8_t *frame_rgb(const struct frame *frame)
{
    struct picture *picture = frame_picture(frame);
    uint8_t *rgb = picture_rgb(picture);
    picture_free(picture);
    return rgb;
}

void frames_without_alpha(const struct sink_wish *wish, const char *sink)
{
    if (wish->format >= 0 && format_has_alpha((enum glint_format)wish->format))
        fail("--format %s: --to %s has no alpha; choose another format, or --to png, webp or raw",
             format_names[wish->format], sink);
}
