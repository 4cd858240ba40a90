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
    int32_t y, y_middle, y_end;
    bool long_is_left;
};

/* The first line or column whose middle is at or beyond a place in 1/16 pixel. */
static inline int32_t glint_mesh_first(int32_t place)
{
    return (place + 7) >> 4;
}

/* Three corners in any order; false where no line's middle lies between them. */
bool glint_mesh_triangle_set(struct glint_mesh_triangle *triangle, const struct glint_mesh_corner corner[3]);

/* To line y, at or after the triangle's. */
void glint_mesh_triangle_skip(struct glint_mesh_triangle *triangle, int32_t y);

/* The columns of its line, those from 0 on before w: *left..*right - 1; false where there is none. */
static inline bool glint_mesh_triangle_line(const struct glint_mesh_triangle *triangle, int32_t w, int32_t *left,
                                            int32_t *right)
{
    const struct glint_mesh_edge *edge = triangle->y < triangle->y_middle ? &triangle->upper : &triangle->lower;
    const int32_t a = triangle->long_edge.x >> 16, b = edge->x >> 16;
    const int32_t from = triangle->long_is_left ? a : b, to = triangle->long_is_left ? b : a;
    *left = from < 0 ? 0 : from;
    *right = to > w ? w : to;
    return *left < *right;
}

static inline void glint_mesh_edge_next(struct glint_mesh_edge *edge)
{
    edge->x = (int32_t)((uint32_t)edge->x + (uint32_t)edge->step);
}

/* To the next line: a skip by one. */
static inline void glint_mesh_triangle_next(struct glint_mesh_triangle *triangle)
{
    struct glint_mesh_values *v = &triangle->values;
    v->t += v->ty;
    v->ty += v->tyy;
    v->tx += v->txy;
    v->nl += v->nly;
    v->z += v->zy;
    glint_mesh_edge_next(&triangle->long_edge);
    glint_mesh_edge_next(triangle->y < triangle->y_middle ? &triangle->upper : &triangle->lower);
    triangle->y++;
}

#endif
