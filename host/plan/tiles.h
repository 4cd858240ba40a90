/* SPDX-License-Identifier: MIT
 * The frame cut into tiles along a grid. */
#ifndef GLINT_PLAN_TILES_H
#define GLINT_PLAN_TILES_H

#include "plan/boxes.h"

/* The cheapest cuts along a grid. */
double boxes_of_tiles(const struct changes *changes, const struct box_price *price, unsigned align_x,
                      struct boxes *boxes);

#endif
