/* SPDX-License-Identifier: MIT
 * Pictures as read from files. */
#ifndef GLINT_IMAGE_IMAGE_H
#define GLINT_IMAGE_IMAGE_H

#include <stdbool.h>
#include <stdint.h>

/* 65535 = 1.0 whatever the file's depth (8-bit samples times 257), lines from the top. */
struct image {
    char *name; /* as the user named the file */
    uint32_t width, height;
    unsigned channels; /* 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA */
    unsigned bits;     /* of a sample in the file: 1, 2, 4, 8 or 16 */
    bool palette;
    uint16_t *samples;
    bool is_coverage; /* of a shape, as it is: black is outside it */
};
void image_free(struct image *image);

/* Some of its lines, from `first` on, repeated beyond its last and before its first. */
struct image *image_lines(const struct image *image, int64_t first, uint32_t count);

/* Alpha is dropped, 16 bits are rounded to 8; malloc'd. */
uint8_t *image_rgb8(const struct image *image);
uint8_t *image_grey8(const struct image *image);
/* Is some pixel wholly transparent? Other alpha leaves nothing out. */
bool image_cuts_out(const struct image *image);
uint8_t *image_alpha8(const struct image *image);  /* where there is alpha */
double *image_grey(const struct image *image);     /* 0..1, at the file's full precision */
bool image_is_grey(const struct image *image);     /* red, green and blue are equal throughout */
bool image_is_constant(const struct image *image); /* one brightness throughout */

#endif
