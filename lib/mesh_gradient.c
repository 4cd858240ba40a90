/* SPDX-License-Identifier: MIT
 * With P and Q the differences of the normals along two sides, and u, v the place in the triangle in these units, N = N0 + u P + v Q.
 * So t = |N - H|^2 / 2 needs no vector: D.P and D.Q, D = N - H, follow from the corners' t, and P.P, Q.Q, P.Q from the sides'
 * lengths. u and v change by constants a pixel, held as 15-bit mantissas with one exponent; what they are multiplied by is
 * cut to 15 bits, too, so that a sum of two products fits 32 bits. */
#include "glint_mesh_gradient.h"

/* Bits of x, 0 for 0. */
static unsigned gradient_bits(uint32_t x)
{
    unsigned bits = 0;
    for (unsigned step = 16; step; step >>= 1)
        if (x >> step) {
            x >>= step;
            bits += step;
        }
    return bits + (x != 0);
}

static uint32_t gradient_size(int32_t x)
{
    return x < 0 ? 0 - (uint32_t)x : (uint32_t)x;
}

/* r 2^-down to nearest, modulo 2^32. */
static uint32_t gradient_shift(int32_t r, int down)
{
    if (down <= 0)
        return down > -32 ? (uint32_t)r << -down : 0;
    if (down > 31)
        return 0;
    return (uint32_t)(((r >> (down - 1)) + 1) >> 1); /* |r| < 2^31 - 1, or down > 1 */
}

/* A pair that is multiplied by others, each of 15 bits: p 2^shift, q 2^shift. */
struct pair {
    int32_t p, q;
    unsigned shift;
};

static struct pair gradient_pair(int32_t p, int32_t q)
{
    const unsigned bits = gradient_bits(gradient_size(p) | gradient_size(q)), shift = bits > 15 ? bits - 15 : 0;
    const struct pair pair = {p >> shift, q >> shift, shift};
    return pair;
}

/* p u + q v, where u and v have e fraction bits, times 2^up: p, q of 15 bits and a sign, u, v below 2^15. */
static uint32_t gradient_sum(struct pair pair, int32_t u, int32_t v, int e, int up)
{
    return gradient_shift(pair.p * u + pair.q * v, e - (int)pair.shift - up);
}

/* |a - b|^2 / 2 in Q29, < 2^32. */
static uint32_t gradient_distance(struct glint_vec a, struct glint_vec b)
{
    const int32_t x = (int32_t)a.x - b.x, y = (int32_t)a.y - b.y, z = (int32_t)a.z - b.z;
    return ((uint32_t)x * (uint32_t)x >> 2) + ((uint32_t)y * (uint32_t)y >> 2) + ((uint32_t)z * (uint32_t)z >> 2);
}

/* One value for all of it. */
static void gradient_flat(struct glint_mesh_values *values, const struct glint_mesh_corner *const corner[3])
{
    const struct glint_mesh_vertex *a = &corner[0]->v, *b = &corner[1]->v, *c = &corner[2]->v;
    values->t = a->t_q30 / 4 + b->t_q30 / 2 + c->t_q30 / 4;
    values->nl = (uint32_t)((a->nl_q30 >> 2) + (b->nl_q30 >> 1) + (c->nl_q30 >> 2));
    values->z = ((uint32_t)a->z + b->z + c->z) * 21845u; /* 65535 / 3 */
    values->tx = values->ty = values->txx = values->txy = values->tyy = 0;
    values->nlx = values->nly = values->zx = values->zy = 0;
}

/* How u and v change a pixel, times 2^e; and, times 2^(e - 1), from the upper corner to the pixel. */
struct slopes {
    int32_t ux, uy, vx, vy, u, v; /* < 2^15 */
    int e;
};

static struct slopes gradient_slopes(const struct glint_mesh_corner *const corner[3], int32_t area)
{
    const int32_t x1 = corner[1]->v.x - corner[0]->v.x, y1 = corner[1]->v.y - corner[0]->v.y;
    const int32_t x2 = corner[2]->v.x - corner[0]->v.x, y2 = corner[2]->v.y - corner[0]->v.y;
    const uint32_t size = gradient_size(area);
    const unsigned left = 32 - gradient_bits(size);
    const uint32_t divisor = ((size << left >> 15) + 1) >> 1; /* 2^15..2^16, of size: 2^(16 - left) times it */
    const int32_t inverse = (int32_t)((((uint32_t)1 << 31) + divisor / 2) / divisor),
                  one = area < 0 ? -inverse : inverse;
    int32_t ux = y2 * one, uy = -x2 * one, vx = -y1 * one, vy = x1 * one; /* <= (2^15 - 2) 2^16 < 2^31 */
    const uint32_t most = gradient_size(ux) | gradient_size(uy) | gradient_size(vx) | gradient_size(vy);
    const unsigned bits = gradient_bits(most + (most >> 14)), down = bits > 15 ? bits - 15 : 0; /* room to round up */
    const int32_t half = down ? (int32_t)1 << (down - 1) : 0;
    struct slopes s = {(ux + half) >> down,       (uy + half) >> down, (vx + half) >> down, (vy + half) >> down, 0, 0,
                       43 - (int)left - (int)down}; /* 16 / size = inverse 2^(left - 43) */
    /* -8..8 and 0..15 sixteenths of a pixel: < 2^15 (8 + 15) / 32 */
    const int32_t fx = 16 * (corner[0]->v.x >> 4) + 8 - corner[0]->v.x;
    const int32_t fy = 16 * ((corner[0]->v.y + 7) >> 4) + 8 - corner[0]->v.y;
    s.u = (s.ux * fx + s.uy * fy + 16) >> 5;
    s.v = (s.vx * fx + s.vy * fy + 16) >> 5;
    return s;
}

/* t and its steps, from half the squares of the sides, Q29: P.P / 2, Q.Q / 2, R.R / 2 <= 2^29, R = Q - P. */
static void values_t(struct glint_mesh_values *values, const struct glint_mesh_corner *const corner[3],
                     const struct slopes *s, uint32_t pp, uint32_t qq, uint32_t rr)
{
    const uint32_t t0 = corner[0]->v.t_q30 / 2, t1 = corner[1]->v.t_q30 / 2, t2 = corner[2]->v.t_q30 / 2;
    const int32_t p2 = 2 * (int32_t)pp, q2 = 2 * (int32_t)qq, pq = (int32_t)(pp + qq - rr); /* |.| <= 2^30 */
    const int32_t dp = (int32_t)(t1 - t0 - pp), dq = (int32_t)(t2 - t0 - qq);               /* D.P at the corner, D.Q */
    /* P.P, Q.Q, P.Q of 15 bits, with one shift. */
    const unsigned bits = gradient_bits((uint32_t)p2 | (uint32_t)q2 | gradient_size(pq)),
                   down = bits > 15 ? bits - 15 : 0;
    const struct pair to_p = {p2 >> down, pq >> down, down}, to_q = {pq >> down, q2 >> down, down};
    /* At the pixel. What t gains on the way is u, v times the mean of D.P, D.Q at both. */
    const int32_t dp_here = (int32_t)((uint32_t)dp + gradient_sum(to_p, s->u, s->v, s->e - 1, 0));
    const int32_t dq_here = (int32_t)((uint32_t)dq + gradient_sum(to_q, s->u, s->v, s->e - 1, 0));
    const struct pair mean = gradient_pair((dp >> 1) + (dp_here >> 1), (dq >> 1) + (dq_here >> 1));
    values->t = corner[0]->v.t_q30 + gradient_sum(mean, s->u, s->v, s->e - 1, 1);
    /* The change a pixel of D.P, D.Q: P.Nx and so on, times 2^(e - down); cut once more. */
    const struct pair x = gradient_pair(to_p.p * s->ux + to_p.q * s->vx, to_q.p * s->ux + to_q.q * s->vx);
    const struct pair y = gradient_pair(to_p.p * s->uy + to_p.q * s->vy, to_q.p * s->uy + to_q.q * s->vy);
    const int e = 2 * s->e - (int)down;
    values->txx = gradient_sum(x, s->ux, s->vx, e, 1);
    values->txy = gradient_sum(x, s->uy, s->vy, e, 1);
    values->tyy = gradient_sum(y, s->uy, s->vy, e, 1);
    const struct pair d = gradient_pair(dp_here, dq_here);
    values->tx = gradient_sum(d, s->ux, s->vx, s->e, 1) + values->txx / 2;
    values->ty = gradient_sum(d, s->uy, s->vy, s->e, 1) + values->tyy / 2;
}

void glint_mesh_values_set(struct glint_mesh_values *values, const struct glint_mesh_corner *const corner[3],
                           int32_t area)
{
    const struct glint_mesh_vertex *a = &corner[0]->v, *b = &corner[1]->v, *c = &corner[2]->v;
    const struct glint_vec *na = &corner[0]->normal, *nb = &corner[1]->normal, *nc = &corner[2]->normal;
    values->x = a->x >> 4;
    const uint32_t pp = gradient_distance(*nb, *na), qq = gradient_distance(*nc, *na);
    const uint32_t rr = gradient_distance(*nc, *nb), square = (uint32_t)1 << 29; /* 90 degrees */
    const struct slopes s = gradient_slopes(corner, area);
    /* Where u or v change by 8 a pixel or more, a value beyond the corners' might be met; normals over 90 degrees apart would
     * overflow. */
    if (s.e < 12 || pp > square || qq > square || rr > square) {
        gradient_flat(values, corner);
        return;
    }
    values_t(values, corner, &s, pp, qq, rr);
    const struct pair nl = gradient_pair((b->nl_q30 >> 2) - (a->nl_q30 >> 2), (c->nl_q30 >> 2) - (a->nl_q30 >> 2));
    values->nlx = gradient_sum(nl, s.ux, s.vx, s.e, 2);
    values->nly = gradient_sum(nl, s.uy, s.vy, s.e, 2);
    values->nl = (uint32_t)a->nl_q30 + gradient_sum(nl, s.u, s.v, s.e - 1, 2);
    const struct pair z = gradient_pair(((int32_t)b->z - a->z) * 4096, ((int32_t)c->z - a->z) * 4096);
    values->zx = gradient_sum(z, s.ux, s.vx, s.e, 4);
    values->zy = gradient_sum(z, s.uy, s.vy, s.e, 4);
    values->z = ((uint32_t)a->z << 16) + gradient_sum(z, s.u, s.v, s.e - 1, 4);
}
