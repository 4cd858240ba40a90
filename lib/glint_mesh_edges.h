/* SPDX-License-Identifier: MIT
 * Internal. Which pixels a triangle covers, and their values line by line. */
#ifndef GLINT_MESH_EDGES_H
#define GLINT_MESH_EDGES_H

#include "glint_mesh_gradient.h"

/* Lines y..y_end - 1 from the first corner down; up to y_middle its short edge is the upper one. */
struct glint_mesh_edge {
    int32_t x, step; /* Q16.16: the first column whose middle is at or beyond the edge, and a line */
};
struct glint_mesh_triangle {
    struct glint_mesh_values values; /* at line y */
    struct glint_mesh_edge long_edge, upper, lower;
    int16_t y, y_middle, y_end;
    uint8_t shine; /* enum glint_mesh_shine */
    bool long_is_left;
};

/* The first line or column whose middle is at or beyond a place in 1/16 pixel. */
static inline int32_t glint_mesh_first(int32_t place)
{
    return (place + 7) >> 4;
}

/* Three corners in any order, and what glint_mesh_shine says of them; false where no line's middle lies between them. */
bool glint_mesh_triangle_set(struct glint_mesh_triangle *triangle, const struct glint_mesh_corner corner[3],
                             enum glint_mesh_shine shine, uint32_t t_end);

/* To line y, at or after the triangle's. */
void glint_mesh_triangle_skip(struct glint_mesh_triangle *triangle, int32_t y);

/* The columns of its line, those from 0 on before w: *left..*right - 1; false where there is none. */
static inline bool glint_mesh_columns(const struct glint_mesh_edge *left_edge, const struct glint_mesh_edge *right_edge,
                                      int32_t w, int32_t *left, int32_t *right)
{
    const int32_t from = left_edge->x >> 16, to = right_edge->x >> 16;
    *left = from < 0 ? 0 : from;
    *right = to > w ? w : to;
    return *left < *right;
}

/* A part of a triangle, lines y..end - 1, whose left and right edge stay the same. */
struct glint_mesh_part {
    struct glint_mesh_edge *left, *right;
    int32_t end;
};

/* The part that begins at its line; end: y_end or before. */
static inline struct glint_mesh_part glint_mesh_triangle_part(struct glint_mesh_triangle *triangle, int32_t end)
{
    const bool is_upper = triangle->y < triangle->y_middle;
    struct glint_mesh_edge *const edge = is_upper ? &triangle->upper : &triangle->lower;
    const struct glint_mesh_part part = {triangle->long_is_left ? &triangle->long_edge : edge,
                                         triangle->long_is_left ? edge : &triangle->long_edge,
                                         is_upper && triangle->y_middle < end ? triangle->y_middle : end};
    return part;
}

static inline void glint_mesh_edge_next(struct glint_mesh_edge *edge)
{
    edge->x = (int32_t)((uint32_t)edge->x + (uint32_t)edge->step);
}

/* To the next line. */
static inline void glint_mesh_values_next(struct glint_mesh_values *v)
{
    v->t += v->ty;
    v->ty += v->tyy;
    v->tx += v->txy;
    v->nl += v->nly;
    v->z += v->zy;
}

#endif
