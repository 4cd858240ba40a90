/* SPDX-License-Identifier: MIT */
#ifndef GLINT_PALETTE_ROUNDS_H
#define GLINT_PALETTE_ROUNDS_H

#include "bake/palette_grid.h"

/* Moves the centers, which have been chosen, and gives each point its nearest one. */
void palette_rounds(struct palette_choice *choice);

#endif
