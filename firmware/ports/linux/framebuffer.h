/* SPDX-License-Identifier: MIT
 * A framebuffer of the kernel's: where a picture's pixels lie in it, and how a pixel is made up. */
#ifndef FRAMEBUFFER_H
#define FRAMEBUFFER_H

#include <linux/fb.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct framebuffer {
    uint8_t *pixels; /* the first visible one; NULL: no framebuffer */
    size_t offset;   /* of that one in the mapped memory, which begins with a page */
    size_t bytes;    /* to be mapped */
    uint32_t line;   /* bytes from a line to the next */
    unsigned pixel;  /* bytes of one: 2, 3 or 4 */
    uint32_t opaque; /* the bits of its alpha, if it has one */
    struct {
        uint8_t offset, length; /* bits from the lowest */
    } channels[3];              /* r, g, b */
};

/* From what the driver says. NULL: a picture of this size fits; else why not. */
const char *framebuffer_layout(struct framebuffer *framebuffer, const struct fb_var_screeninfo *screen,
                               const struct fb_fix_screeninfo *memory, unsigned width, unsigned height);
/* Pixels of a line, r, g, b each, to x, y; NULL: black. */
void framebuffer_put(const struct framebuffer *framebuffer, unsigned x, unsigned y, unsigned width, const uint8_t *rgb);

#endif
