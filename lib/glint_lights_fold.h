/* SPDX-License-Identifier: MIT
 * A lone coloured lamp, as a white one over a material of its colour; internal. */
#ifndef GLINT_LIGHTS_FOLD_H
#define GLINT_LIGHTS_FOLD_H

#include "glint_pixel_prepared.h"

/* Folds a format of gamma space with the lamp's colour in the material's coefficients, and notes in prepared->high that it did.
 * Samples are then those of a white lamp as bright as the brightest channel. The shader's material stays as it is. */
void glint_lights_fold(struct glint_prepared *prepared, const struct glint_lamp *lamp);

#endif
