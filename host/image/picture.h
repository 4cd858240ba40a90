/* SPDX-License-Identifier: MIT
 * Pictures to be written or shown. */
#ifndef GLINT_IMAGE_PICTURE_H
#define GLINT_IMAGE_PICTURE_H

#include <stdbool.h>
#include <stdint.h>

/* The longest side, and the pixels of an 8K UHD picture; anything larger is a mistake or an attack. */
enum { SIDE_MAX = 16384, PIXELS_MAX = 1 << 25 };
static inline bool picture_size_fits(uint32_t width, uint32_t height)
{
    return width <= SIDE_MAX && height <= SIDE_MAX && width * height <= PIXELS_MAX; /* 2^14 * 2^14 fits 32 bits */
}

/* Grey, RGB or RGBA, 8 bits a sample, lines from the top. */
struct picture {
    uint32_t width, height;
    unsigned channels; /* 1, 3 or 4 */
    bool mono;         /* 1 channel of 0 and 255 only: one bit a pixel where the file format has that */
    uint8_t *samples;
};
void picture_free(struct picture *picture);

uint8_t *picture_rgb(const struct picture *picture); /* grey tripled, alpha dropped; malloc'd */

#endif
