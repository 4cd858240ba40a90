/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PALETTE_COVER_H
#define GLINT_PALETTE_COVER_H

#include "bake/palette_grid.h"

/* Balls of about the smallest radius, below `radius`, for which the entries suffice; the centers become their middles.
 * Returns how many: 0 where none is smaller, or where it would take long. */
uint32_t palette_cover(struct palette_choice *choice, double radius);

#endif
