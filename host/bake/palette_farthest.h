/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PALETTE_FARTHEST_H
#define GLINT_PALETTE_FARTHEST_H

#include "bake/palette_grid.h"

/* Fills the entries from number `given` on with farthest points; the centers before that stay. Each point knows its
 * nearest center afterwards. Returns the largest weighted distance that is left. */
double palette_farthest(struct palette_choice *choice, uint32_t given);

#endif
