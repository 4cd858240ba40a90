/* SPDX-License-Identifier: MIT
 * A pixel belongs to a triangle if its middle does; a middle on an edge, to the triangle right of it or below. Each edge is stepped
 * from its upper corner on, so that the two triangles beside it see the same columns, whatever rounding does to them. */
#include "glint_mesh_edges.h"
#include "glint_math_assembly.h"

#if !GLINT_CORTEX_M0PLUS_ASM
/* The quotient by the inverse of dy: within 2^-16 of it or 2^-16 pixel a line. dx <= 2^15 - 2, so dx 2^16 < 2^31; the middle of the
 * first line is within dy of the corner where there is a line, so |step / 16| times that is at most 2^27. */
static struct glint_mesh_edge edge_of(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b)
{
    struct glint_mesh_edge edge = {0, 0};
    const int32_t first = glint_mesh_first(a->y);
    if (first >= glint_mesh_first(b->y))
        return edge;
    const uint32_t dy = (uint32_t)(b->y - a->y); /* 1..2^15 - 2 */
    const unsigned up = glint_mesh_zeros(dy);    /* 17..31 */
    edge.step = (b->x - a->x) * (int32_t)glint_mesh_inverse(dy << up >> 4) >> (31 - up);
    edge.x = (int32_t)a->x * 4096 + (edge.step >> 4) * (16 * first + 8 - a->y) - 32768 + 65535;
    return edge;
}

/* By y; equal ones stay. */
static inline void edges_order(const struct glint_mesh_corner **upper, const struct glint_mesh_corner **lower)
{
    const struct glint_mesh_corner *const first = *upper;
    if ((*lower)->v->y < first->v->y) {
        *upper = *lower;
        *lower = first;
    }
}

bool glint_mesh_triangle_set(struct glint_mesh_triangle *triangle, const struct glint_mesh_corner corner[3],
                             enum glint_mesh_shine shine, uint32_t t_end)
{
    const struct glint_mesh_corner *first = corner, *second = corner + 1, *third = corner + 2;
    edges_order(&first, &second);
    edges_order(&second, &third);
    edges_order(&first, &second);
    const struct glint_mesh_corner *const c[3] = {first, second, third};
    const struct glint_mesh_vertex *a = first->v, *b = second->v, *d = third->v;
    triangle->y = (int16_t)glint_mesh_first(a->y);
    triangle->y_middle = (int16_t)glint_mesh_first(b->y);
    triangle->y_end = (int16_t)glint_mesh_first(d->y);
    if (triangle->y >= triangle->y_end)
        return false;
    const int32_t area = glint_mesh_area(a, b, d);
    if (area == 0)
        return false;
    triangle->long_is_left = area > 0; /* the middle corner is right of the long edge */
    triangle->long_edge = edge_of(a, d);
    triangle->upper = edge_of(a, b);
    triangle->lower = edge_of(b, d);
    triangle->shine = (uint8_t)glint_mesh_values_set(&triangle->values, c, area, shine, t_end);
    return true;
}

#endif

static void edge_skip(struct glint_mesh_edge *edge, uint32_t lines)
{
    edge->x = (int32_t)((uint32_t)edge->x + lines * (uint32_t)edge->step);
}

/* n steps at once: what grows by constants grows by n (n - 1) / 2 of its own step. */
void glint_mesh_triangle_skip(struct glint_mesh_triangle *triangle, int32_t y)
{
    struct glint_mesh_values *v = &triangle->values;
    const uint32_t n = (uint32_t)(y - triangle->y), pairs = n * (n - 1) / 2; /* n <= 2^12 */
    v->t += n * v->ty + (n ? pairs * v->tyy : 0);
    v->ty += n * v->tyy;
    v->tx += n * v->txy;
    v->nl += n * v->nly;
    v->z += n * v->zy;
    edge_skip(&triangle->long_edge, n);
    if (triangle->y < triangle->y_middle)
        edge_skip(&triangle->upper, n); /* may go past its end: it is read no more */
    if (y > triangle->y_middle)
        edge_skip(&triangle->lower,
                  (uint32_t)(y - (triangle->y > triangle->y_middle ? triangle->y : triangle->y_middle)));
    triangle->y = (int16_t)y;
}
