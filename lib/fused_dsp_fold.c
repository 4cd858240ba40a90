/* SPDX-License-Identifier: MIT
 * What a rectangle folds to for the exact loops by the DSP extension (fused_dsp.c). */
#include "glint_fused.h"

#if GLINT_DSP

/* With c = 1 - t: MSH is 1.024 c / w^2, w = 1 + k t, k = (4n - 5) / 5; Schlick c / w, w = 1 + (n - 1) t; GGX 1 / w^2, w = 1 + n (1 - c^2) / 2.
 * The loop has F' = floor((2^32 - 1 - 4t) / (65537 w^2)), t in Q30, of Schlick w in the place of w^2, of GGX without t: below 2^16, so that it is
 * half a word; and F 2^16 = S F' + e, S = 65537 / 65536, of MSH 1.024 times that, -17/16 < e < 35/16 (tests/proof/test_dsp). Of Cayley a quotient
 * is r in 16 bits, and F' is r^4: S = 1, -73/16 < e < 89/16.
 *
 * A channel, in units of 2^-25 level, green 2^-24, in RGB888 2^-22: Q nl + R F' + P, where Q and R are rounded to whole numbers, by q and r. N.L comes
 * as nl - 1 - 2^15 and F' as F' - 2^15, between -2^15 and 2^15 - 1, so what rounding makes wrong is at most 2^15 (|q| + |r|) to either side: it is
 * taken off P, and twice that is in W. */

/* x a 2^-bits of 32 bits. */
static inline uint32_t dsp_scale(uint32_t x, uint32_t a, unsigned bits)
{
    return (uint32_t)((uint64_t)x * a >> bits);
}

static inline uint32_t dsp_size(int32_t x)
{
    return x < 0 ? 0 - (uint32_t)x : (uint32_t)x;
}

/* Coefficients are off by less than 26 units, so is what F and nl make of them; with what else is cut that is less than DSP_CUT. */
enum { DSP_CUT = 64 };

/* One channel; false where it does not fit. W in the highlight goes to *w, outside to *w_plain, both of a level, times 2^32. */
static inline __attribute__((always_inline)) bool dsp_fold_channel(struct glint_line_loop *loop,
                                                                   const struct glint_paint *p, unsigned k, unsigned at,
                                                                   unsigned up, uint32_t *w, uint32_t *w_plain)
{
    /* 2^25 31, 2^24 63 or 2^22 255, over 2^16: a level's units of a coefficient; and over 255 */
    const uint32_t unit = up == 7 ? 31 << 9 : up == 8 ? 63 << 8 : 255 << 6;
    const uint32_t by_255 = (uint32_t)((((uint64_t)unit << 24) + 127) / 255);
    const struct glint_material *m = &p->material;
    const struct glint_use_line *line = p->model->line;
    const uint32_t albedo = m->albedo[k], a = glint_coefficient(m->ambient_q16[k]),
                   d = glint_coefficient(m->diffuse_q16[k]), s = glint_coefficient(m->specular_q16[k]);
    /* V at nl = F = 0; what it gains to nl = 1.0, to F' = 2^16; and low: what P is to be lower */
    const uint32_t base = dsp_scale(a * albedo, by_255, 24) + (p->output.dither ? 0 : UINT32_C(1) << (31 - up));
    uint32_t q_q16 = dsp_scale(d * albedo, by_255, 24), r_exact = s * unit, low = DSP_CUT;
    uint32_t r_q16 = r_exact + dsp_scale(r_exact, line->scale, 32);
    loop->base[at] = base;
    loop->q_q16[at] = q_q16;
    loop->r_q16[at] = r_exact;
    if (p->of.exact.high) { /* a coloured light: rounded nl and F are each off by a half */
        const uint64_t q_of = (uint64_t)q_q16 * p->color_q16[k] >> 16, r_of = (uint64_t)r_q16 * p->color_q16[k] >> 16;
        if ((q_of | r_of) > INT32_MAX)
            return false;
        q_q16 = (uint32_t)q_of;
        r_q16 = (uint32_t)r_of;
        low += (unit * ((d + s) >> 1) >> 16) + 1;
    }
    const uint32_t q = (q_q16 + 32768) >> 16, r = (r_q16 + 32768) >> 16;
    const int32_t q_left = (int32_t)(q_q16 - (q << 16));
    const uint32_t q_off = dsp_size(q_left), offs = q_off + dsp_size((int32_t)(r_q16 - (r << 16)));
    /* V < 2^31, as its levels are those of a number with a sign */
    if ((q | r) > 32767 || q_q16 + r_q16 > INT32_MAX - base - 2 * low - (UINT32_C(1) << (32 - up)))
        return false;
    loop->plain[at] = q;
    loop->plain[3 + at] = base + q - (q_left < 0 ? q_off + 1 : 0) - low;
    loop->shine[at] = q << 16 | r;
    loop->shine[3 + at] = base + q + ((q_q16 + r_q16 - offs) >> 1) - (line->below * r >> 4) - low;
    *w = (offs + (line->width * r >> 4) + 2 * low) << up;
    *w_plain = (q_off + 2 * low) << up;
    loop->dark |= (base - DSP_CUT) >> (32 - up) << (up == 10 ? 8 * at : at == 0 ? 11 : at == 1 ? 5 : 0);
    loop->dark_is_open |= ((base - DSP_CUT) ^ (base + DSP_CUT)) >> (32 - up) != 0;
    return true;
}

static void dsp_fold_w(struct glint_line_loop *loop, const uint32_t w[3], const uint32_t plain[3])
{
    const uint32_t both = plain[0] > plain[2] ? plain[0] : plain[2];
    loop->w_green = w[1];
    loop->shine[6] = w[0] > w[2] ? w[0] : w[2];
    loop->plain[6] = both > plain[1] ? both : plain[1];
}

static bool dsp_fold_565(struct glint_line_loop *loop, const struct glint_paint *p)
{
    uint32_t w[3], plain[3];
    if (!dsp_fold_channel(loop, p, 1, 1, 8, &w[1], &plain[1]))
        return false;
    for (unsigned k = 0; k < 3; k += 2)
        if (!dsp_fold_channel(loop, p, k, k, 7, &w[k], &plain[k]))
            return false;
    dsp_fold_w(loop, w, plain);
    if (loop->format == GLINT_RGB565_SWAPPED)
        loop->dark = (loop->dark & 255) << 8 | loop->dark >> 8;
    return true;
}

/* With an albedo map V = a lit + R F' + P, lit = d (nl - 1) 2^-18 + ambient, to nearest: for a = 1, off by less than 3 units. */
enum { DSP_ALBEDO_CUT = DSP_CUT + 3 * 255 };
static bool dsp_fold_albedo(struct glint_line_loop *loop, const struct glint_paint *p)
{
    const struct glint_material *m = &p->material;
    const struct glint_use_line *line = p->model->line;
    const uint32_t low = DSP_ALBEDO_CUT;
    loop->shine[6] = 0;
    loop->plain[6] = 2 * low << 8;
    for (unsigned k = 0; k < 3; k++) {
        const unsigned up = k == 1 ? 8 : 7;
        const uint32_t unit = k == 1 ? 63 << 8 : 31 << 9, by_255 = (uint32_t)((((uint64_t)unit << 24) + 127) / 255);
        const uint32_t a = glint_coefficient(m->ambient_q16[k]), d = glint_coefficient(m->diffuse_q16[k]),
                       r_exact = glint_coefficient(m->specular_q16[k]) * unit;
        const uint32_t r_q16 = r_exact + dsp_scale(r_exact, line->scale, 32), r = (r_q16 + 32768) >> 16;
        const int32_t r_left = (int32_t)(r_q16 - (r << 16));
        const uint32_t r_off = dsp_size(r_left), half = UINT32_C(1) << (31 - up);
        if ((uint64_t)(a + d) * unit + r_q16 + 2 * half > INT32_MAX)
            return false;
        const uint32_t w = (r_off + (line->width * r >> 4) + 2 * low) << up;
        loop->lit[2 * k] = dsp_scale(d, by_255, 22);
        loop->lit[2 * k + 1] = dsp_scale(a, by_255, 24) + (loop->lit[2 * k] >> 18);
        loop->plain[3 + k] = half - low;
        loop->shine[k == 2 ? 5 : k] = r;
        loop->shine[2 + k] = half - (r_left < 0 ? r_off + 1 : 0) - (line->below * r >> 4) - low;
        loop->shine[6] = loop->shine[6] > w ? loop->shine[6] : w;
    }
    return true;
}

/* Channels in the order of their bytes. */
static bool dsp_fold_888(struct glint_line_loop *loop, const struct glint_paint *p)
{
    uint32_t w[3], plain[3];
    for (unsigned k = 0; k < 3; k++) {
        const unsigned at = loop->format == GLINT_BGR888 ? 2 - k : k;
        if (!dsp_fold_channel(loop, p, k, at, 10, &w[at], &plain[at]))
            return false;
    }
    dsp_fold_w(loop, w, plain);
    return true;
}

static inline uint32_t dsp_pair(int32_t low, int32_t high)
{
    return (uint16_t)low | (uint32_t)high << 16;
}

/* 2^24 sqrt(65537 / 65536): its square is 65537 2^32, but for 2^14. */
enum { DSP_ROOT = 16777344 };

/* The root of the divisor at T: DSP_ROOT w = DSP_ROOT + DSP_ROOT k 2^-30 t, in 32 bits with a sign. */
static bool dsp_fold_msh(struct glint_line_loop *loop, const struct glint_paint *p)
{
    const int32_t k5 = 4 * (int32_t)p->of.exact.n - 5;
    loop->v[1] = DSP_ROOT;
    if (loop->is_wide) {
        loop->v[0] = k5 * 13421875 + k5 / 5; /* DSP_ROOT 4 / 5 */
        return k5 <= 159;
    }
    const uint64_t v = ((uint64_t)(uint32_t)k5 * UINT32_C(1718000026) >> (7 + loop->up)) + 1; /* DSP_ROOT 2 / 5, Q8 */
    loop->v[0] = (int32_t)(v >> 1);
    return v >> 32 == 0;
}
const struct glint_use_line glint_line_msh = {
    103146455,
    17,
    52,
    false,
    dsp_fold_msh,
    {glint_dsp_msh, glint_dsp_msh_swapped, glint_dsp_msh_wide, glint_dsp_msh_wide_swapped, glint_dsp_msh_dither,
     glint_dsp_msh_dither_swapped, glint_dsp_msh_dither_wide, glint_dsp_msh_dither_wide_swapped, glint_dsp_msh_albedo,
     glint_dsp_msh_albedo_swapped}};

/* The divisor itself, whole numbers. */
static bool dsp_fold_schlick(struct glint_line_loop *loop, const struct glint_paint *p)
{
    loop->v[1] = 65537;
    loop->v[0] = (int32_t)(65537 * (p->of.exact.n - 1)) * (loop->is_wide ? 4 : 2);
    return true;
}
const struct glint_use_line glint_line_schlick = {65536,
                                                  17,
                                                  52,
                                                  true,
                                                  dsp_fold_schlick,
                                                  {glint_dsp_schlick, glint_dsp_schlick_swapped, glint_dsp_schlick_wide,
                                                   glint_dsp_schlick_wide_swapped, NULL, NULL, NULL, NULL}};

/* DSP_ROOT w: of 2t - t^2 (narrow), or of c^2. */
static bool dsp_fold_ggx(struct glint_line_loop *loop, const struct glint_paint *p)
{
    const uint32_t n = p->of.exact.n;
    loop->v[1] = DSP_ROOT;
    if (loop->is_wide) {
        loop->v[0] = -(int32_t)(2 * DSP_ROOT * n);
        loop->v[1] = (int32_t)(DSP_ROOT + DSP_ROOT / 2 * n);
        return n <= 63;
    }
    const uint64_t v = ((uint64_t)n * (4 * DSP_ROOT) >> loop->up) + 1;
    loop->v[0] = (int32_t)(v >> 1);
    return v >> 32 == 0;
}
const struct glint_use_line glint_line_ggx = {
    65536,
    17,
    52,
    true,
    dsp_fold_ggx,
    {glint_dsp_ggx, glint_dsp_ggx_swapped, glint_dsp_ggx_wide, glint_dsp_ggx_wide_swapped, NULL, NULL, NULL, NULL}};

/* 2^28 (w - 1), w = 1 + (n - 4) t / 8: r = (2 - w - t) / w is the quotient of 2^32 and 2^16 times these. Where r >= 0, w <= 2. */
static bool dsp_fold_cayley(struct glint_line_loop *loop, const struct glint_paint *p)
{
    const uint32_t n = p->of.exact.n;
    if (n <= 4 || (loop->is_wide ? n > 19 : loop->up > 26))
        return false;
    loop->v[1] = 65536;
    loop->v[0] = (int32_t)((n - 4) << (loop->is_wide ? 27 : 26 - loop->up));
    return true;
}
const struct glint_use_line glint_line_cayley = {0,
                                                 73,
                                                 162,
                                                 true,
                                                 dsp_fold_cayley,
                                                 {glint_dsp_cayley, glint_dsp_cayley_swapped, glint_dsp_cayley_wide,
                                                  glint_dsp_cayley_wide_swapped, NULL, NULL, NULL, NULL}};

static bool dsp_begin(struct glint_line_loop *loop, const struct glint_paint *p, const struct glint_use_line *line)
{
    const struct glint_vec l = p->l, h = p->h;
    const uint32_t t_end = p->of.exact.t_end;
    if (p->material.clamp_peak && !line->holds)
        return false;
    loop->paint = p;
    loop->format = p->output.format;
    loop->dark = 0;
    loop->dark_is_open = false;
    loop->turn[0] = dsp_pair(l.x, l.y);
    loop->turn[1] = dsp_pair(l.z, l.x);
    loop->turn[2] = dsp_pair(l.y, l.z);
    loop->turn[3] = (uint32_t)-8192;
    loop->turn[4] = dsp_pair(h.x, h.y);
    loop->turn[5] = dsp_pair(h.z, h.x);
    loop->turn[6] = dsp_pair(h.y, h.z);
    loop->is_wide = t_end > (UINT32_C(1) << 29) - 32768;
    if (loop->is_wide) {
        /* Differences of halves may pass 16 bits: t is (N.N + H.H >> 1) - N.H, each less 2^30 + 2^16, as sums must fit. */
        const uint32_t hh = (uint32_t)(h.x * h.x) + (uint32_t)(h.y * h.y) + (uint32_t)(h.z * h.z);
        loop->hh = hh - (UINT32_C(1) << 31) - (UINT32_C(1) << 17);
        loop->nh = 0 - (UINT32_C(1) << 30) - (UINT32_C(1) << 16);
        loop->t_end = t_end;
        if (hh - (UINT32_C(1) << 17) >= (UINT32_C(1) << 30) - 65536) /* not a vector of length 1 */
            return false;
    } else {
        /* They saturate beyond the lobe alone. T << up < 2^31. */
        loop->t_end = 2 * t_end;
        loop->up = (uint32_t)__builtin_clz(loop->t_end) - 1;
    }
    return line->fold(loop, p);
}

bool glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *p, bool albedo)
{
    const struct glint_use_line *line = p->model->line;
    if (!line || !dsp_begin(loop, p, line))
        return false;
    loop->bytes = 2;
    if (albedo) {
        loop->run = line->run[8 + (loop->format == GLINT_RGB565_SWAPPED)];
        return loop->run && !loop->is_wide && !p->output.dither && dsp_fold_albedo(loop, p);
    }
    loop->run = line->run[4 * p->output.dither + 2 * loop->is_wide + (loop->format == GLINT_RGB565_SWAPPED)];
    return loop->run && dsp_fold_565(loop, p);
}

bool glint_line_begin_888(struct glint_line_loop *loop, const struct glint_paint *p, bool albedo)
{
    const struct glint_use_line *line = p->model->line;
    if (albedo || !line || GLINT_FLASH_U8(p->model->model) != GLINT_MSH || p->output.dither ||
        (p->output.format != GLINT_RGB888 && p->output.format != GLINT_BGR888) || !dsp_begin(loop, p, line))
        return false;
    loop->bytes = 3;
    loop->run = loop->is_wide ? glint_dsp_888_wide : glint_dsp_888;
    return dsp_fold_888(loop, p);
}

#endif
