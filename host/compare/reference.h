/* SPDX-License-Identifier: MIT
 * The picture that the library's picture should be, in double precision. */
#ifndef GLINT_COMPARE_REFERENCE_H
#define GLINT_COMPARE_REFERENCE_H

#include "draw/shading.h"
#include "scene/scene.h"

/* Line y of the scene by steps 1 to 7 of glint.h, for any model: each channel is 0..1, before the rounding. A highlight
 * is 0 where its true value is under 2^-q, and where the light does not reach the surface. `shading`: of each of the scene's parts. */
void reference_line(const struct scene *scene, const struct shading *shading, enum glint_model model, uint32_t y,
                    double *values);
/* The rounding: step 8. */
unsigned reference_level(double value, unsigned max, bool dither, uint32_t x, uint32_t y);

#endif
