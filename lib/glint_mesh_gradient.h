/* SPDX-License-Identifier: MIT
 * Internal. What changes linearly or quadratically over a triangle, as steps from pixel to pixel. */
#ifndef GLINT_MESH_GRADIENT_H
#define GLINT_MESH_GRADIENT_H

#include "glint_mesh.h"

/* A corner of a triangle. */
struct glint_mesh_corner {
    const struct glint_mesh_vertex *v;
    uint32_t side; /* |a - b|^2 / 2 in Q29, < 2^32, of the other two's normals; read where the triangle may be glossy */
};

/* Dark: nl < 0 at all corners, and -1 all over. Matt: past the highlight, t is GLINT_MESH_FAR_T all over. */
enum glint_mesh_shine { GLINT_MESH_DARK, GLINT_MESH_MATT, GLINT_MESH_GLOSSY };
#define GLINT_MESH_FAR_T ((uint32_t)1 << 31)

/* Values at the middle of a pixel, in column x, and their steps; all modulo 2^32. A pixel to the right adds tx to t, then txx to tx; a line
 * down adds ty to t, tyy to ty and txy to tx. nl and z are linear; z is Q16.16. */
struct glint_mesh_values {
    uint32_t z, nl, t, tx, ty;  /* in the order in which assembly takes them: what changes from line to line */
    uint32_t zy, nly, txy, tyy; /* and by how much */
    uint32_t zx, nlx, txx;
    int32_t x;
};

/* Twice the area in square 1/16 pixels, positive where the corners are clockwise on the screen (y down): 2 (2^15 - 2)^2 at
 * most. */
static inline int32_t glint_mesh_area(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                                      const struct glint_mesh_vertex *c)
{
    return (int32_t)(b->x - a->x) * (c->y - a->y) - (int32_t)(c->x - a->x) * (b->y - a->y);
}

/* From t and nl at the corners alone. t is at most so much lower between corners that are 90 degrees apart: half the square of their
 * distance. From t_end on nothing shines. */
enum glint_mesh_shine glint_mesh_shine(const struct glint_mesh_corner corner[3], uint32_t t_end);

/* From three corners, the upper one first, in the first line whose middle is at or below it; area is not 0. shine as above; returns what it
 * is, since from the normals a glossy one may turn out to be matt. */
enum glint_mesh_shine glint_mesh_values_set(struct glint_mesh_values *values,
                                            const struct glint_mesh_corner *const corner[3], int32_t area,
                                            enum glint_mesh_shine shine, uint32_t t_end);

/* Zero bits above the highest of x, which is not 0. */
static inline unsigned glint_mesh_zeros(uint32_t x)
{
    return (unsigned)(sizeof(int) >= sizeof x ? __builtin_clz((unsigned)x) : __builtin_clzl(x));
}

/* 2^43 / m to nearest, nearly: 2^15..2^16, for m = 2^27..2^28 - 1 of which the lower bits may be cut. */
uint32_t glint_mesh_inverse(uint32_t m);

#endif
