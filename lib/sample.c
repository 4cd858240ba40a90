/* SPDX-License-Identifier: MIT
 * Samples of normals and of spans: steps 1 and 2 (sequence.md); normals, packed. */
#include "glint_sample.h"
#include "glint_math.h"

/* In 32 bits N.L fits, as L has length 1. Differences of coordinates are below 2^16, so their squares fit; a sum that does not is a t
 * beyond every lobe, as is any where nl is 0. */
void glint_samples_half(const struct glint_vec *l_of, const struct glint_vec *v, const struct glint_vec *h_of,
                        const struct glint_vec *normal, struct glint_sample *sample, unsigned count)
{
    const struct glint_vec l = *l_of, h = *h_of;
    (void)v;
    const struct glint_sample *end = sample + count;
    do {
        const int32_t x = normal->x, y = normal->y, z = normal->z;
        int32_t nl = (((x * l.x + y * l.y + z * l.z) >> 13) + 1) >> 1;
        uint32_t t = UINT32_MAX;
        if (nl <= 0) {
            nl = 0;
        } else {
            const int32_t dx = x - h.x, dy = y - h.y, dz = z - h.z;
            const uint32_t xx = (uint32_t)dx * (uint32_t)dx, yy = (uint32_t)dy * (uint32_t)dy;
            const uint32_t zz = (uint32_t)dz * (uint32_t)dz, xy = xx + yy, sum = xy + zz;
            if (xy >= xx && sum >= zz)
                t = sum >> 1;
            nl = nl < 65536 ? nl : 65536;
        }
        sample->t_q30 = t;
        sample->nl_q16 = (uint32_t)nl;
        normal++;
    } while (++sample != end);
}

void glint_samples_walk(struct glint_span *at, struct glint_sample *sample, unsigned count)
{
    const struct glint_sample *end = sample + count;
    uint32_t t = at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30;
    do {
        const uint32_t nl_q16 = glint_sample_nl((int32_t)nl);
        sample->nl_q16 = nl_q16;
        sample->t_q30 = nl_q16 == 0 ? UINT32_MAX : t >= GLINT_NEGATIVE_T ? 0 : t;
        t += dt;
        dt += at->ddt_q30;
        nl += (uint32_t)at->dnl_q30;
    } while (++sample != end);
    at->t_q30 = t;
    at->dt_q30 = dt;
    at->nl_q30 = (int32_t)nl;
}

void glint_raws_walk(struct glint_span *at, uint32_t t_max, struct glint_raw *raw, unsigned count)
{
    uint32_t t = at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30;
    for (const struct glint_raw *end = raw + count; raw != end; raw++) {
        *raw = glint_raw_at(t, (int32_t)nl, t_max);
        t += dt;
        dt += at->ddt_q30;
        nl += (uint32_t)at->dnl_q30;
    }
    at->t_q30 = t;
    at->dt_q30 = dt;
    at->nl_q30 = (int32_t)nl;
}

/* t is quadratic in the pixel's number: n (n - 1) / 2 of ddt. n <= 65535. */
void glint_span_skip(struct glint_span *at, uint32_t n)
{
    const uint32_t pairs = n & 1 ? n * (n >> 1) : (n >> 1) * (n - 1);
    at->t_q30 += n * at->dt_q30 + pairs * at->ddt_q30;
    at->dt_q30 += n * at->ddt_q30;
    at->nl_q30 = (int32_t)((uint32_t)at->nl_q30 + n * (uint32_t)at->dnl_q30);
}

/* ---- A span from two normals: with N(k) = N0 + k s and D0 = N0 - H, t(k) = |N(k) - H|^2 / 2 = t0 + k (D0.s) + k^2 |s|^2 / 2 ---- */

static __attribute__((noinline)) int64_t span_divide(int64_t a, int64_t b) /* to nearest; b > 0 */
{
    return (a < 0 ? a - b / 2 : a + b / 2) / b;
}

/* |a - b|^2 in Q2.30, < 2^34. */
static __attribute__((noinline)) int64_t span_distance(const struct glint_vec *a, const struct glint_vec *b)
{
    const int64_t x = a->x - (int32_t)b->x, y = a->y - (int32_t)b->y, z = a->z - (int32_t)b->z;
    return x * x + y * y + z * z;
}

/* a.b in Q2.30; in magnitude at most 3 * 2^30. */
static __attribute__((noinline)) int64_t span_dot(const struct glint_vec *a, const struct glint_vec *b)
{
    return (int64_t)((int32_t)a->x * b->x) + (int32_t)a->y * b->y + (int32_t)a->z * b->z;
}

enum glint_err glint_span_init(struct glint_span *span, const struct glint_paint *paint, const struct glint_vec *first,
                               const struct glint_vec *last, uint16_t w)
{
    if (!span || !first || !last || w > GLINT_SPAN_MAX || !glint_paint_is_lit(paint) || paint->several)
        return GLINT_ERR_ARG;
    const struct glint_vec *const h = &paint->h, *const l = &paint->l;
    const int64_t t0 = span_distance(first, h) >> 1, t1 = span_distance(last, h) >> 1;
    const int64_t nl0 = span_dot(first, l), nl1 = span_dot(last, l), limit = INT32_MAX - (1 << 13);
    /* t is convex, nl linear: the ends bound them, but for the rounding of the steps, < w^2 / 16 + w <= 2^21. t's are (3^0.5 + 1)^2 / 2 < 3.74
     * at most, since H is a unit */
    if (nl0 > limit || nl0 < -limit || nl1 > limit || nl1 < -limit)
        return GLINT_ERR_VECTOR;
    const int64_t m = w > 1 ? w - 1 : 1;
    const int64_t ddt = span_divide(span_distance(last, first), m * m);
    span->ddt_q30 = (uint32_t)ddt;
    span->dt_q30 = (uint32_t)span_divide(t1 - t0 - ddt * (m * (m - 1) / 2), m); /* so that the last pixel is right */
    span->t_q30 = (uint32_t)t0;
    span->nl_q30 = (int32_t)nl0;
    span->dnl_q30 = (int32_t)span_divide(nl1 - nl0, m);
    span->w = w;
    span->ends[0][0] = first->x, span->ends[0][1] = first->y;
    span->ends[1][0] = last->x, span->ends[1][1] = last->y;
    return GLINT_OK;
}

/* Normals, packed. What is lost is x and y's precision; z is chosen so that the length, and with it t, stays right. */

static uint32_t nearest_root(uint32_t square)
{
    const uint32_t floor = glint_root(square);
    return floor + (square - floor * floor > floor);
}

static int32_t nearest(int32_t value)
{
    const int32_t rounded = (value + 128) >> 8;
    return rounded > 127 ? 127 : rounded < -127 ? -127 : rounded;
}

/* |z| at least 1, so that no normal reads as no surface. */
uint32_t glint_normals_pack(enum glint_normals format, const struct glint_vec *normal)
{
    if (!normal || !(normal->x | normal->y | normal->z) || format != GLINT_NORMALS_INT8)
        return 0;
    const int32_t x = nearest(normal->x), y = nearest(normal->y);
    const int32_t rest = ((int32_t)1 << 30) - 65536 * (x * x) - 65536 * (y * y); /* >= -2^30 */
    int32_t z = rest > 0 ? (int32_t)nearest_root((uint32_t)rest) : 0;
    z = z < 1 ? 1 : z > 32767 ? 32767 : z;
    z = normal->z < 0 ? -z : z;
    return (uint32_t)z << 16 | ((uint32_t)(256 * y + x) & 0xffff);
}

struct glint_vec glint_normals_unpack(enum glint_normals format, uint32_t word)
{
    const struct glint_vec none = {0, 0, 0};
    return format == GLINT_NORMALS_INT8 && word >> 16 ? glint_int8_normal(word) : none;
}

/* 2^(5 code / 128) but for .3 %: between powers of two a parabola, (2 f + 1.05 f^2 ..) */
uint32_t glint_shininess_n(uint8_t code)
{
    const uint32_t octave = 5u * code >> 7, f = 5u * code & 127;
    const uint32_t mantissa = 16384 + (f * (21504 + 88 * f) >> 8); /* Q14; 32768 at f = 128 */
    return ((mantissa >> (13 - octave)) + 1) >> 1;
}

uint8_t glint_shininess_code(uint32_t n)
{
    uint32_t code = 0; /* the largest whose n is no larger */
    for (uint32_t bit = 128; bit; bit >>= 1)
        if (glint_shininess_n((uint8_t)(code + bit)) <= n)
            code += bit;
    const uint32_t below = glint_shininess_n((uint8_t)code);
    if (code < 255 && n > below && glint_shininess_n((uint8_t)(code + 1)) - n < n - below)
        code++;
    return (uint8_t)code;
}

const void *glint_normals_window(enum glint_normals format, const void *map, ptrdiff_t stride, uint32_t x, uint32_t y)
{
    return (const uint8_t *)map + stride * (ptrdiff_t)y + glint_normals_size((uint8_t)format) * x;
}
