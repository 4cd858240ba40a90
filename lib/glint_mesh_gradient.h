/* SPDX-License-Identifier: MIT
 * Internal. What changes linearly or quadratically over a triangle, as steps from pixel to pixel. */
#ifndef GLINT_MESH_GRADIENT_H
#define GLINT_MESH_GRADIENT_H

#include "glint_mesh.h"

/* A corner of a triangle. */
struct glint_mesh_corner {
    struct glint_mesh_vertex v;
    struct glint_vec normal;
};

/* Values at the middle of a pixel, in column x, and their steps; all modulo 2^32. A pixel to the right adds tx to t, then txx to tx; a line
 * down adds ty to t, tyy to ty and txy to tx. nl and z are linear; z is Q16.16. */
struct glint_mesh_values {
    int32_t x;
    uint32_t t, tx, ty, txx, txy, tyy;
    uint32_t nl, nlx, nly;
    uint32_t z, zx, zy;
};

/* Twice the area in square 1/16 pixels, positive where the corners are clockwise on the screen (y down): 2 (2^15 - 2)^2 at
 * most. */
static inline int32_t glint_mesh_area(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                                      const struct glint_mesh_vertex *c)
{
    return (int32_t)(b->x - a->x) * (c->y - a->y) - (int32_t)(c->x - a->x) * (b->y - a->y);
}

/* From three corners, the upper one first, in the first line whose middle is at or below it; area is not 0. */
void glint_mesh_values_set(struct glint_mesh_values *values, const struct glint_mesh_corner *const corner[3],
                           int32_t area);

#endif
