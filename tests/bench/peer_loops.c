/* SPDX-License-Identifier: MIT
 * Whole pixels as a firmware engineer writes them today: vectors in Q15 or int8, no division, a power by squaring or from a
 * table, a multiplication a channel, clamped, cut to RGB565; and the same in float. Beside the sphere nothing is drawn. */
#include "loops.h"
#include "peers.h"

/* ---- what all of them share ---- */

struct colour {
    int32_t ambient, diffuse, specular; /* 0..255 */
};

static struct colour colour_of(int k)
{
    const struct glint_material *m = &bench_material;
    const struct colour c = {(int32_t)(m->ambient_q16[k] >> 8), (int32_t)(m->diffuse_q16[k] >> 8),
                             (int32_t)(m->specular_q16[k] >> 8)};
    return c;
}

static inline int32_t clamp(int32_t value)
{
    return value > 255 ? 255 : value;
}

static inline uint16_t pack565(int32_t r, int32_t g, int32_t b)
{
    return (uint16_t)((r >> 3) << 11 | (g >> 2) << 5 | b >> 3);
}

/* nl and f in Q15. */
static inline uint16_t shade_q15(const struct colour c[3], int32_t nl, int32_t f)
{
    int32_t rgb[3];
    for (int k = 0; k < 3; k++)
        rgb[k] = clamp(c[k].ambient + ((c[k].diffuse * nl + c[k].specular * f) >> 15));
    return pack565(rgb[0], rgb[1], rgb[2]);
}

static inline int32_t dot_q15(const struct glint_vec *a, const struct glint_vec *b)
{
    const int32_t dot = ((int32_t)a->x * b->x + (int32_t)a->y * b->y + (int32_t)a->z * b->z) >> 15;
    return dot < 0 ? 0 : dot > 32767 ? 32767 : dot;
}

/* A loop over the line, its highlight in Q15 given by f. */
#define INTEGER_LOOP(name, f)                                                                                          \
    void name(void)                                                                                                    \
    {                                                                                                                  \
        const struct colour c[3] = {colour_of(0), colour_of(1), colour_of(2)};                                         \
        const struct glint_vec l = bench_paint.l, h = bench_paint.h;                                                   \
        uint16_t *out = bench_line.out;                                                                                \
        for (int x = 0; x < SPHERE_W; x++) {                                                                           \
            if (!bench_line.mask[x])                                                                                   \
                continue;                                                                                              \
            const struct glint_vec *normal = &bench_line.normals[x];                                                   \
            const int32_t nl = dot_q15(normal, &l);                                                                    \
            out[x] = shade_q15(c, nl, nl ? f(dot_q15(normal, &h)) : 0);                                                \
        }                                                                                                              \
    }

static inline int32_t power_by_squaring(int32_t nh)
{
    int32_t f = 32767;
    for (uint32_t n = bench_material.n; n; n >>= 1) {
        if (n & 1)
            f = f * nh >> 15;
        nh = nh * nh >> 15;
    }
    return f;
}

void peer_fill(void)
{
    peer_table_fill(bench_material.n);
}

static inline int32_t power_from_table(int32_t nh)
{
    return (int32_t)(peer_table(0, (uint32_t)nh << 1) >> 1);
}

INTEGER_LOOP(peer_integer_power, power_by_squaring)
INTEGER_LOOP(peer_table_power, power_from_table)

/* ---- three bytes a normal, as exported by most tools ---- */

static uint8_t table128[128];

static int8_t (*packed(void))[3]
{
    return (int8_t(*)[3])(void *)bench_memory;
}

void peer_int8_fill(void)
{
    for (uint32_t i = 0; i < 128; i++)
        table128[i] = (uint8_t)((glint_blinn(bench_material.n, (int32_t)(i * GLINT_C_ONE / 127)) * 255) >> 16);
}

static int8_t to_int8(int16_t x)
{
    return (int8_t)((x * 127 + (x < 0 ? -16384 : 16384)) / 32768);
}

void peer_int8_pack(void)
{
    for (int x = 0; x < SPHERE_W; x++) {
        const struct glint_vec *n = &bench_line.normals[x];
        packed()[x][0] = to_int8(n->x);
        packed()[x][1] = to_int8(n->y);
        packed()[x][2] = to_int8(n->z);
    }
}

static inline int32_t dot_q7(const int8_t a[3], const int8_t b[3])
{
    const int32_t dot = (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / 128;
    return dot < 0 ? 0 : dot > 127 ? 127 : dot;
}

void peer_int8_table_power(void)
{
    const struct colour c[3] = {colour_of(0), colour_of(1), colour_of(2)};
    const struct glint_paint *light = &bench_paint;
    const int8_t l[3] = {to_int8(light->l.x), to_int8(light->l.y), to_int8(light->l.z)};
    const int8_t h[3] = {to_int8(light->h.x), to_int8(light->h.y), to_int8(light->h.z)};
    uint16_t *out = bench_line.out;
    for (int x = 0; x < SPHERE_W; x++) {
        if (!bench_line.mask[x])
            continue;
        const int8_t *normal = packed()[x];
        const int32_t nl = dot_q7(normal, l), f = nl ? table128[dot_q7(normal, h)] : 0;
        out[x] = shade_q15(c, nl << 8, f << 7);
    }
}

/* ---- float ---- */

static inline float dot_float(const float a[3], const float b[3])
{
    const float dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return dot < 0 ? 0 : dot > 1 ? 1 : dot;
}

static void to_float(float out[3], const struct glint_vec *v)
{
    out[0] = (float)v->x * (1 / 32768.f);
    out[1] = (float)v->y * (1 / 32768.f);
    out[2] = (float)v->z * (1 / 32768.f);
}

static inline void float_loop(float (*highlight)(float n, float c))
{
    float l[3], h[3], ambient[3], diffuse[3], specular[3];
    to_float(l, &bench_paint.l);
    to_float(h, &bench_paint.h);
    for (int k = 0; k < 3; k++) {
        const struct glint_material *m = &bench_material;
        ambient[k] = (float)m->ambient_q16[k] * (255 / 65536.f);
        diffuse[k] = (float)m->diffuse_q16[k] * (255 / 65536.f);
        specular[k] = (float)m->specular_q16[k] * (255 / 65536.f);
    }
    const float n = bench_material.n;
    uint16_t *out = bench_line.out;
    for (int x = 0; x < SPHERE_W; x++) {
        if (!bench_line.mask[x])
            continue;
        float normal[3];
        to_float(normal, &bench_line.normals[x]);
        const float nl = dot_float(normal, l), f = nl > 0 ? highlight(n, dot_float(normal, h)) : 0;
        int32_t rgb[3];
        for (int k = 0; k < 3; k++)
            rgb[k] = clamp((int32_t)(ambient[k] + diffuse[k] * nl + specular[k] * f));
        out[x] = pack565(rgb[0], rgb[1], rgb[2]);
    }
}

void peer_float_powf(void)
{
    float_loop(peer_blinn_powf);
}

void peer_float_msh(void)
{
    float_loop(peer_msh_float);
}

/* As an expert writes it for a core with an FPU: all scales and rounding in the constants, once a frame; F from 1 - c = t by one division and
 * within the cutoff alone; float to level with saturation. */
static struct {
    float l[3], h[3], base[3], diffuse[3], shine[3], one, slope, least;
} folded;

void peer_float_fold(void)
{
    static const float max[3] = {31, 63, 31};
    const float n = bench_material.n, t = (float)bench_paint.of.exact.t_end * (1 / 1073741824.f);
    to_float(folded.l, &bench_paint.l);
    to_float(folded.h, &bench_paint.h);
    for (int k = 0; k < 3; k++) {
        const struct glint_material *m = &bench_material;
        folded.l[k] *= 1 / 32768.f;
        folded.h[k] *= 1 / 32768.f;
        folded.base[k] = (float)m->ambient_q16[k] * (max[k] / 65536) + .5f;
        folded.diffuse[k] = (float)m->diffuse_q16[k] * (max[k] / 65536);
        folded.shine[k] = (float)m->specular_q16[k] * (1.6f * max[k] / 65536);
    }
    folded.one = n;
    folded.slope = n - 1.25f;
    folded.least = 1 - t;
}

#ifndef __ARM_FEATURE_SAT
static inline uint32_t level_of(float value, int bits)
{
    const int32_t level = (int32_t)value, most = (1 << bits) - 1;
    return (uint32_t)(level > most ? most : level);
}
#define LEVEL_OF(value, bits) level_of(value, bits)
#else
#include <arm_acle.h>
#define LEVEL_OF(value, bits) ((uint32_t)__usat((int32_t)(value), bits))
#endif

void peer_float_folded(void)
{
    const float lx = folded.l[0], ly = folded.l[1], lz = folded.l[2], hx = folded.h[0], hy = folded.h[1],
                hz = folded.h[2];
    const float one = folded.one, slope = folded.slope, least = folded.least;
    const float r0 = folded.base[0], g0 = folded.base[1], b0 = folded.base[2], r1 = folded.diffuse[0],
                g1 = folded.diffuse[1], b1 = folded.diffuse[2], r2 = folded.shine[0], g2 = folded.shine[1],
                b2 = folded.shine[2];
    const struct glint_vec *normal = bench_line.normals;
    uint16_t *out = bench_line.out;
    for (int x = 0; x < SPHERE_W; x++, normal++) {
        if (!bench_line.mask[x])
            continue;
        const float nx = normal->x, ny = normal->y, nz = normal->z, nl = nx * lx + ny * ly + nz * lz;
        float r = r0, g = g0, b = b0;
        if (nl > 0) {
            r += r1 * nl;
            g += g1 * nl;
            b += b1 * nl;
            const float c = nx * hx + ny * hy + nz * hz;
            if (c > least) {
                const float d = one - slope * c, f = c / (d * d);
                r += r2 * f;
                g += g2 * f;
                b += b2 * f;
            }
        }
        out[x] = (uint16_t)(LEVEL_OF(r, 5) << 11 | LEVEL_OF(g, 6) << 5 | LEVEL_OF(b, 5));
    }
}
