/* SPDX-License-Identifier: MIT
 * The center nearest to a place. */
#ifndef GLINT_PALETTE_NEAREST_H
#define GLINT_PALETTE_NEAREST_H

#include "bake/palette_grid.h"

/* Sorts the choice's centers into the grid: their numbers go to `order`, cell after cell. */
void palette_sort_centers(const struct palette_choice *choice, struct palette_grid *grid, uint32_t *order);
/* The number of the center nearest to `at`, and its distance. */
uint32_t palette_nearest(const struct palette_choice *choice, const struct palette_grid *grid, const uint32_t *order,
                         const double at[3], double *off);

#endif
