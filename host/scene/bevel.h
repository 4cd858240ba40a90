/* SPDX-License-Identifier: MIT
 * Rounded edges for flat shapes, such as logos. */
#ifndef GLINT_SCENE_BEVEL_H
#define GLINT_SCENE_BEVEL_H

#include "image/image.h"

/* Heights 0..1 of the shape in the picture: 0 outside, rising as a quarter of a circle over `width` pixels from its edge
 * inwards, then 1. The shape is what alpha covers; in an opaque picture it is what differs in brightness from the rim. malloc'd. A
 * picture without a shape ends the program through fail(). */
double *bevel_heights(const struct image *picture, double width);
/* How much of each pixel the shape covers, 0..1; malloc'd. */
double *bevel_coverage(const struct image *picture);

/* The distance of each pixel from the edge, in pixels; 0 outside. `coverage`: 0..1, of which at least one is under 1/2:
 * half and more is inside, and what lies between 0 and 1 moves the edge within its pixel. malloc'd. */
double *bevel_distances(const double *coverage, uint32_t width, uint32_t height);

#endif
