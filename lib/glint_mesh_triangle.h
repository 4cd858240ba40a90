/* SPDX-License-Identifier: MIT
 * Internal. A triangle: which pixels it covers, and what changes linearly or quadratically over it, as steps from pixel to pixel and line to
 * line. */
#ifndef GLINT_MESH_TRIANGLE_H
#define GLINT_MESH_TRIANGLE_H

#include "glint_mesh.h"
#include "glint_offsets.h"
#include "glint_port.h"

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

/* 2^43 / m to nearest, nearly: 2^15..2^16, for m = 2^27..2^28 - 1 of which the lower bits may be cut. */
uint32_t glint_mesh_inverse(uint32_t m);

#define GLINT_MESH_QUOTIENT(dy, up) (((UINT32_C(1) << (47 - (up))) + (dy) / 2) / (dy))

/* Zero bits above the highest of x, which is not 0. */
static inline unsigned glint_mesh_zeros(uint32_t x)
{
    return (unsigned)(sizeof(int) >= sizeof x ? __builtin_clz((unsigned)x) : __builtin_clzl(x));
}

/* 2^(47 - up) / dy to nearest, nearly, of a height 0 < dy < 2^15 with so many zero bits above. Where there is a divider, by it below 2^13: there both
 * are equal (tests/unit/lib/test_mesh_values.c). */
static inline uint32_t glint_mesh_height_inverse(uint32_t dy, unsigned up)
{
    return GLINT_THUMB2 && up >= 19 ? GLINT_MESH_QUOTIENT(dy, up) : glint_mesh_inverse(dy << up >> 4);
}

/* What is linear over a triangle, from corner a on: how u and v, the places in it, change a pixel, times 2^e; and, times 2^(e - 1), from the
 * corner to the middle of pixel a.x >> 4 in the first line whose middle is at or below it. The triangle has an area. */
struct glint_mesh_slopes {
    int32_t ux, uy, vx, vy, u, v; /* < 2^15 */
    int e;
};
void glint_mesh_slopes_set(struct glint_mesh_slopes *slopes, const struct glint_mesh_vertex *a,
                           const struct glint_mesh_vertex *b, const struct glint_mesh_vertex *c);

/* Two differences, to corners b and c, cut to 15 bits and a sign: p 2^shift, q 2^shift. */
struct glint_mesh_pair {
    int32_t p, q;
    unsigned shift;
};
/* ---- Numbers of 15 bits ---- */

/* Bits of x, 0 for 0. */
static inline unsigned glint_mesh_bits(uint32_t x)
{
    return x ? 32u - glint_mesh_zeros(x) : 0;
}

/* |x| or one less. */
static inline uint32_t glint_mesh_size(int32_t x)
{
    return (uint32_t)(x ^ (x >> 31));
}

/* r 2^-down to nearest, modulo 2^32. */
static inline uint32_t glint_mesh_shift(int32_t r, int down)
{
#if GLINT_THUMB2 /* shifts by more than 31 are defined */
    if (down <= 0)
        __asm__("lsl %0, %0, %1" : "+r"(r) : "r"(-down));
    else
        __asm__("asr %0, %0, %1" : "+r"(r) : "r"(down - 1));
    return (uint32_t)(down <= 0 ? r : (r + 1) >> 1);
#endif
    if (down <= 0)
        return down > -32 ? (uint32_t)r << -down : 0;
    if (down > 31)
        return 0;
    return (uint32_t)(((r >> (down - 1)) + 1) >> 1); /* |r| < 2^31 - 1, or down > 1 */
}

/* A pair that is multiplied by others, each of 15 bits. */
static inline struct glint_mesh_pair glint_mesh_pair_of(int32_t p, int32_t q)
{
    const unsigned bits = glint_mesh_bits(glint_mesh_size(p) | glint_mesh_size(q)), shift = bits > 15 ? bits - 15 : 0;
    const struct glint_mesh_pair pair = {p >> shift, q >> shift, shift};
    return pair;
}

/* p u + q v, where u and v have e fraction bits, times 2^up: p, q from -2^15 to 2^15 - 1, u, v below 2^15. */
static inline uint32_t glint_mesh_sum(struct glint_mesh_pair pair, int32_t u, int32_t v, int e, int up)
{
    return glint_mesh_shift(pair.p * u + pair.q * v, e - (int)pair.shift - up);
}

/* What they add to the number at a, at that pixel, and a pixel to the right or down; times 2^up, modulo 2^32. */
struct glint_mesh_linear {
    uint32_t at, x, y;
};
static inline void glint_mesh_linear_set(struct glint_mesh_linear *linear, const struct glint_mesh_slopes *s,
                                         struct glint_mesh_pair pair, int up)
{
    if (s->e < GLINT_MESH_STEEP) { /* one for all of it: of the corners the mean, with the second one counted twice */
        const int32_t sum = 2 * pair.p + pair.q;
        linear->at = (uint32_t)sum << ((up + (int)pair.shift - 2) & 31); /* it is negative where the sum is 0 */
        linear->x = linear->y = 0;
        return;
    }
    linear->at = glint_mesh_sum(pair, s->u, s->v, s->e - 1, up);
    linear->x = glint_mesh_sum(pair, s->ux, s->vx, s->e, up);
    linear->y = glint_mesh_sum(pair, s->uy, s->vy, s->e, up);
}

/* Which pixels a triangle covers, and their values line by line. */

/* Lines y..y_end - 1 from the first corner down; up to y_middle its short edge is the upper one. */
struct glint_mesh_edge {
    int32_t x, step; /* Q16.16: the first column whose middle is at or beyond the edge, and a line */
};
struct glint_mesh_triangle {
    struct glint_mesh_values values; /* at line y */
    struct glint_mesh_edge long_edge, upper, lower;
    int16_t y, y_middle, y_end;
    uint8_t shine; /* enum glint_mesh_shine; and GLINT_MESH_LAID */
    bool long_is_left;
};

/* What a triangle, kept from strip to strip, has of its texture or of colours of vertices: u and v, or red and green, at its line, in the column
 * of its values, and their steps. */
#define GLINT_MESH_LAID 4 /* of shine: it has it */
#define GLINT_MESH_LAID_DOWN 2u
#define GLINT_MESH_LAID_RIGHT 4u
#define GLINT_MESH_LAID_BLUE 6u
struct glint_mesh_laid {
    /* Two there, two down, two right; blue's three, or of a texture in bytes how much of the chain is passed, and the picture's w + 2^16 h. */
    uint32_t of[9];
    uint32_t more; /* of assembly, which has slopes here at first */
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
