/* SPDX-License-Identifier: MIT
 * The checks of meshes. */
#ifndef CONFORMANCE_MESHES_H
#define CONFORMANCE_MESHES_H

#include "conformance.h"

enum { CONFORM_VERTICES = 10, CONFORM_FACES = 14, CONFORM_WIDTH = 19 }; /* of a picture */

/* Adds a picture of a random mesh: 0: as random as can be; else the like of models as people have them, in perspective where kind is not a
 * multiple of 3. stride: bytes of a line, up to 4 a pixel. */
void conform_mesh(unsigned kind, const struct glint_light *light, const struct glint_paint *paint, uint8_t stride);

/* Exact, or by COLOUR tables. */
void conform_meshes(const struct conformance_size *size, bool tables);

#endif
