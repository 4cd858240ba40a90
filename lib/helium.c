/* SPDX-License-Identifier: MIT
 * Cortex-M55 and M85: the exact line of RGB565 under MSH, and INT8 normals over COLOUR tables, by vectors of 128 bits
 * (Helium, integers only). The same pixels as the general way.
 *
 * Pixels come in eights. Those of even number lie in one vector of four words, the others in a second one; halves of both, bottom
 * and top, are the eight in their order. */
#include "glint_fused.h"
#include "glint_tables.h"

#if GLINT_HELIUM
#include "glint_math.h"
#include <arm_mve.h>

enum { HELIUM_EIGHT = 8, HELIUM_NORMAL = sizeof(struct glint_vec) };
typedef char glint_helium_normal[HELIUM_NORMAL == 6 ? 1 : -1];

/* A bit pair a pixel in their order, from a predicate of the even ones and one of the odd ones, which have four bits each. */
GLINT_INLINE uint32_t helium_pairs(mve_pred16_t even, mve_pred16_t odd)
{
    return (even & 0x3333u) | (odd & 0xccccu);
}

/* ---- The exact line ---- */

uint32_t glint_helium_find(const uint8_t *coverage, uint32_t x, uint32_t end, bool full)
{
    for (; x < end; x += 16) {
        const mve_pred16_t left = vctp8q(end - x);
        const uint8x16_t sixteen = vldrbq_z_u8(coverage + x, left);
        const uint32_t found = full ? vcmpeqq_m_n_u8(sixteen, 255, left) : vcmpneq_m_n_u8(sixteen, 255, left);
        if (found)
            return x + (uint32_t)__builtin_ctz(found);
    }
    return end;
}

/* F = 1.024 (1 - t) / (1 + t (n - 1.25) / 1.25)^2.  D = 2^23 (1 + ..) / sqrt(1.024). */
enum { HELIUM_D = 8289721, HELIUM_D_256_BY_5 = 424433723, HELIUM_FLOORS = 16 };

struct helium_four {
    int32x4_t nl, u;  /* N.L, Q30 of step 2's Q16; 2t - 2^31, t up to 2^31 - 1/2 */
    mve_pred16_t lit; /* F > 0 */
};

/* Every other one of eight normals: t and N.L as sample.c has them. */
GLINT_INLINE struct helium_four helium_sample(const struct glint_line_loop *loop, const struct glint_vec *normals)
{
    const uint32x4_t every_other = vidupq_n_u32(0, 4); /* 0, 4, 8, 12; times 3 */
    const uint32x4_t at = vmulq_n_u32(every_other, 3);
    const int16_t *const n = &normals->x;
    const int32x4_t x = vldrhq_gather_offset_s32(n, at), y = vldrhq_gather_offset_s32(n + 1, at),
                    z = vldrhq_gather_offset_s32(n + 2, at);
    const int32x4_t dot = vmlaq_n_s32(vmlaq_n_s32(vmulq_n_s32(x, loop->l[0]), y, loop->l[1]), z, loop->l[2]);
    const int32x4_t dx = vsubq_n_s32(x, loop->h[0]), dy = vsubq_n_s32(y, loop->h[1]), dz = vsubq_n_s32(z, loop->h[2]);
    const uint32x4_t xx = vreinterpretq_u32_s32(vmulq_s32(dx, dx)), yy = vreinterpretq_u32_s32(vmulq_s32(dy, dy)),
                     zz = vreinterpretq_u32_s32(vmulq_s32(dz, dz));
    struct helium_four four;
    four.nl = vreinterpretq_s32_u32(vshlq_n_u32(vrshrq_n_u32(vqshluq_n_s32(dot, 2), 16), 14)); /* held to 0..1 */
    four.u = vreinterpretq_s32_u32(vsubq_n_u32(vqaddq_u32(vqaddq_u32(xx, yy), zz), (uint32_t)1 << 31));
    four.lit = vcmpltq_m_n_s32(four.u, loop->t_end, vcmpgtq_n_s32(four.nl, 0));
    return four;
}

/* -2^30 F where it is lit. */
GLINT_INLINE int32x4_t helium_shine(const struct glint_line_loop *loop, const struct helium_four *four)
{
    const uint8_t *const reciprocals = (const uint8_t *)((uintptr_t)glint_reciprocals - 64);
    const int32x4_t d = vqrdmlahq_n_s32(vdupq_n_s32(loop->d), vshlq_r_s32(four->u, loop->up), loop->k);
    const int32x4_t up = vclsq_s32(d); /* to 2^30 .. 2^31 */
    const uint32x4_t m = vreinterpretq_u32_s32(vshlq_s32(d, up));
    const uint32x4_t y = vldrbq_gather_offset_z_u32(reciprocals, vshrq_n_u32(m, 24), four->lit);
    const int32x4_t r = vreinterpretq_s32_u32(vmulq_u32(vshrq_n_u32(m, 6), y)); /* (m >> 6) y = 2^32 (1 + r) */
    const int32x4_t p = vqdmlahq_n_s32(r, vqdmulhq_s32(r, r), -3 * (1 << 29));  /* r - 3/2 r^2 */
    const int32x4_t w = vreinterpretq_s32_u32(vshlq_u32(y, up));                /* nearly 2^38 / D */
    const int32x4_t b = vqdmulhq_s32(four->u, vmulq_s32(w, w));
    return vmaxq_s32(vsubq_s32(b, vqdmulhq_s32(b, p)), vdupq_n_s32(loop->f_max)); /* b (1 + r)^-2 */
}

/* The upper 16 bits of V of channel k, held below 1.0. They are rounded, and V's base has half a unit less: the narrowing that does not round,
 * VQSHRN, is assembled as the one that does by GNU as 2.40. */
GLINT_INLINE uint16x8_t helium_value(const struct glint_line_loop *loop, unsigned k, bool shines,
                                     const struct helium_four *even, const struct helium_four *odd,
                                     int32x4_t even_shine, int32x4_t odd_shine)
{
    const int32x4_t base = vdupq_n_s32((int32_t)loop->p[shines][k]);
    int32x4_t low = vqdmlahq_n_s32(base, even->nl, loop->q[k]), high = vqdmlahq_n_s32(base, odd->nl, loop->q[k]);
    if (shines) {
        low = vqdmlahq_m_n_s32(low, even_shine, loop->r[k], even->lit);
        high = vqdmlahq_m_n_s32(high, odd_shine, loop->r[k], odd->lit);
    }
    const uint16x8_t half = vqrshrnbq_n_u32(vuninitializedq_u16(), vreinterpretq_u32_s32(low), 14);
    return vqrshrntq_n_u32(half, vreinterpretq_u32_s32(high), 14);
}

GLINT_INLINE uint16x8_t helium_pixel(uint16x8_t red, uint16x8_t green, uint16x8_t blue)
{
    return vsriq_n_u16(vsriq_n_u16(red, green, 5), blue, 11);
}

/* Draws eight; the predicate of those that stay open. */
GLINT_INLINE mve_pred16_t helium_levels(const struct glint_line_loop *loop, bool shines, const struct helium_four *even,
                                        const struct helium_four *odd, int32x4_t even_shine, int32x4_t odd_shine,
                                        uint16_t *out)
{
    const uint16x8_t red = helium_value(loop, 0, shines, even, odd, even_shine, odd_shine),
                     green = helium_value(loop, 1, shines, even, odd, even_shine, odd_shine),
                     blue = helium_value(loop, 2, shines, even, odd, even_shine, odd_shine);
    const uint16_t *const width = loop->width[shines];
    uint16x8_t pixel = helium_pixel(red, green, blue);
    const mve_pred16_t open = vcmpneq_u16(
        pixel, helium_pixel(vqaddq_n_u16(red, width[0]), vqaddq_n_u16(green, width[1]), vqaddq_n_u16(blue, width[2])));
    if (loop->swapped)
        pixel = vreinterpretq_u16_u8(vrev16q_u8(vreinterpretq_u8_u16(pixel)));
    vstrhq_u16(out, pixel);
    return open;
}

/* Eight pixels from x on, of which those of `drawn` count, bit pairs; the pairs of those that are open. */
GLINT_INLINE uint32_t helium_eight(struct glint_line_loop *loop, const struct glint_vec *normals, uint16_t *out,
                                   uint32_t x, uint32_t drawn)
{
    const struct helium_four even = helium_sample(loop, normals), odd = helium_sample(loop, normals + 1);
    const uint32_t lit = helium_pairs(even.lit, odd.lit) & drawn;
    if (!lit)
        return helium_levels(loop, false, &even, &odd, even.nl, odd.nl, out) & drawn;
    const uint32_t first = x + ((uint32_t)__builtin_ctz(lit) >> 1), last = x + (31u - (uint32_t)__builtin_clz(lit)) / 2;
    loop->first = (uint16_t)(first < loop->first ? first : loop->first);
    loop->last = (uint16_t)(last > loop->last ? last : loop->last);
    return helium_levels(loop, true, &even, &odd, helium_shine(loop, &even), helium_shine(loop, &odd), out) & drawn;
}

/* The pixels that the bound leaves open, from bit pairs. */
static __attribute__((noinline)) void helium_open(const struct glint_paint *paint, const struct glint_run *run,
                                                  const struct glint_vec *normals, uint32_t i, uint32_t open)
{
    for (; open; i++, open >>= 2)
        if (open & 1) {
            struct glint_sample sample;
            glint_samples_half(&paint->l, &paint->v, &paint->h, normals + i, &sample, 1);
            glint_paint_exactly(paint, run, i, &sample);
        }
}

/* Fewer than eight, before copies of the last one. */
static __attribute__((noinline)) void helium_few(struct glint_line_loop *loop, const struct glint_paint *paint,
                                                 const struct glint_run *run, const struct glint_vec *normals,
                                                 uint32_t count)
{
    struct glint_vec eight[HELIUM_EIGHT];
    uint16_t pixels[HELIUM_EIGHT], *const out = (uint16_t *)(void *)run->line + run->x;
    for (uint32_t i = 0; i < HELIUM_EIGHT; i++)
        eight[i] = normals[i < count ? i : count - 1];
    const uint32_t open = helium_eight(loop, eight, pixels, run->x, (1u << 2 * count) - 1);
    for (uint32_t i = 0; i < count; i++)
        out[i] = pixels[i];
    helium_open(paint, run, normals, 0, open);
}

static void helium_line(struct glint_line_loop *loop, const struct glint_paint *paint, const struct glint_run *run,
                        const struct glint_vec *normals, uint32_t count)
{
    uint16_t *const out = (uint16_t *)(void *)run->line + run->x;
    if (count < HELIUM_EIGHT) {
        helium_few(loop, paint, run, normals, count);
        return;
    }
    for (uint32_t i = 0; i < count; i += HELIUM_EIGHT) {
        i = i < count - HELIUM_EIGHT ? i : count - HELIUM_EIGHT; /* the last eight: some of them twice */
        const uint32_t open = helium_eight(loop, normals + i, out + i, run->x + i, 0xffff);
        if (open)
            helium_open(paint, run, normals, i, open);
    }
}
/* a 2^bits / 255, rounded down: a < 2^31, bits <= 10. */
static uint32_t helium_by_255(uint32_t a, unsigned bits)
{
    return (a / 255 << bits) + (a % 255 << bits) / 255;
}

/* A coefficient by its light's colour. */
static uint32_t helium_tinted(uint32_t coefficient, uint32_t color_q16)
{
    const uint64_t tinted = (uint64_t)coefficient * color_q16 >> 16;
    return tinted > INT32_MAX ? (uint32_t)1 << 31 : (uint32_t)tinted;
}

/* Channel k; false where a coefficient is too large. */
static bool helium_fold(struct glint_line_loop *loop, const struct glint_paint *paint, unsigned k)
{
    const struct glint_material *const m = &paint->material;
    const uint32_t green = k == 1, max = green ? 63 : 31, color = paint->color_q16[k];
    const uint32_t a = m->albedo[k] * max; /* V of 1.0 is max 2^25, green 2^24 */
    const uint32_t p =
        helium_by_255(a * glint_coefficient(m->ambient_q16[k]), 9 - green) + ((uint32_t)1 << (24 - green));
    const uint32_t q = helium_by_255(a * glint_coefficient(m->diffuse_q16[k]), 10 - green);
    const uint32_t r = max * glint_coefficient(m->specular_q16[k]) << (10 - green);
    const uint32_t tinted_q = helium_tinted(q, color), tinted_r = helium_tinted(r, color);
    /* of F: its rounding, 1/2, and what helium_shine is off by, less than 5/16; a unit is 2^-17 r. Of a colour: two roundings */
    const uint32_t rounds = paint->of.exact.high ? (r >> 18) + (q >> 18) + 2 : 0;
    const uint32_t off = (uint32_t)((uint64_t)tinted_r * 13 >> 21) + 1 + rounds;
    loop->q[k] = (int32_t)tinted_q;
    loop->r[k] = -(int32_t)tinted_r;
    loop->p[0][k] = p - rounds - (1u << 13);
    loop->p[1][k] = p - off - (1u << 13);
    loop->width[0][k] = (uint16_t)((2 * rounds + HELIUM_FLOORS + (1u << 14) - 1) >> 14);
    loop->width[1][k] = (uint16_t)((2 * off + HELIUM_FLOORS + (1u << 14) - 1) >> 14);
    return tinted_q <= INT32_MAX && tinted_r <= INT32_MAX;
}

bool glint_line_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo)
{
    if (GLINT_FLASH_U8(paint->model->model) != GLINT_MSH || paint->output.dither || albedo)
        return false;
    const struct glint_vec l = paint->l, h = paint->h;
    const uint32_t t_end = 2 * paint->of.exact.t_end;                                             /* <= 2^31 */
    const int64_t slope = (int64_t)HELIUM_D_256_BY_5 * (4 * (int32_t)paint->of.exact.n - 5) >> 8; /* D's, a t of 1 */
    unsigned up = 0;
    while (t_end << up < (uint32_t)1 << 30)
        up++;
    const int64_t k = up ? (slope + ((int64_t)1 << (up - 1))) >> up : slope;
    if (k > INT32_MAX - HELIUM_D) /* D beyond 2^31, at large n with q = 13 or more */
        return false;
    loop->up = (int32_t)up;
    loop->k = (int32_t)k;
    loop->d = HELIUM_D + (up ? 0 : loop->k); /* u << 0 has -2^31 */
    loop->l[0] = l.x, loop->l[1] = l.y, loop->l[2] = l.z;
    loop->h[0] = h.x, loop->h[1] = h.y, loop->h[2] = h.z;
    loop->t_end = (int32_t)(t_end - ((uint32_t)1 << 31));
    loop->f_max = paint->of.exact.f_max == 65536 ? -((int32_t)1 << 30) : INT32_MIN;
    loop->swapped = paint->output.format == GLINT_RGB565_SWAPPED;
    loop->draw = helium_line;
    return helium_fold(loop, paint, 0) && helium_fold(loop, paint, 1) && helium_fold(loop, paint, 2);
}

/* ---- INT8 normals over COLOUR tables (glint_colour_int8 in fused_tables.c) ---- */

struct helium_place {
    int32x4_t d, e; /* sequence.md, Q29 */
};

/* Of four words: v and z are their halves, x the lowest byte. y_z: Y and Z in turns; one: 2^14 in the place of each Z. */
GLINT_INLINE struct helium_place helium_placed(const struct glint_paint *paint, uint32x4_t words, int16x8_t y_z,
                                               int16x8_t one)
{
    const int16x8_t halves = vreinterpretq_s16_u32(words);
    const int32x4_t x = vreinterpretq_s32_u32(vshlq_n_u32(words, 24));
    const int32x4_t v_z = vaddq_s32(vmullbq_int_s16(halves, y_z), vmulltq_int_s16(halves, y_z));
    struct helium_place place;
    place.d = vqdmlahq_n_s32(v_z, x, paint->of.tables.x * 128); /* |X| < 2^23, and 2^24 x 2^7 X >> 31 is x X */
    place.e = vsubq_n_s32(vaddq_s32(place.d, vmulltq_int_s16(halves, one)), paint->of.tables.cut);
    return place;
}

/* The upper halves of eight words, in the pixels' order. */
GLINT_INLINE uint16x8_t helium_upper(uint32x4_t even, uint32x4_t odd)
{
    return vreinterpretq_u16_u32(vsriq_n_u32(odd, even, 16));
}

GLINT_INLINE uint32x4_t helium_column(const struct glint_paint *paint, int32x4_t e)
{
    return vmulq_n_u32(vshlq_r_u32(vreinterpretq_u32_s32(e), -(int32_t)paint->of.tables.a), paint->of.tables.r);
}

/* Draws of eight pixels those from `from` on up to one without a surface: its number, or 8. */
GLINT_INLINE uint32_t helium_int8(const struct glint_paint *paint, const struct glint_look *look, int16x8_t y_z,
                                  int16x8_t one, const uint32_t *words, uint16_t *out, uint32_t from)
{
    const uint32x4x2_t both = vld2q_u32(words);
    const struct helium_place even = helium_placed(paint, both.val[0], y_z, one),
                              odd = helium_placed(paint, both.val[1], y_z, one);
    const uint16x8_t d = helium_upper(vreinterpretq_u32_s32(even.d), vreinterpretq_u32_s32(odd.d));
    const uint16x8_t e = helium_upper(vreinterpretq_u32_s32(even.e), vreinterpretq_u32_s32(odd.e));
    uint16x8_t at = vbicq_n_u16(d, (1 << GLINT_COLOUR_ROW_BYTES_LOG) - 1); /* d >> 23 << 7 */
    const mve_pred16_t within = vcmpgeq_n_s16(vreinterpretq_s16_u16(e), 0);
    if (within) {
        const uint16x8_t column = vshrq_n_u16(helium_upper(helium_column(paint, even.e), helium_column(paint, odd.e)),
                                              16 - GLINT_COLOUR_COLUMNS_LOG);
        at = vaddq_u16(at, vldrbq_gather_offset_z_u16(look->columns, column, within));
    }
    const uint16_t *const colours = (const uint16_t *)(const void *)look->colours;
    const mve_pred16_t lit = vcmpgeq_n_s16(vreinterpretq_s16_u16(d), 0);
    const uint16x8_t pixels = vpselq_u16(vldrhq_gather_offset_z_u16(colours, at, lit), vdupq_n_u16(look->dark), lit);
    const uint32_t all = vcmpeqq_n_u16(helium_upper(both.val[0], both.val[1]), 0), gaps = all >> 2 * from << 2 * from;
    if (gaps == 0 && from == 0) {
        vstrhq_u16(out, pixels);
        return HELIUM_EIGHT;
    }
    const uint32_t end = gaps ? (uint32_t)__builtin_ctz(gaps) : 16;
    vstrhq_p_u16(out, pixels, (mve_pred16_t)((1u << end) - (1u << 2 * from)));
    return end / 2;
}

typedef char glint_helium_rows[GLINT_COLOUR_ROW_SHIFT - 1 - GLINT_COLOUR_ROW_BYTES_LOG == 16 ? 1 : -1];

/* From pixel i on the first that has a surface, or w. */
static inline uint32_t helium_past_gaps(const uint32_t *words, uint32_t i, uint32_t w)
{
    while (i < w && words[i] >> 16 == 0)
        i += glint_gap(words[i], w - i);
    return i;
}

void glint_colour_int8(const struct glint_paint *paint, const uint32_t *words, uint32_t w, uint16_t *out)
{
    const struct glint_look look = glint_look_up(&paint->of.tables.filled);
    const int16x8_t y_z =
        vreinterpretq_s16_u32(vdupq_n_u32((uint32_t)paint->of.tables.z << 16 | (uint16_t)paint->of.tables.y));
    const int16x8_t one = vreinterpretq_s16_u32(vdupq_n_u32((uint32_t)1 << 30));
    if (w < HELIUM_EIGHT) {
        for (uint32_t i = 0; i < w; i++) {
            const struct glint_raw raw = glint_colour_raw(paint, words[i], GLINT_COLOUR_COLUMNS_LOG);
            if (raw.nl_q30 == GLINT_RAW_NOTHING)
                i += glint_gap(words[i], w - i) - 1;
            else
                out[i] = glint_look_pixel(&look, &raw, GLINT_NO_GLOSS);
        }
        return;
    }
    uint32_t i = helium_past_gaps(words, 0, w);
    while (i + HELIUM_EIGHT <= w) {
        const uint32_t drawn = helium_int8(paint, &look, y_z, one, words + i, out + i, 0);
        i += drawn;
        if (drawn < HELIUM_EIGHT)
            i = helium_past_gaps(words, i, w);
    }
    for (const uint32_t at = w - HELIUM_EIGHT; i < w; i = helium_past_gaps(words, i, w))
        i = at + helium_int8(paint, &look, y_z, one, words + at, out + at, i - at);
}
#endif
