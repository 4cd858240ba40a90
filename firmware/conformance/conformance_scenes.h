/* SPDX-License-Identifier: MIT
 * Checks of geometry, rectangles, lights and spans; and random shaders, which other checks use, too. */
#ifndef CONFORMANCE_SCENES_H
#define CONFORMANCE_SCENES_H

#include "conformance.h"
#include "glint.h"

enum { W = 11, H = 3, LINE = 4 * W + 2 }; /* of a rectangle */

void conform_random_shader(struct glint_shader *shader, unsigned model);
/* Of any kind, near the surface; one above it where the library refuses what was chosen. */
void conform_random_lamp(struct glint_lamp *lamp);
void conform_random_normal(struct glint_vec *normal, const struct glint_light *light);

void conform_vectors(const struct conformance_size *size);
void conform_scenes(unsigned format, const struct conformance_size *size);

#endif
