/* SPDX-License-Identifier: MIT
 * How well the library draws a baked mesh. */
#ifndef GLINT_COMPARE_MESH_QUALITY_H
#define GLINT_COMPARE_MESH_QUALITY_H

#include "compare/quality.h"
#include "draw/view.h"
#include "mesh/fit.h"

/* From three sides, in 240x240 pixels. */
enum { MESH_VIEWS = 3 };
extern const struct view mesh_views[MESH_VIEWS];

/* Pictures of 240x240 from three sides (RGB888, exact, ambient .2, diffuse .9, specular .5, grey) against double precision with
 * normalised normals, rounded, where both show the same triangle. */
void mesh_quality(const struct mesh *mesh, const struct fitted *fitted, bool normals8,
                  struct quality rows[QUALITY_ROWS]);

#endif
