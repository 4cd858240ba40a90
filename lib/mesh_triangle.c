/* SPDX-License-Identifier: MIT
 * With P and Q the differences of the normals along two sides, and u, v the place in the triangle in these units, N = N0 + u P + v Q.
 * So t = |N - H|^2 / 2 needs no vector: D.P and D.Q, D = N - H, follow from the corners' t, and P.P, Q.Q, P.Q from the sides'
 * lengths. u and v change by constants a pixel, held as 15-bit mantissas with one exponent; what they are multiplied by is
 * cut to 15 bits, too, so that a sum of two products fits 32 bits. Most triangles lie outside the highlight and need nl and the
 * depth alone. */
#include "glint_mesh_strip.h"
#include "glint_mesh_triangle.h"
#include "glint_port.h"
#include "glint_math.h"

/* The least t at the corners, from t_end on; 0 where it is less. */
static uint32_t gradient_beyond(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                                const struct glint_mesh_vertex *c, uint32_t t_end)
{
    uint32_t least = a->t_q30 < b->t_q30 ? a->t_q30 : b->t_q30;
    least = c->t_q30 < least ? c->t_q30 : least;
    return least > t_end ? least - t_end : 0;
}

enum glint_mesh_shine glint_mesh_shine(const struct glint_mesh_corner corner[3], uint32_t t_end)
{
    const struct glint_mesh_vertex *a = corner[0].v, *b = corner[1].v, *c = corner[2].v;
    if ((a->nl_q30 & b->nl_q30 & c->nl_q30) < 0)
        return GLINT_MESH_DARK;
    return gradient_beyond(a, b, c, t_end) >> 29 ? GLINT_MESH_MATT : GLINT_MESH_GLOSSY;
}

uint32_t glint_mesh_inverse(uint32_t m)
{
    return (glint_reciprocal(m) + (1 << 14)) >> 15;
}

/* In each of the two that call it. */
static inline __attribute__((always_inline)) struct glint_mesh_slopes gradient_slopes(const struct glint_mesh_vertex *a,
                                                                                      const struct glint_mesh_vertex *b,
                                                                                      const struct glint_mesh_vertex *c,
                                                                                      int32_t area)
{
    const int32_t x1 = b->x - a->x, y1 = b->y - a->y, x2 = c->x - a->x, y2 = c->y - a->y;
    const uint32_t size = area < 0 ? 0 - (uint32_t)area : (uint32_t)area;
    const unsigned left = glint_mesh_zeros(size);
    const int32_t inverse = (int32_t)glint_mesh_inverse(size << left >> 4), one = area < 0 ? -inverse : inverse;
    const int32_t ux = y2 * one, uy = -x2 * one, vx = -y1 * one, vy = x1 * one; /* <= (2^15 - 2) 2^16 < 2^31 */
    const uint32_t most = glint_mesh_size(ux) | glint_mesh_size(uy) | glint_mesh_size(vx) | glint_mesh_size(vy);
    /* Room to round up. 17 bits or more: where no side is above 1, the inverse is 2^16. */
    const unsigned down = glint_mesh_bits(most + (most >> 14)) - 15;
    const int32_t half = (int32_t)1 << (down - 1);
    struct glint_mesh_slopes s = {
        (ux + half) >> down,       (uy + half) >> down, (vx + half) >> down, (vy + half) >> down, 0, 0,
        43 - (int)left - (int)down}; /* 16 / size = inverse 2^(left - 43) */
    /* -8..8 and 0..15 sixteenths of a pixel: < 2^15 (8 + 15) / 32 */
    const int32_t fx = 8 - (a->x & 15), fy = 16 * ((a->y + 7) >> 4) + 8 - a->y;
    s.u = (s.ux * fx + s.uy * fy + 16) >> 5;
    s.v = (s.vx * fx + s.vy * fy + 16) >> 5;
    return s;
}

/* ---- What is linear, for numbers that are not in glint_mesh_values ---- */

void glint_mesh_slopes_set(struct glint_mesh_slopes *slopes, const struct glint_mesh_vertex *a,
                           const struct glint_mesh_vertex *b, const struct glint_mesh_vertex *c)
{
    *slopes = gradient_slopes(a, b, c, glint_mesh_area(a, b, c));
}

#if !GLINT_CORTEX_M0PLUS_ASM
/* t and its steps, from half the squares of the sides, Q29: P.P / 2, Q.Q / 2, R.R / 2 <= 2^29, R = Q - P. */
static void values_t(struct glint_mesh_values *values, const struct glint_mesh_corner *const corner[3],
                     const struct glint_mesh_slopes *s)
{
    const uint32_t pp = corner[2]->side, qq = corner[1]->side, rr = corner[0]->side;
    const uint32_t t = corner[0]->v->t_q30, t0 = t / 2, t1 = corner[1]->v->t_q30 / 2, t2 = corner[2]->v->t_q30 / 2;
    const int32_t p2 = 2 * (int32_t)pp, q2 = 2 * (int32_t)qq, pq = (int32_t)(pp + qq - rr); /* |.| <= 2^30 */
    const int32_t dp = (int32_t)(t1 - t0 - pp), dq = (int32_t)(t2 - t0 - qq);               /* D.P at the corner, D.Q */
    /* P.P, Q.Q, P.Q of 15 bits, with one shift. */
    const unsigned bits = glint_mesh_bits((uint32_t)p2 | (uint32_t)q2 | glint_mesh_size(pq)),
                   down = bits > 15 ? bits - 15 : 0;
    const struct glint_mesh_pair to_p = {p2 >> down, pq >> down, down}, to_q = {pq >> down, q2 >> down, down};
    /* At the pixel. What t gains on the way is u, v times the mean of D.P, D.Q at both. */
    const int32_t dp_here = (int32_t)((uint32_t)dp + glint_mesh_sum(to_p, s->u, s->v, s->e - 1, 0));
    const int32_t dq_here = (int32_t)((uint32_t)dq + glint_mesh_sum(to_q, s->u, s->v, s->e - 1, 0));
    const struct glint_mesh_pair mean = glint_mesh_pair_of((dp >> 1) + (dp_here >> 1), (dq >> 1) + (dq_here >> 1));
    values->t = t + glint_mesh_sum(mean, s->u, s->v, s->e - 1, 1);
    /* The change a pixel of D.P, D.Q: P.Nx and so on, times 2^(e - down); cut once more. */
    const struct glint_mesh_pair x =
        glint_mesh_pair_of(to_p.p * s->ux + to_p.q * s->vx, to_q.p * s->ux + to_q.q * s->vx);
    const struct glint_mesh_pair y =
        glint_mesh_pair_of(to_p.p * s->uy + to_p.q * s->vy, to_q.p * s->uy + to_q.q * s->vy);
    const int e = 2 * s->e - (int)down;
    values->txx = glint_mesh_sum(x, s->ux, s->vx, e, 1);
    values->txy = glint_mesh_sum(x, s->uy, s->vy, e, 1);
    values->tyy = glint_mesh_sum(y, s->uy, s->vy, e, 1);
    const struct glint_mesh_pair d = glint_mesh_pair_of(dp_here, dq_here);
    values->tx = glint_mesh_sum(d, s->ux, s->vx, s->e, 1) + values->txx / 2;
    values->ty = glint_mesh_sum(d, s->uy, s->vy, s->e, 1) + values->tyy / 2;
}

/* One light for all of it. */
static void values_flat(struct glint_mesh_values *values, const struct glint_mesh_vertex *a,
                        const struct glint_mesh_vertex *b, const struct glint_mesh_vertex *c)
{
    values->t = a->t_q30 / 4 + b->t_q30 / 2 + c->t_q30 / 4;
    values->nl = (uint32_t)((a->nl_q30 >> 2) + (b->nl_q30 >> 1) + (c->nl_q30 >> 2));
    values->nlx = values->nly = 0;
}

/* What is linear, in units of 2^-17 of p and q; these are -2^15..2^15, so that a sum of two products with slopes is below 2^31. */
struct linear {
    uint32_t at, x, y;
};
static inline struct linear values_linear(const struct glint_mesh_slopes *s, int32_t p, int32_t q)
{
    const int up = s->e < 18 ? 18 - s->e : 0, down = s->e > 17 ? s->e - 17 : 0; /* 12 <= e <= 42 */
    const struct linear linear = {(uint32_t)((p * s->u + q * s->v) >> (down ? down - 1 : 0)) << up,
                                  (uint32_t)((p * s->ux + q * s->vx) >> down) << (up ? up - 1 : 0),
                                  (uint32_t)((p * s->uy + q * s->vy) >> down) << (up ? up - 1 : 0)};
    return linear;
}

/* Is t at a corner beyond t_end by the square of its side, Q30? */
static inline bool t_is_beyond(const struct glint_mesh_corner *corner, uint32_t side, uint32_t t_end)
{
    return (int32_t)(corner->v->t_q30 - 2 * side - t_end) > 0;
}

/* Is t beyond t_end all over? It dips between corners by two thirds of the greatest side at most. And as it is a square, it is nowhere below the plane
 * that touches it at the corner where it is least, and that plane is at the others below t by the squares of the sides to them: where u and v
 * change so little that an eighth of a side is more than what t may be off by, but in large triangles, whose exact t stays beyond, too. */
static bool t_stays_beyond(const struct glint_mesh_corner *const corner[3], int e, uint32_t t_end)
{
    const uint32_t t0 = corner[0]->v->t_q30, t1 = corner[1]->v->t_q30, t2 = corner[2]->v->t_q30;
    const uint32_t pp = corner[2]->side, qq = corner[1]->side, rr = corner[0]->side;
    const uint32_t beyond = gradient_beyond(corner[0]->v, corner[1]->v, corner[2]->v, t_end);
    uint32_t most = pp > qq ? pp : qq;
    most = most > rr ? most : rr;
    if (beyond > most)
        return true;
    most >>= GLINT_MESH_MARGIN_LOG;
    if ((int32_t)(beyond - most) <= 0 || e < GLINT_MESH_GENTLE)
        return false;
    t_end += most;
    if (t0 <= t1 && t0 <= t2)
        return t_is_beyond(corner[1], pp, t_end) && t_is_beyond(corner[2], qq, t_end);
    if (t1 <= t2)
        return t_is_beyond(corner[0], pp, t_end) && t_is_beyond(corner[2], rr, t_end);
    return t_is_beyond(corner[0], qq, t_end) && t_is_beyond(corner[1], rr, t_end);
}

enum glint_mesh_shine glint_mesh_values_set(struct glint_mesh_values *values,
                                            const struct glint_mesh_corner *const corner[3], int32_t area,
                                            enum glint_mesh_shine shine, uint32_t t_end)
{
    const struct glint_mesh_vertex *a = corner[0]->v, *b = corner[1]->v, *c = corner[2]->v;
    const struct glint_mesh_slopes s = gradient_slopes(a, b, c, area);
    /* Where u or v change by 8 a pixel or more, a value beyond the corners' might be met. */
    const bool is_steep = s.e < GLINT_MESH_STEEP;
    bool is_flat = is_steep;
    values->x = a->x >> 4;
    if (shine == GLINT_MESH_GLOSSY) {
        const uint32_t square = (uint32_t)1 << 29;                                            /* 90 degrees */
        if (corner[0]->side > square || corner[1]->side > square || corner[2]->side > square) /* would overflow */
            is_flat = true;
        else if (t_stays_beyond(corner, s.e, t_end))
            shine = GLINT_MESH_MATT;
    }
    values->tx = values->ty = values->txx = values->txy = values->tyy = 0;
    /* The depth does not depend on the normals: each path and material hides the same. */
    if (is_steep) {
        values->z = ((uint32_t)a->z + b->z + c->z) * 21845u; /* 65535 / 3 */
        values->zx = values->zy = 0;
    } else {
        const struct linear z = values_linear(&s, ((int32_t)b->z - a->z + 1) >> 1, ((int32_t)c->z - a->z + 1) >> 1);
        values->z = ((uint32_t)a->z << 16) + z.at;
        values->zx = z.x;
        values->zy = z.y;
    }
    if (is_flat) {
        values_flat(values, a, b, c);
    } else {
        if (shine == GLINT_MESH_GLOSSY)
            values_t(values, corner, &s);
        if (shine != GLINT_MESH_DARK) { /* Q13, to nearest */
            const int32_t nl = (a->nl_q30 >> 2) - (1 << 14);
            const struct linear l = values_linear(&s, ((b->nl_q30 >> 2) - nl) >> 15, ((c->nl_q30 >> 2) - nl) >> 15);
            values->nl = (uint32_t)a->nl_q30 + l.at;
            values->nlx = l.x;
            values->nly = l.y;
        }
    }
    if (shine == GLINT_MESH_DARK) {
        values->nl = UINT32_MAX;
        values->nlx = values->nly = 0;
    }
    if (shine != GLINT_MESH_GLOSSY)
        values->t = GLINT_MESH_FAR_T;
    return shine;
}
#endif

/* A pixel belongs to a triangle if its middle does; a middle on an edge, to the triangle right of it or below. Each edge is stepped
 * from its upper corner on, so that the two triangles beside it see the same columns, whatever rounding does to them. */

#if !GLINT_CORTEX_M0PLUS_ASM
/* The quotient by the inverse of dy: within 2^-16 of it or 2^-16 pixel a line. dx <= 2^15 - 2, so dx 2^16 < 2^31; the middle of the
 * first line is within dy of the corner where there is a line, so |step / 16| times that is at most 2^27. */
static inline struct glint_mesh_edge edge_of(const struct glint_mesh_vertex *a, const struct glint_mesh_vertex *b,
                                             int32_t first, int32_t end)
{
    struct glint_mesh_edge edge = {0, 0};
    if (first >= end)
        return edge;
    const uint32_t dy = (uint32_t)(b->y - a->y); /* 1..2^15 - 2 */
    const unsigned up = glint_mesh_zeros(dy);    /* 17..31 */
    edge.step = (b->x - a->x) * (int32_t)glint_mesh_height_inverse(dy, up) >> (31 - up);
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
    const int32_t y = glint_mesh_first(a->y), middle = glint_mesh_first(b->y), end = glint_mesh_first(d->y);
    triangle->y = (int16_t)y;
    triangle->y_middle = (int16_t)middle;
    triangle->y_end = (int16_t)end;
    if (y >= end)
        return false;
    const int32_t area = glint_mesh_area(a, b, d);
    if (area == 0)
        return false;
    triangle->long_is_left = area > 0; /* the middle corner is right of the long edge */
    triangle->long_edge = edge_of(a, d, y, end);
    triangle->upper = edge_of(a, b, y, middle);
    triangle->lower = edge_of(b, d, middle, end);
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

/* Places for triangles that go on, in a list of free ones. */
void glint_mesh_places(struct glint_mesh_frame *frame)
{
    const uint32_t count = (uint32_t)frame->places * GLINT_MESH_KEPT_BYTES / frame->kept_bytes;
    frame->free = (uint16_t)(count ? 0 : GLINT_MESH_NONE);
    for (uint16_t i = 0; i < count; i++)
        glint_mesh_kept_at(frame, i)->next = (uint16_t)(i + 1u < count ? i + 1u : GLINT_MESH_NONE);
}
