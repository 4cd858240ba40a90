/* SPDX-License-Identifier: MIT
 * The exact line of RGB565 under MSH, dithered or not, Schlick, GGX and Cayley, and of RGB888 under MSH, by the DSP extension of Cortex-M4, M7, M33 and later: two
 * pixels at a time, two products an instruction. Like the other exact loops it finds V, which is low by less than W, and leaves open what V and W do
 * not decide. */
#include "glint_fused.h"

#if GLINT_DSP

/* ---- What a rectangle folds to ----
 *
 * With c = 1 - t: MSH is 1.024 c / w^2, w = 1 + k t, k = (4n - 5) / 5; Schlick c / w, w = 1 + (n - 1) t; GGX 1 / w^2, w = 1 + n (1 - c^2) / 2.
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

/* ---- The loop ---- */

#if !defined(GLINT_DSP_MODEL) /* of tests, in C, for the host */
#define DSP_AT(field, offset) (offsetof(struct glint_line_loop, field) == (offset))
typedef char dsp_layout[DSP_AT(turn, 0) && DSP_AT(plain, 28) && DSP_AT(shine, 56) && DSP_AT(v, 56 + 28) &&
                                DSP_AT(up, 56 + 36) && DSP_AT(hh, 56 + 40) && DSP_AT(nh, 56 + 44) &&
                                DSP_AT(t_end, 56 + 48) && DSP_AT(dark, 56 + 52) && DSP_AT(last, 56 + 56) &&
                                DSP_AT(w_green, 56 + 60) && DSP_AT(thresholds, 56 + 64) && DSP_AT(dark_of, 56 + 80) &&
                                DSP_AT(lit, 56 + 96) && DSP_AT(albedo_at, 56 + 120) && sizeof(struct glint_vec) == 6
                            ? 1
                            : -1];
#undef DSP_AT

/* r0: the next normal, r1: the pixel in out, r2: shine, r3: t_end; on the stack turn and, at 28, the last place from which two normals are left.
 *
 * Levels of V in vr, vg, vb: stored, and to 9 where one of them is open: its fraction and W carry. */
#define DSP_LEVELS(format, vr, vg, vb, w, w_green, r, g, b)                                                            \
    ".if " format " == 2\n\t"                                                                                          \
    "usat " r ", #8, " vr ", asr #22\n\t"                                                                              \
    "usat " g ", #8, " vg ", asr #22\n\t"                                                                              \
    "usat " b ", #8, " vb ", asr #22\n\t"                                                                              \
    "strb " r ", [r1], #1\n\t"                                                                                         \
    "strb " g ", [r1], #1\n\t"                                                                                         \
    "strb " b ", [r1], #1\n\t"                                                                                         \
    "cmn " w ", " vr ", lsl #10\n\t"                                                                                   \
    "itt cc\n\t"                                                                                                       \
    "cmncc " w_green ", " vg ", lsl #10\n\t"                                                                           \
    "cmncc " w ", " vb ", lsl #10\n\t"                                                                                 \
    ".else\n\t"                                                                                                        \
    ".if " format " == 3 || " format " == 4\n\t"                                                                       \
    "and " r ", r1, #6\n\t"                                                                                            \
    "add " r ", r2, " r ", lsl #1\n\t"                                                                                 \
    "ldr " r ", [" r ", #64]\n\t"                                                                                      \
    "add " vr ", " vr ", " r "\n\t"                                                                                    \
    "add " vg ", " vg ", " r ", lsr #1\n\t"                                                                            \
    "add " vb ", " vb ", " r "\n\t"                                                                                    \
    ".endif\n\t"                                                                                                       \
    "usat " r ", #5, " vr ", asr #25\n\t"                                                                              \
    "usat " g ", #6, " vg ", asr #24\n\t"                                                                              \
    "usat " b ", #5, " vb ", asr #25\n\t"                                                                              \
    "orr " b ", " b ", " g ", lsl #5\n\t"                                                                              \
    "orr " b ", " b ", " r ", lsl #11\n\t"                                                                             \
    ".if " format " == 1 || " format " == 4 || " format " == 6\n\t"                                                    \
    "rev16 " b ", " b "\n\t"                                                                                           \
    ".endif\n\t"                                                                                                       \
    "strh " b ", [r1], #2\n\t"                                                                                         \
    "cmn " w ", " vr ", lsl #7\n\t"                                                                                    \
    "itt cc\n\t"                                                                                                       \
    "cmncc " w_green ", " vg ", lsl #8\n\t"                                                                            \
    "cmncc " w ", " vb ", lsl #7\n\t"                                                                                  \
    ".endif\n\t"                                                                                                       \
    "bcs 9f\n\t"

/* Channel k of a pixel of s with an albedo map, whose byte is the next one at t. */
#define DSP_LIT(v, s, t, k)                                                                                            \
    "ldrd r5, r8, [r2, #96 + 8 * " k "]\n\t"                                                                           \
    "smmlar r5, r5, " s ", r8\n\t"                                                                                     \
    "ldrb r8, [" t "], #1\n\t"                                                                                         \
    "mla " v ", r5, r8, " v "\n\t"

/* A pixel of s, N.L less 2^13, and T in t. Where it is dark, or N.L above 1.0, to 5n; outside the highlight to 4n; the next one is at 3n. */
#define DSP_PIXEL(wide, format, model, s, t, n)                                                                        \
    "cmp " s ", #0x40000000\n\t"                                                                                       \
    "bhs 5" n "f\n\t"                                                                                                  \
    "cmp " t ", r3\n\t"                                                                                                \
    "bhs 4" n "f\n\t"                                                                                                  \
    "ldrd r5, r8, [r2, #28]\n\t"                                                                                       \
    ".if " model " == 3\n\t"                                                                                           \
    ".if " wide "\n\t"                                                                                                 \
    "smmulr r10, r5, " t "\n\t"                                                                                        \
    "mvn " t ", " t ", lsl #2\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    "ldr r11, [r2, #36]\n\t"                                                                                           \
    "lsl r10, " t ", r11\n\t"                                                                                          \
    "smmulr r10, r5, r10\n\t"                                                                                          \
    "mvn " t ", " t ", lsl #1\n\t"                                                                                     \
    ".endif\n\t"                                                                                                       \
    "sub " t ", " t ", r10, lsl #4\n\t"                                                                                \
    "add r8, r8, r10, lsr #12\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    ".if " model " == 2 && " wide "\n\t"                                                                               \
    "rsb r10, " t ", #0x40000000\n\t"                                                                                  \
    "smmulr r10, r10, r10\n\t"                                                                                         \
    "lsl r10, r10, #2\n\t"                                                                                             \
    "smmlar r8, r5, r10, r8\n\t"                                                                                       \
    ".elseif " wide " || " model " == 1\n\t"                                                                           \
    "smmlar r8, r5, " t ", r8\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    "ldr r11, [r2, #36]\n\t"                                                                                           \
    ".if " model " == 2\n\t"                                                                                           \
    "smmlsr r10, " t ", " t ", " t "\n\t"                                                                              \
    "lsl r10, r10, r11\n\t"                                                                                            \
    ".else\n\t"                                                                                                        \
    "lsl r10, " t ", r11\n\t"                                                                                          \
    ".endif\n\t"                                                                                                       \
    "smmlar r8, r5, r10, r8\n\t"                                                                                       \
    ".endif\n\t"                                                                                                       \
    ".if " model " == 2\n\t"                                                                                           \
    "mvn " t ", #0\n\t"                                                                                                \
    ".elseif " wide "\n\t"                                                                                             \
    "mvn " t ", " t ", lsl #2\n\t"                                                                                     \
    ".else\n\t"                                                                                                        \
    "mvn " t ", " t ", lsl #1\n\t"                                                                                     \
    ".endif\n\t"                                                                                                       \
    ".if " model " != 1\n\t"                                                                                           \
    "smmulr r8, r8, r8\n\t"                                                                                            \
    ".endif\n\t"                                                                                                       \
    ".endif\n\t"                                                                                                       \
    "udiv " t ", " t ", r8\n\t"                                                                                        \
    ".if " model " == 3\n\t" /* its fourth power */                                                                    \
    "mul " t ", " t ", " t "\n\t"                                                                                      \
    "umull r8, " t ", " t ", " t "\n\t"                                                                                \
    "lsr " t ", " t ", #16\n\t"                                                                                        \
    ".endif\n\t"                                                                                                       \
    "str r1, [r2, #56]\n\t"                                                                                            \
    ".if " format " > 4\n\t"                                                                                           \
    "ldmia r2, {r5, r8, r10, r11, r12, lr}\n\t"                                                                        \
    "mla r10, " t ", r5, r10\n\t"                                                                                      \
    "mla r11, " t ", r8, r11\n\t"                                                                                      \
    "mla r12, " t ", lr, r12\n\t"                                                                                      \
    "ldr lr, [r2, #24]\n\t"                                                                                            \
    "cmn lr, #1\n\t"                                                                                                   \
    "beq 7" n "f\n"                                                                                                    \
    "6" n ":\n\t" /* lit */                                                                                            \
    "bfc " s ", #0, #14\n\t"                                                                                           \
    "ldr " t ", [r2, #120]\n\t" DSP_LIT("r10", s, t, "0") DSP_LIT("r11", s, t, "1")                                    \
        DSP_LIT("r12", s, t, "2") "str " t ", [r2, #120]\n\t" DSP_LEVELS(                                              \
            format, "r10", "r11", "r12", "lr", "lr", "r5", s,                                                          \
            "r8") ".else\n\t"                                                                                          \
                  "pkhbt " t ", " t ", " s ", lsl #2\n\t"                                                              \
                  "eor " t ", " t ", #0x80008000\n\t"                                                                  \
                  "ldmia r2, {r5, r7, r8, r10, r11, r12, lr}\n\t"                                                      \
                  "smlad r10, " t ", r5, r10\n\t"                                                                      \
                  "smlad r11, " t ", r7, r11\n\t"                                                                      \
                  "smlad r12, " t ", r8, r12\n\t"                                                                      \
                  "ldr " t                                                                                             \
                  ", [r2, #60]\n\t" DSP_LEVELS(format, "r10", "r11", "r12", "lr", t, "r5", "r7", "r8") ".endif\n3" n   \
                                                                                                       ":\n\t"

/* q0: a register below r8 that is free. */
#define DSP_REST(format, s, q0, q1, n)                                                                                 \
    ".if " format " > 4\n"                                                                                             \
    "4" n ":\n\t"                                                                                                      \
    "ldmdb r2, {r10, r11, r12, lr}\n\t"                                                                                \
    "b 6" n "b\n"                                                                                                      \
    "5" n ":\n\t" /* nl = 0 */                                                                                         \
    "cmp " s ", #0\n\t"                                                                                                \
    "itt mi\n\t"                                                                                                       \
    "movmi " s ", #-1\n\t"                                                                                             \
    "bmi 4" n "b\n"                                                                                                    \
    "7" n ":\n\t"                                                                                                      \
    "adds r1, #2\n\t"                                                                                                  \
    "b 9f\n\t"                                                                                                         \
    ".else\n"                                                                                                          \
    "4" n ":\n\t"                                                                                                      \
    "ldmdb r2, {" q0 ", " q1 ", r8, r10, r11, r12, lr}\n\t"                                                            \
    "lsr " s ", " s ", #14\n\t"                                                                                        \
    "mla r10, " q0 ", " s ", r10\n\t"                                                                                  \
    "mla r11, " q1 ", " s ", r11\n\t"                                                                                  \
    "mla r12, r8, " s                                                                                                  \
    ", r12\n\t" DSP_LEVELS(format, "r10", "r11", "r12", "lr", "lr", q0, q1, "r8") "b 3" n "b\n"                        \
                                                                                  "5" n ":\n\t"                        \
                                                                                  ".if " format " > 2\n\t"             \
                                                                                  "and r5, r1, #6\n\t"                 \
                                                                                  "add r5, r2, r5, lsl #1\n\t"         \
                                                                                  "ldr r5, [r5, #80]\n\t"              \
                                                                                  ".else\n\t"                          \
                                                                                  "ldr r5, [r2, #52]\n\t"              \
                                                                                  ".endif\n\t"                         \
                                                                                  ".if " format " == 2\n\t"            \
                                                                                  "strb r5, [r1], #1\n\t"              \
                                                                                  "lsr r5, r5, #8\n\t"                 \
                                                                                  "strb r5, [r1], #1\n\t"              \
                                                                                  "lsr r5, r5, #8\n\t"                 \
                                                                                  "strb r5, [r1], #1\n\t"              \
                                                                                  ".else\n\t"                          \
                                                                                  "strh r5, [r1], #2\n\t"              \
                                                                                  ".endif\n\t"                         \
                                                                                  "cmp " s ", #0\n\t"                  \
                                                                                  "bmi 3" n "b\n\t"                    \
                                                                                  "b 9f\n\t"                           \
                                                                                  ".endif\n\t"

#define DSP_RUN(name, model, wide, format)                                                                             \
    __attribute__((naked, noinline)) uint8_t *name(                                                                    \
        __attribute__((unused)) const struct glint_vec *normals, __attribute__((unused)) uint8_t *out,                 \
        __attribute__((unused)) uint32_t *shine, __attribute__((unused)) const struct glint_vec *end)                  \
    {                                                                                                                  \
        __asm__("push {r4, r5, r6, r7, r8, r9, r10, r11, lr}\n\t"                                                      \
                "sub sp, #36\n\t"                                                                                      \
                "sub r4, r2, #56\n\t"                                                                                  \
                "ldmia r4, {r5, r6, r7, r8, r9, r10, r11}\n\t"                                                         \
                "stmia sp, {r5, r6, r7, r8, r9, r10, r11}\n\t"                                                         \
                "sub r5, r3, #12\n\t"                                                                                  \
                "str r5, [sp, #28]\n\t"                                                                                \
                "ldr r3, [r2, #48]\n\t"                                                                                \
                "tst r0, #2\n\t" /* pairs are loaded by words */                                                       \
                "bne 8f\n\t"                                                                                           \
                "b 7f\n"                                                                                               \
                "1:\n\t"                                                                                               \
                "ldmia sp, {r7, r8, r9, r10, r11, r12, lr}\n\t"                                                        \
                "ldmia r0!, {r4, r5, r6}\n\t"                                                                          \
                "smlad r7, r4, r7, r10\n\t"                                                                            \
                "smlabb r7, r5, r8, r7\n\t"                                                                            \
                "smlad r9, r6, r9, r10\n\t"                                                                            \
                "smlatt r9, r5, r8, r9\n\t"                                                                            \
                ".if " wide "\n\t"                                                                                     \
                "ldrd r8, r10, [r2, #40]\n\t"                                                                          \
                "smlad r11, r4, r11, r10\n\t"                                                                          \
                "smlabb r11, r5, r12, r11\n\t"                                                                         \
                "smlad r10, r6, lr, r10\n\t"                                                                           \
                "smlatt r10, r5, r12, r10\n\t"                                                                         \
                "smlad r4, r4, r4, r8\n\t"                                                                             \
                "smlabb r4, r5, r5, r4\n\t"                                                                            \
                "smlad r6, r6, r6, r8\n\t"                                                                             \
                "smlatt r6, r5, r5, r6\n\t"                                                                            \
                "rsb r4, r11, r4, asr #1\n\t"                                                                          \
                "rsb r6, r10, r6, asr #1\n\t"                                                                          \
                ".else\n\t"                                                                                            \
                "qsub16 r4, r4, r11\n\t"                                                                               \
                "qsub16 r5, r5, r12\n\t"                                                                               \
                "qsub16 r6, r6, lr\n\t"                                                                                \
                "smuad r4, r4, r4\n\t"                                                                                 \
                "smlabb r4, r5, r5, r4\n\t"                                                                            \
                "smuad r6, r6, r6\n\t"                                                                                 \
                "smlatt r6, r5, r5, r6\n\t"                                                                            \
                ".endif\n\t" DSP_PIXEL(wide, format, model, "r7", "r4", "0") "2:\n\t" DSP_PIXEL(                       \
                    wide, format, model, "r9", "r6", "1") "ldr r5, [sp, #28]\n"                                        \
                                                          "7:\n\t"                                                     \
                                                          "cmp r0, r5\n\t"                                             \
                                                          "bls 1b\n\t"                                                 \
                                                          "add r5, #12\n\t"                                            \
                                                          "cmp r0, r5\n\t"                                             \
                                                          "bne 8f\n\t"                                                 \
                                                          "mov r0, r1\n"                                               \
                                                          "6:\n\t"                                                     \
                                                          "add sp, #36\n\t"                                            \
                                                          "pop {r4, r5, r6, r7, r8, r9, r10, r11, pc}\n"               \
                                                          "8:\n\t" /* one, in the place of the second of a pair */     \
                                                          "ldrh r4, [r0]\n\t"                                          \
                                                          "ldrh r5, [r0, #2]\n\t"                                      \
                                                          "orr r4, r4, r5, lsl #16\n\t"                                \
                                                          "ldrh r5, [r0, #4]\n\t"                                      \
                                                          "adds r0, #6\n\t"                                            \
                                                          "ldmia sp, {r7, r8, r9, r10, r11, r12, lr}\n\t"              \
                                                          "smlad r9, r4, r7, r10\n\t"                                  \
                                                          "smlabb r9, r5, r8, r9\n\t"                                  \
                                                          ".if " wide "\n\t"                                           \
                                                          "ldrd r8, r10, [r2, #40]\n\t"                                \
                                                          "smlad r6, r4, r4, r8\n\t"                                   \
                                                          "smlabb r6, r5, r5, r6\n\t"                                  \
                                                          "smlad r10, r4, r11, r10\n\t"                                \
                                                          "smlabb r10, r5, r12, r10\n\t"                               \
                                                          "rsb r6, r10, r6, asr #1\n\t"                                \
                                                          ".else\n\t"                                                  \
                                                          "qsub16 r4, r4, r11\n\t"                                     \
                                                          "qsub16 r5, r5, r12\n\t"                                     \
                                                          "smuad r6, r4, r4\n\t"                                       \
                                                          "smlabb r6, r5, r5, r6\n\t"                                  \
                                                          ".endif\n\t"                                                 \
                                                          "b 2b\n" DSP_REST(format, "r7", "r4", "r5", "0") DSP_REST(   \
                                                              format, "r9", "r6", "r7", "1") "9:\n\t"                  \
                                                                                             ".if " format " == 2\n\t" \
                                                                                             "subs r0, r1, #3\n\t"     \
                                                                                             ".else\n\t"               \
                                                                                             "subs r0, r1, #2\n\t"     \
                                                                                             ".endif\n\t"              \
                                                                                             "b 6b\n\t");              \
    }

DSP_RUN(glint_dsp_msh, "0", "0", "0")
DSP_RUN(glint_dsp_msh_swapped, "0", "0", "1")
DSP_RUN(glint_dsp_msh_wide, "0", "1", "0")
DSP_RUN(glint_dsp_msh_wide_swapped, "0", "1", "1")
DSP_RUN(glint_dsp_schlick, "1", "0", "0")
DSP_RUN(glint_dsp_schlick_swapped, "1", "0", "1")
DSP_RUN(glint_dsp_schlick_wide, "1", "1", "0")
DSP_RUN(glint_dsp_schlick_wide_swapped, "1", "1", "1")
DSP_RUN(glint_dsp_ggx, "2", "0", "0")
DSP_RUN(glint_dsp_ggx_swapped, "2", "0", "1")
DSP_RUN(glint_dsp_ggx_wide, "2", "1", "0")
DSP_RUN(glint_dsp_ggx_wide_swapped, "2", "1", "1")
DSP_RUN(glint_dsp_cayley, "3", "0", "0")
DSP_RUN(glint_dsp_cayley_swapped, "3", "0", "1")
DSP_RUN(glint_dsp_cayley_wide, "3", "1", "0")
DSP_RUN(glint_dsp_cayley_wide_swapped, "3", "1", "1")
DSP_RUN(glint_dsp_msh_dither, "0", "0", "3")
DSP_RUN(glint_dsp_msh_dither_swapped, "0", "0", "4")
DSP_RUN(glint_dsp_msh_dither_wide, "0", "1", "3")
DSP_RUN(glint_dsp_msh_dither_wide_swapped, "0", "1", "4")
DSP_RUN(glint_dsp_msh_albedo, "0", "0", "5")
DSP_RUN(glint_dsp_msh_albedo_swapped, "0", "0", "6")
DSP_RUN(glint_dsp_888, "0", "0", "2")
DSP_RUN(glint_dsp_888_wide, "0", "1", "2")
#undef DSP_RUN
#undef DSP_REST
#undef DSP_PIXEL
#undef DSP_LIT
#undef DSP_LEVELS
#endif

/* ---- Lines ---- */

static inline uint32_t dsp_word(const uint8_t *m)
{
    uint32_t word;
    __builtin_memcpy(&word, __builtin_assume_aligned(m, 4), 4);
    return word;
}

static inline uint64_t dsp_two(const uint8_t *m)
{
    uint64_t words;
    __builtin_memcpy(&words, __builtin_assume_aligned(m, 4), 8);
    return words;
}

/* From m on, before end, the first pixel that is covered in full, or, is_full, that is not. Of those before it *all has all bits. */
static inline __attribute__((always_inline)) const uint8_t *dsp_find(const uint8_t *m, const uint8_t *end,
                                                                     uint32_t *all, bool is_full)
{
    const uint32_t whole = is_full ? UINT32_MAX : 0;
    for (;;) {
        if (!((uintptr_t)m & 3)) {
            for (; end - m >= 16; m += 16) {
                const uint64_t a = dsp_two(m), b = dsp_two(m + 8), both = is_full ? a & b : a | b;
                if ((is_full ? (uint32_t)both & (uint32_t)(both >> 32) : (uint32_t)both | (uint32_t)(both >> 32)) !=
                    whole)
                    break;
            }
            while (end - m >= 4 && dsp_word(m) == whole)
                m += 4;
        }
        do {
            if (m == end || (*m == 255) != is_full)
                return m;
            *all |= *m++;
        } while ((uintptr_t)m & 3);
    }
}

/* Until a pixel is lit, where it is asked which one is the first: W so large that what is lit is open. V is 1 then. */
static const uint32_t dsp_stops[7] = {0, 0, 0, 1, 1, 1, UINT32_MAX};

static inline void dsp_copy(uint32_t *to, const uint32_t *from)
{
    for (unsigned i = 0; i < 7; i++)
        to[i] = from[i];
}

/* A pixel that W leaves open, from its exact N.L and F, but for what the coefficients are off: less than DSP_NEAR. false: it is as open as before. */
enum { DSP_NEAR = 8 };
static inline __attribute__((always_inline)) uint32_t dsp_level(const struct glint_line_loop *loop,
                                                                const struct glint_sample *sample, unsigned k,
                                                                unsigned shift, uint32_t more, uint32_t *undecided)
{
    const uint32_t most = (UINT32_C(1) << (shift == 25 ? 5 : 30 - shift)) - 1;
    const uint64_t lit = (uint64_t)loop->q_q16[k] * sample->nl_q16 + (uint64_t)loop->r_q16[k] * sample->f_q16;
    const uint32_t v = loop->base[k] + (uint32_t)(lit >> 16) + more - DSP_NEAR, level = v >> shift;
    *undecided |= (v ^ (v + 2 * DSP_NEAR)) >> shift;
    return level < most ? level : most;
}

static bool dsp_decide(const struct glint_line_loop *loop, const struct glint_sample *sample, uint8_t *out)
{
    if (loop->albedo)
        return false;
    uint32_t undecided = loop->paint->of.exact.high; /* a coloured light's nl and F are rounded once more */
    if (loop->bytes == 3) {
        const uint32_t first = dsp_level(loop, sample, 0, 22, 0, &undecided),
                       second = dsp_level(loop, sample, 1, 22, 0, &undecided),
                       third = dsp_level(loop, sample, 2, 22, 0, &undecided);
        if (undecided)
            return false;
        out[0] = (uint8_t)first;
        out[1] = (uint8_t)second;
        out[2] = (uint8_t)third;
        return true;
    }
    const uint32_t more = loop->paint->output.dither ? loop->thresholds[(uintptr_t)out >> 1 & 3] : 0;
    const uint32_t pixel = dsp_level(loop, sample, 0, 25, more, &undecided) << 11 |
                           dsp_level(loop, sample, 1, 24, more >> 1, &undecided) << 5 |
                           dsp_level(loop, sample, 2, 25, more, &undecided);
    if (undecided)
        return false;
    const bool swapped = loop->format == GLINT_RGB565_SWAPPED;
    out[swapped] = (uint8_t)pixel;
    out[!swapped] = (uint8_t)(pixel >> 8);
    return true;
}

void glint_line_dither(struct glint_line_loop *loop, const struct glint_run *run, const uint16_t dark[4])
{
    uint32_t row = glint_bayer_row(run->left, run->y);
    for (unsigned x = 0; x < 4; x++, row >>= 4) {
        const unsigned at = (unsigned)((uintptr_t)loop->out >> 1) + x;
        loop->thresholds[at & 3] = (2 * (row & 15) + 1) << 20; /* of 2^25 */
        loop->dark_of[at & 3] = dark[x];
    }
}

uint32_t glint_line_dsp(struct glint_line_loop *loop, uint32_t x)
{
    const struct glint_paint *const paint = loop->paint;
    uint32_t shine[7] = {0}; /* once a line: else gcc warns where it cannot tell that stops stays */
    for (;;) {
        if (x >= loop->run_end) {
            if (x >= loop->w)
                return loop->w;
            loop->run_end = loop->w;
            if (loop->mask) {
                const uint8_t *const end = loop->mask + loop->w;
                uint32_t all = 0;
                const uint8_t *const first = dsp_find(loop->mask + x, end, &loop->covered, false);
                x = (uint32_t)(first - loop->mask);
                if (first == end)
                    return x;
                loop->run_end = (uint32_t)(dsp_find(first, end, &all, true) - loop->mask);
            }
        }
        const bool stops = loop->seeks && loop->first == (const uint8_t *)UINTPTR_MAX;
        if (stops) {
            dsp_copy(shine, loop->shine);
            dsp_copy(loop->shine, dsp_stops);
        }
        loop->albedo_at = loop->albedo + (loop->albedo ? 3 * x : 0);
        uint8_t *stopped =
            loop->run(loop->normals + x, loop->out + loop->bytes * x, loop->shine, loop->normals + loop->run_end);
        if (stops)
            dsp_copy(loop->shine, shine);
        const uint32_t at = (uint32_t)(stopped - loop->out);
        x = loop->bytes == 2 ? at / 2 : at / 3;
        if (stops && loop->last == stopped) {
            loop->first = stopped; /* it is to be drawn as yet */
        } else if (x < loop->run_end) {
            struct glint_sample *const sample = &loop->sample;
            glint_samples_half(&paint->l, &paint->v, &paint->h, loop->normals + x, sample, 1);
            sample->f_q16 = 0;
            if (sample->t_q30 < paint->of.exact.t_end) { /* the loop has not noted it where N.L is above 1.0 */
                loop->last = stopped;
                loop->first = loop->first < stopped ? loop->first : stopped;
                sample->f_q16 = paint->model->exact(paint->of.exact.n, sample->t_q30);
            }
            if (!dsp_decide(loop, sample, stopped))
                return x;
            x++;
        }
    }
}
#endif
