/* SPDX-License-Identifier: MIT
 * The assembly of lib/fused_dsp.c, pixel by pixel, in C for the host: the few instructions that it uses, and the steps in their order. */
#include <string.h>

#include "glint_fused.h"

static int32_t low_of(uint32_t a)
{
    return (int16_t)a;
}
static int32_t high_of(uint32_t a)
{
    return (int16_t)(a >> 16);
}
static uint32_t smlad(uint32_t a, uint32_t b, uint32_t c)
{
    return (uint32_t)(low_of(a) * low_of(b)) + (uint32_t)(high_of(a) * high_of(b)) + c;
}
static uint32_t smlabb(uint32_t a, uint32_t b, uint32_t c)
{
    return (uint32_t)(low_of(a) * low_of(b)) + c;
}
static uint32_t saturated_16(int32_t a)
{
    return (uint16_t)(a > 32767 ? 32767 : a < -32768 ? -32768 : a);
}
static uint32_t qsub16(uint32_t a, uint32_t b)
{
    return saturated_16(low_of(a) - low_of(b)) | saturated_16(high_of(a) - high_of(b)) << 16;
}
static uint32_t smmlar(uint32_t a, uint32_t b, uint32_t c)
{
    return (uint32_t)(((uint64_t)((int64_t)(int32_t)a * (int32_t)b) + ((uint64_t)c << 32) + 0x80000000u) >> 32);
}
static uint32_t smmlsr(uint32_t a, uint32_t b, uint32_t c)
{
    return (uint32_t)((((uint64_t)c << 32) - (uint64_t)((int64_t)(int32_t)a * (int32_t)b) + 0x80000000u) >> 32);
}
static uint32_t usat(uint32_t v, int bits, int down)
{
    const int32_t x = (int32_t)v >> down, most = (1 << bits) - 1;
    return x < 0 ? 0 : x > most ? (uint32_t)most : (uint32_t)x;
}
static bool carries(uint32_t w, uint32_t fraction)
{
    return w + fraction < w;
}

enum format { NATIVE, SWAPPED, THREE, DITHERED, DITHERED_SWAPPED, ALBEDO, ALBEDO_SWAPPED };
enum model { MSH, SCHLICK, GGX, CAYLEY };

/* false: it is open. */
static bool model_pixel(struct glint_line_loop *loop, const struct glint_vec *n, uint8_t *out, bool wide,
                        enum format format, enum model model)
{
    const uint32_t xy = (uint16_t)n->x | (uint32_t)n->y << 16, z = (uint16_t)n->z, *turn = loop->turn;
    const uint32_t s = smlabb(z, turn[1], smlad(xy, turn[0], turn[3]));
    const bool has_albedo = format >= ALBEDO;
    uint32_t t, v[3], pixel = loop->dark, w, w_green;
    const unsigned at_4 = (uintptr_t)out >> 1 & 3;
    if (has_albedo && s >= 0x40000000 && s <= INT32_MAX)
        return false;
    if (!has_albedo && s >= 0x40000000) {
        pixel = format >= DITHERED ? loop->dark_of[at_4] : pixel;
        memcpy(out, &pixel, format == THREE ? 3 : 2);
        return (int32_t)s < 0;
    }
    if (wide) {
        const uint32_t nh = smlabb(z, turn[5], smlad(xy, turn[4], loop->nh));
        t = (uint32_t)((int32_t)smlabb(z, z, smlad(xy, xy, loop->hh)) >> 1) - nh;
    } else {
        const uint32_t d = qsub16(xy, turn[4]), e = qsub16(z, turn[5]);
        t = smlabb(e, e, smlad(d, d, 0));
    }
    if (t < loop->t_end && s <= INT32_MAX) {
        uint32_t at = t, over = ~(t << (wide ? 2 : 1));
        if (model == GGX) {
            const uint32_t c = 0x40000000 - t;
            at = wide ? smmlar(c, c, 0) << 2 : smmlsr(t, t, t) << loop->up;
            over = UINT32_MAX;
        } else if (model == MSH && !wide) {
            at <<= loop->up;
        }
        uint32_t f;
        if (model == CAYLEY) {
            const uint32_t x = smmlar((uint32_t)loop->v[0], wide ? t : t << loop->up, 0);
            const uint32_t r = (over - (x << 4)) / ((uint32_t)loop->v[1] + (x >> 12)), square = r * r;
            f = (uint32_t)((uint64_t)square * square >> 48);
        } else {
            const uint32_t root = smmlar((uint32_t)loop->v[0], at, (uint32_t)loop->v[1]);
            f = over / (model == SCHLICK ? root : smmlar(root, root, 0));
        }
        loop->last = out;
        if (has_albedo) {
            for (int k = 0; k < 3; k++)
                v[k] = f * loop->shine[k == 2 ? 5 : k] + loop->shine[2 + k];
            w = w_green = loop->shine[6];
            if (w == UINT32_MAX)
                return false;
            goto lit;
        }
        const uint32_t both = ((f & 0xffff) | (s << 2 & 0xffff0000)) ^ 0x80008000;
        for (int k = 0; k < 3; k++)
            v[k] = smlad(both, loop->shine[k], loop->shine[3 + k]);
        w = loop->shine[6];
        w_green = loop->w_green;
    } else {
        for (int k = 0; k < 3; k++)
            v[k] = (has_albedo ? 0 : loop->plain[k] * (s >> 14)) + loop->plain[3 + k];
        w = w_green = loop->plain[6];
    }
lit:
    for (int k = 0; k < 3 && has_albedo; k++) {
        const uint32_t nl = s > INT32_MAX ? (uint32_t)-16384 : s & ~(uint32_t)16383;
        v[k] += smmlar(loop->lit[2 * k], nl, loop->lit[2 * k + 1]) * *loop->albedo_at++;
    }
    if (format == THREE) {
        for (int k = 0; k < 3; k++)
            out[k] = (uint8_t)usat(v[k], 8, 22);
        return !carries(w, v[0] << 10) && !carries(w_green, v[1] << 10) && !carries(w, v[2] << 10);
    }
    for (int k = 0; k < 3 && format >= DITHERED && !has_albedo; k++)
        v[k] += loop->thresholds[at_4] >> (k == 1);
    pixel = usat(v[0], 5, 25) << 11 | usat(v[1], 6, 24) << 5 | usat(v[2], 5, 25);
    if (format == SWAPPED || format == DITHERED_SWAPPED || format == ALBEDO_SWAPPED)
        pixel = (pixel & 255) << 8 | pixel >> 8;
    memcpy(out, &pixel, 2);
    return !carries(w, v[0] << 7) && !carries(w_green, v[1] << 8) && !carries(w, v[2] << 7);
}

#define MODEL_RUN(name, wide, format, model)                                                                           \
    uint8_t *name(const struct glint_vec *normals, uint8_t *out, uint32_t *shine, const struct glint_vec *end)         \
    {                                                                                                                  \
        struct glint_line_loop *loop =                                                                                 \
            (struct glint_line_loop *)(void *)((uint8_t *)shine - offsetof(struct glint_line_loop, shine));            \
        for (; normals != end; normals++, out += format == THREE ? 3 : 2)                                              \
            if (!model_pixel(loop, normals, out, wide, format, model))                                                 \
                break;                                                                                                 \
        return out;                                                                                                    \
    }
#define MODEL_RUNS(name, model)                                                                                        \
    MODEL_RUN(glint_dsp_##name, false, NATIVE, model)                                                                  \
    MODEL_RUN(glint_dsp_##name##_swapped, false, SWAPPED, model)                                                       \
    MODEL_RUN(glint_dsp_##name##_wide, true, NATIVE, model)                                                            \
    MODEL_RUN(glint_dsp_##name##_wide_swapped, true, SWAPPED, model)
MODEL_RUNS(msh, MSH)
MODEL_RUNS(schlick, SCHLICK)
MODEL_RUNS(ggx, GGX)
MODEL_RUNS(cayley, CAYLEY)
MODEL_RUN(glint_dsp_msh_albedo, false, ALBEDO, MSH)
MODEL_RUN(glint_dsp_msh_albedo_swapped, false, ALBEDO_SWAPPED, MSH)
MODEL_RUN(glint_dsp_888, false, THREE, MSH)
MODEL_RUN(glint_dsp_888_wide, true, THREE, MSH)
MODEL_RUN(glint_dsp_msh_dither, false, DITHERED, MSH)
MODEL_RUN(glint_dsp_msh_dither_swapped, false, DITHERED_SWAPPED, MSH)
MODEL_RUN(glint_dsp_msh_dither_wide, true, DITHERED, MSH)
MODEL_RUN(glint_dsp_msh_dither_wide_swapped, true, DITHERED_SWAPPED, MSH)
