/* SPDX-License-Identifier: MIT
 * Pictures in the levels of a pixel format. */
#ifndef GLINT_IMAGE_LEVELS_H
#define GLINT_IMAGE_LEVELS_H

#include "glint.h"
#include "image/picture.h"

/* 0..31, 0..63, 0..255 or 0..1. */
struct levels {
    uint32_t width, height;
    unsigned channels; /* 3, or 1 for grey and mono */
    unsigned max[3];
    uint8_t *values;
};
/* Of pixels as the library wrote them, lines packed. */
struct levels *levels_of_pixels(uint32_t width, uint32_t height, enum glint_format format, const uint8_t *pixels);
void levels_free(struct levels *levels);
/* How a level of fewer bits than 8 becomes a sample. */
enum widen {
    WIDEN_NEAREST,  /* the nearest of 255 */
    WIDEN_REPLICATE /* its high bits again below it, as many panels do: at most 1 from the nearest */
};
struct picture *levels_picture(const struct levels *levels, enum widen widen);
/* RGB becomes RGBA by the alpha of the pixels that it was made of; without effect where their format has none. */
void picture_add_alpha(struct picture *picture, enum glint_format format, const uint8_t *pixels);

#endif
