/* SPDX-License-Identifier: MIT
 * Every format in linear space. The light x of step 7 is found as V, 65535 2^14 = 1.0, low by at most W; where V and V + W lead to
 * the same level, it is the pixel's. */
#include "glint_math_srgb.h"
#include "glint_pixel.h"
#include "glint_pixel_levels.h"

#define LINEAR_ONE UINT32_C(65535)
enum { LINEAR_BITS = 14, LINEAR_HALF = 1 << 13 };

/* A loop with the registers to itself. */
#define LINEAR_ALONE __attribute__((noinline)) static

static bool linear_draws(const struct glint_shader *shader)
{
    return shader->format < GLINT_FORMAT_COUNT && shader->space == GLINT_LINEAR;
}

/* V = P + Q nl + R F of a channel; Q and R come in 2^-14 of V, <= 2^28, all rounded down. With an albedo map P and Q are its
 * pixel's: ambient and diffuse are the coefficients.
 *
 * V is low by less than W: by 1 of P; with nl <= 2^16 and F <= 67109 by 4 of Q and 4.1 of R; by 1 of the lower products; by
 * R 2^-14 for each unit of the model's slack, and for 1 + 2^-6 units that F gloss / 255 is low by (glint_by_255); and in grey by
 * 256, 1 for each part. */
static void linear_fold(struct glint_prepared *p)
{
    const struct glint_material *m = &p->shader.material;
    const uint32_t slack = p->slack;
    p->w = p->w_maps = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t albedo = glint_srgb_decode(m->albedo[k]), s = glint_coefficient(m->specular_q16[k]);
        p->ambient[k] = glint_coefficient(m->ambient_q16[k]);
        p->diffuse[k] = glint_coefficient(m->diffuse_q16[k]);
        p->p[k] = albedo * p->ambient[k] >> 2;
        p->q[k] = albedo * p->diffuse[k] >> 4;
        p->r[k] = (s << 12) - ((s + 15) >> 4); /* s 65535 / 16 */
        const uint32_t unit = (p->r[k] >> 14) + 1, w = 11 + slack * unit + 256;
        const uint32_t w_maps = w + unit + (unit >> 6) + 1;
        p->w = w > p->w ? w : p->w;
        p->w_maps = w_maps > p->w_maps ? w_maps : p->w_maps;
    }
}

/* Step 6's parts of 256. */
static inline uint32_t linear_part(int k)
{
    return k == 0 ? GLINT_LUMA_RED : k == 1 ? GLINT_LUMA_GREEN : GLINT_LUMA_BLUE;
}

/* P, Q and R: with 1/2 of step 7 in P, Q and R as their upper bits and the lower 14. */
struct linear_parts {
    uint32_t p, q, q_low, r, r_low;
};
static inline struct linear_parts linear_parts_of(uint32_t p, uint32_t q, uint32_t r)
{
    const uint32_t low = (1 << LINEAR_BITS) - 1;
    const struct linear_parts parts = {p + LINEAR_HALF, q >> LINEAR_BITS, q & low, r >> LINEAR_BITS, r & low};
    return parts;
}

/* V + 1/2. Lower products: < 2^14 (2^16 + 67109) < 2^32 - 2^30. V <= 3.03 65535 2^14 < 2^32 - 2^26. */
static inline uint32_t linear_v(const struct linear_parts *v, uint32_t nl, uint32_t f)
{
    uint32_t upper = v->p + v->q * nl, lower = v->q_low * nl;
    if (f) {
        upper += v->r * f;
        lower += v->r_low * f;
    }
    return upper + (lower >> LINEAR_BITS);
}

/* Step 7's argument: V rounded, at most 1.0. */
static inline uint16_t linear_x(uint32_t v)
{
    const uint32_t x = v >> LINEAR_BITS;
    return (uint16_t)(x < LINEAR_ONE ? x : LINEAR_ONE);
}

/* A pixel's three levels; in the last one's place the argument of the channel at hand, until that is found. In grey the argument's
 * sum before. */
union linear_pixel {
    uint8_t levels[4];
    uint16_t x[2];
    uint32_t sum;
};

/* What channel k adds to a run: its argument, or in grey, held to 1.0, its parts of 256 to the sum. map: the channel's bytes of the
 * albedo map, or NULL. */
GLINT_INLINE void linear_sum(union linear_pixel *at, const struct glint_prepared *p, int k, const uint8_t *map,
                             const uint8_t *gloss, const struct glint_sample *sample, unsigned count, bool grey)
{
    const uint32_t part = linear_part(k);
    struct linear_parts parts = linear_parts_of(p->p[k], p->q[k], p->r[k]);
    for (union linear_pixel *end = at + count; at != end; at++, sample++) {
        if (map) {
            const uint32_t albedo = glint_srgb_decode(*map);
            const struct linear_parts here =
                linear_parts_of(albedo * p->ambient[k] >> 2, albedo * p->diffuse[k] >> 4, 0);
            parts.p = here.p;
            parts.q = here.q;
            parts.q_low = here.q_low;
            map += 3;
        }
        const uint32_t f = gloss ? glint_by_255(sample->f_q16 * *gloss++) : sample->f_q16;
        const uint32_t v = linear_v(&parts, sample->nl_q16, f);
        if (grey)
            at->sum += part * (glint_levels_hold(v - LINEAR_HALF, LINEAR_ONE << LINEAR_BITS) >> 8);
        else
            at->x[1] = linear_x(v);
    }
}

LINEAR_ALONE void linear_sum_rgb(union linear_pixel *at, const struct glint_prepared *p, int k,
                                 const struct glint_sample *sample, unsigned count)
{
    linear_sum(at, p, k, NULL, NULL, sample, count, false);
}

LINEAR_ALONE void linear_sum_grey(union linear_pixel *at, const struct glint_prepared *p, int k,
                                  const struct glint_sample *sample, unsigned count)
{
    linear_sum(at, p, k, NULL, NULL, sample, count, true);
}

LINEAR_ALONE void linear_sum_maps(union linear_pixel *at, const struct glint_prepared *p, int k,
                                  const struct glint_run *run, const struct glint_sample *sample, unsigned count)
{
    const uint8_t *map = run->albedo ? run->albedo + k : NULL;
    linear_sum(at, p, k, map, run->gloss, sample, count, glint_format_is_grey(p->shader.format));
}

/* Arguments from grey's sums. */
LINEAR_ALONE void linear_arguments(union linear_pixel *at, unsigned count)
{
    for (const union linear_pixel *end = at + count; at != end; at++)
        at->x[1] = linear_x(at->sum);
}

/* Step 8 by its level times 2^16: z / 65535 without a division. */
GLINT_INLINE uint32_t linear_level(uint32_t encoded, uint32_t max, uint32_t threshold)
{
    const uint32_t z = encoded * max + threshold;
    return z + (z >> 16) + 1;
}

/* From V to V + W the argument of step 7 rises by at most so much. */
static inline uint32_t linear_steps(const struct glint_prepared *p, const struct glint_run *run)
{
    return ((run->gloss ? p->w_maps : p->w) >> LINEAR_BITS) + 1;
}

/* Step 8's threshold, and the largest level of channel k. */
static inline uint32_t linear_threshold(const struct glint_prepared *p, const struct glint_run *run, unsigned i)
{
    return LINEAR_ONE * glint_exact_weight(&p->shader, run->left + run->x + i, run->y) >> 5;
}
static inline uint32_t linear_max(const struct glint_prepared *p, int k)
{
    return GLINT_FLASH_U8(glint_exact_formats[p->shader.format].max[k]);
}

/* Steps 7 and 8 for a run: levels; the bits of those that may be another at V + W, whose arguments stay. The last pixel's chords
 * mostly serve the next. Step 8's sum rises by less than margin, as no chord is steeper than its octave's first. Dithered, every
 * fourth pixel has the same threshold. */
LINEAR_ALONE uint32_t linear_encode(union linear_pixel *pixels, unsigned count, const struct glint_prepared *p,
                                    const struct glint_run *run, int k)
{
    const uint32_t max = linear_max(p, k), steps = linear_steps(p, run);
    const unsigned stride = p->shader.dither ? 4 : 1;
    const uint16_t *entry = NULL;
    uint32_t near = 0, margin = 0, bits = 31;
    for (unsigned phase = 0; phase < stride; phase++) {
        const uint32_t t = linear_threshold(p, run, phase);
        for (union linear_pixel *at = pixels + phase, *end = pixels + count; at < end; at += stride) {
            const uint32_t x = at->x[1], chord = x >> bits, n = chord - 32;
            uint32_t encoded;
            if (__builtin_expect(n < 32, 1)) {
                encoded = glint_srgb_bright(entry + n, x - (chord << bits), bits);
            } else {
                struct glint_chords chords;
                glint_srgb_chords(&chords, x);
                encoded = glint_srgb_by(&chords, x);
                entry = chords.entry;
                bits = chords.bits;
                const uint32_t rise = (uint32_t)(GLINT_FLASH_U16(entry[1]) - GLINT_FLASH_U16(entry[0]));
                margin = (steps * ((rise >> bits) + 1) + 1) * max + 2;
            }
            const uint32_t found = linear_level(encoded, max, t);
            if (__builtin_expect(((found ^ (found + margin)) >> 16) == 0, 1))
                at->levels[k] = (uint8_t)(found >> 16);
            else
                near |= (uint32_t)1 << (at - pixels);
        }
    }
    return near;
}

/* The levels of those alone: the bits of what is another level at V + W. */
LINEAR_ALONE uint32_t linear_settle(union linear_pixel *at, uint32_t near, const struct glint_sample *sample,
                                    const struct glint_prepared *p, const struct glint_run *run, int k)
{
    const uint32_t max = linear_max(p, k), steps = linear_steps(p, run);
    const bool grey = glint_format_is_grey(p->shader.format);
    uint32_t open = 0;
    for (unsigned i = 0; near >> i; i++, at++, sample++) {
        if (!(near >> i & 1))
            continue;
        const uint32_t x = at->x[1], most = x + steps < LINEAR_ONE ? x + steps : LINEAR_ONE,
                       t = linear_threshold(p, run, i);
        const uint32_t found = linear_level(glint_srgb_encode((uint16_t)x), max, t) >> 16;
        /* With nl = 0 V is P alone, rounded down by less than 1, and so x is exact. Not in grey, which sums parts of P. */
        if ((sample->nl_q16 || grey) && linear_level(glint_srgb_encode((uint16_t)most), max, t) >> 16 != found)
            open |= (uint32_t)1 << i;
        at->levels[k] = (uint8_t)found;
    }
    return open;
}

/* Levels of a run: the bits of those that are open. */
static inline uint32_t linear_decide(union linear_pixel *pixels, const struct glint_sample *samples, unsigned count,
                                     const struct glint_prepared *p, const struct glint_run *run, int k)
{
    const uint32_t near = linear_encode(pixels, count, p, run, k);
    return near ? linear_settle(pixels, near, samples, p, run, k) : 0;
}

/* Grey's levels side by side. */
static inline void linear_pack(union linear_pixel *pixels, unsigned count)
{
    uint8_t *const levels = (uint8_t *)pixels;
    for (unsigned i = 1; i < count; i++)
        levels[i] = levels[4 * i];
}

static uint32_t linear_levels(const struct glint_prepared *p, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    const bool grey = glint_format_is_grey(p->shader.format), maps = run->albedo || run->gloss;
    union linear_pixel pixels[GLINT_RUN + 3]; /* a step of 4 may end 3 past the last */
    uint32_t open = 0;
    if (grey) {
        for (unsigned i = 0; i < count; i++)
            pixels[i].sum = LINEAR_HALF;
        for (int k = 0; k < 3; k++)
            if (maps)
                linear_sum_maps(pixels, p, k, run, samples, count);
            else
                linear_sum_grey(pixels, p, k, samples, count);
        linear_arguments(pixels, count);
        open = linear_decide(pixels, samples, count, p, run, 0);
        linear_pack(pixels, count);
    } else {
        for (int k = 0; k < 3; k++, samples += p->apart) {
            if (maps)
                linear_sum_maps(pixels, p, k, run, samples, count);
            else
                linear_sum_rgb(pixels, p, k, samples, count);
            open |= linear_decide(pixels, samples, count, p, run, k);
        }
    }
    glint_exact_store_run(p->shader.format, run->line, run->x, (const uint8_t *)pixels, count, open);
    glint_levels_alpha(p->shader.format, run, 0, count);
    return open;
}

/* Channel by channel, to keep the stack low. */
static void linear_exact(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                         uint32_t f_q16)
{
    const uint8_t *albedo = run->albedo ? run->albedo + 3 * i : shader->material.albedo;
    const uint32_t gloss = (run->gloss ? run->gloss[i] : 255) * 257u;
    const uint32_t weight = glint_exact_weight(shader, run->left + run->x + i, run->y);
    const bool grey = glint_format_is_grey(shader->format);
    uint64_t sum = 0;
    uint8_t levels[4];
    for (int k = 0; k < 3; k++) {
        const uint64_t v =
            glint_exact_value(&shader->material, k, glint_srgb_decode(albedo[k]), nl_q16, (uint64_t)gloss * f_q16);
        sum = grey ? sum + v * linear_part(k) : v << 8;
        levels[k] = glint_pixel_level(shader, sum >> 8, k, weight);
    }
    levels[0] = levels[grey ? 2 : 0];
    glint_exact_store(shader->format, run->line, run->x + i, levels);
}

const struct glint_shade_format glint_shade_linear GLINT_FLASH = {linear_draws, linear_fold, linear_levels,
                                                                  linear_exact, NULL};
