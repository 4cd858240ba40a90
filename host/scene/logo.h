/* SPDX-License-Identifier: MIT
 * Logos of any size on a picture's. */
#ifndef GLINT_SCENE_LOGO_H
#define GLINT_SCENE_LOGO_H

#include "image/image.h"

enum { LOGO_SIDE_MIN = 8 };

/* The picture's shape, as bevel_coverage has it, in the middle of another of width x height (LOGO_SIDE_MIN and more): as white on
 * black, scaled so that it takes `percent` of the width or of the height, whichever is full first. A pixel at each side stays black. */
struct image *logo_fitted(const struct image *picture, uint32_t width, uint32_t height, double percent);

#endif
