/* SPDX-License-Identifier: MIT
 * Every format in linear space. The light x of step 7 is found as V, 65535 2^shift = 1.0, low by at most W; where V and V + W lead to
 * the same level, it is the pixel's. The shift is 14, and less where a light is so bright that V would not fit. */
#include "glint_pixel.h"
#include "glint_math.h"

#define LINEAR_ONE UINT32_C(65535)
#define LINEAR_FRACTION GLINT_LINEAR_FRACTION

/* A loop with the registers to itself. */
#define LINEAR_ALONE __attribute__((noinline)) static

static bool linear_draws(const struct glint_output *output)
{
    return output->space == GLINT_LINEAR;
}

/* By how much V is shifted down, of 14, so that V < 2^32 - 2^26: 3.03 65535 2^14 for light of 1.0. */
static unsigned linear_less(const struct glint_material *m, const struct glint_coefficients *c, unsigned up)
{
    uint32_t most = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t s = c->s[k];
        const uint32_t sum = glint_coefficient(m->ambient_q16[k]) + ((c->d[k] + s + (s >> 5) + 1) << up);
        most = sum > most ? sum : most;
    }
    unsigned less = 0;
    while (most >> less > 3 * 65536 + 2304)
        less++;
    return less; /* <= up <= 4 */
}

/* V = P + Q nl + R F of a channel; Q and R come in 2^-14 of V, <= 2^28 for light of 1.0, all rounded down. With an albedo map P and Q are
 * its pixel's: ambient and diffuse are the coefficients, and up is kept beside the shift.
 *
 * V is low by less than W: by 1 of P; with nl <= 2^16 and F <= 67109 by 4 of Q and 4.1 of R, times 2^up; by 1 of the lower products; by
 * R 2^-14 for each unit of the model's slack, and for 1 + 2^-6 units that F gloss / 255 is low by (glint_by_255); by Q 2^-14 for the unit that
 * sums of several lights are low by where they come shifted down; in grey by 255, with 1 more for what unit >> 6 cuts (tests/proof); and
 * of a coloured light by what is taken off and what its coefficients lack: glint_paint_fold. */
static void linear_fold(struct glint_paint *p, const struct glint_coefficients *c, unsigned up)
{
    const struct glint_material *m = &p->material;
    const unsigned less = linear_less(m, c, up);
    const uint32_t slack = p->of.exact.slack;
    p->of.exact.shift = (GLINT_LINEAR_SHIFT - less) | up << 8;
    p->of.exact.w = p->of.exact.w_maps = 0;
    for (int k = 0; k < 3; k++) {
        const uint32_t albedo = glint_srgb_decode(m->albedo[k]), s = c->s[k];
        p->of.exact.ambient[k] = glint_coefficient(m->ambient_q16[k]);
        p->of.exact.diffuse[k] = c->d[k];
        p->of.exact.p[k] = albedo * p->of.exact.ambient[k] >> (2 + less);
        p->of.exact.q[k] = albedo * p->of.exact.diffuse[k] >> (4 + less - up);
        p->of.exact.r[k] = ((s << 12) - ((s + 15) >> 4)) << (up - less); /* s 65535 / 16 */
        const uint32_t unit = (p->of.exact.r[k] >> LINEAR_FRACTION) + 1;
        const uint32_t w =
            2 + ((uint32_t)9 << up) + slack * unit + 256 + (p->of.exact.nl_down ? ((uint32_t)1 << 14) + 1 : 0);
        const uint32_t w_maps = w + unit + (unit >> 6);
        p->of.exact.w = w > p->of.exact.w ? w : p->of.exact.w;
        p->of.exact.w_maps = w_maps > p->of.exact.w_maps ? w_maps : p->of.exact.w_maps;
    }
}

/* P, Q and R: with 1/2 of step 7 in P, Q and R as their upper bits and the lower 14. */
struct linear_parts {
    uint32_t p, q, q_low, r, r_low;
};
static inline struct linear_parts linear_parts_of(uint32_t p, uint32_t q, uint32_t r, unsigned shift)
{
    const uint32_t low = (1 << LINEAR_FRACTION) - 1;
    const struct linear_parts parts = {p + ((uint32_t)1 << shift >> 1), q >> LINEAR_FRACTION, q & low,
                                       r >> LINEAR_FRACTION, r & low};
    return parts;
}

/* V's shift. */
static inline unsigned linear_shift(const struct glint_paint *paint)
{
    return (unsigned)(paint->of.exact.shift & 255);
}

/* V + 1/2. Lower products: < 2^14 (2^16 + 67109) < 2^32 - 2^30. V <= 3.03 65535 2^14 < 2^32 - 2^26. */
static inline uint32_t linear_v(const struct linear_parts *v, uint32_t nl, uint32_t f)
{
    uint32_t upper = v->p + v->q * nl, lower = v->q_low * nl;
    if (f) {
        upper += v->r * f;
        lower += v->r_low * f;
    }
    return upper + (lower >> LINEAR_FRACTION);
}

/* Step 7's argument: V rounded, at most 1.0. */
static inline uint16_t linear_x(uint32_t v, unsigned shift)
{
    const uint32_t x = v >> shift;
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
 * albedo map, or NULL. high: what V may be high by where nl is not 0. */
GLINT_INLINE void linear_sum(union linear_pixel *at, const struct glint_paint *paint, unsigned k, const uint8_t *map,
                             const uint8_t *gloss, const struct glint_sample *sample, unsigned count, bool grey,
                             uint32_t high)
{
    const unsigned shift = linear_shift(paint), up = (unsigned)(paint->of.exact.shift >> 8),
                   less = GLINT_LINEAR_SHIFT - shift;
    const uint32_t part = glint_luma(k), half = (uint32_t)1 << shift >> 1;
    struct linear_parts parts =
        linear_parts_of(paint->of.exact.p[k], paint->of.exact.q[k], paint->of.exact.r[k], shift);
    for (union linear_pixel *end = at + count; at != end; at++, sample++) {
        if (map) {
            const uint32_t albedo = glint_srgb_decode(*map);
            const struct linear_parts here =
                linear_parts_of(albedo * paint->of.exact.ambient[k] >> (2 + less),
                                albedo * paint->of.exact.diffuse[k] >> (4 + less - up), 0, shift);
            parts.p = here.p;
            parts.q = here.q;
            parts.q_low = here.q_low;
            map += 3;
        }
        const uint32_t f = gloss ? glint_by_255(sample->f_q16 * *gloss++) : sample->f_q16;
        uint32_t v = linear_v(&parts, sample->nl_q16, f);
        if (high && sample->nl_q16)
            v = v - half < high ? half : v - high;
        if (grey)
            at->sum += part * (glint_levels_hold(v - half, LINEAR_ONE << shift) >> 8);
        else
            at->x[1] = linear_x(v, shift);
    }
}

LINEAR_ALONE void linear_sum_rgb(union linear_pixel *at, const struct glint_paint *paint, unsigned k,
                                 const struct glint_sample *sample, unsigned count)
{
    linear_sum(at, paint, k, NULL, NULL, sample, count, false, 0);
}

LINEAR_ALONE void linear_sum_grey(union linear_pixel *at, const struct glint_paint *paint, unsigned k,
                                  const struct glint_sample *sample, unsigned count)
{
    linear_sum(at, paint, k, NULL, NULL, sample, count, true, 0);
}

/* With maps, or under a coloured light. */
LINEAR_ALONE void linear_sum_maps(union linear_pixel *at, const struct glint_paint *paint, unsigned k,
                                  const struct glint_run *run, const struct glint_sample *sample, unsigned count)
{
    const uint8_t *map = run->albedo ? run->albedo + k : NULL;
    linear_sum(at, paint, k, map, run->gloss, sample, count, glint_format_is_grey(paint->output.format),
               (uint32_t)paint->of.exact.high << linear_shift(paint));
}

/* Arguments from grey's sums. */
LINEAR_ALONE void linear_arguments(union linear_pixel *at, unsigned count, unsigned shift)
{
    for (const union linear_pixel *end = at + count; at != end; at++)
        at->x[1] = linear_x(at->sum, shift);
}

/* Step 8 by its level times 2^16: z / 65535 without a division. */
GLINT_INLINE uint32_t linear_level(uint32_t encoded, uint32_t max, uint32_t threshold)
{
    const uint32_t z = encoded * max + threshold;
    return z + (z >> 16) + 1;
}

/* From V to V + W the argument of step 7 rises by at most so much. */
static inline uint32_t linear_steps(const struct glint_paint *p, const struct glint_run *run)
{
    return ((run->gloss ? p->of.exact.w_maps : p->of.exact.w) >> linear_shift(p)) + 1;
}

/* Step 8's threshold, and the largest level of channel k. */
static inline uint32_t linear_threshold(const struct glint_paint *p, const struct glint_run *run, unsigned i)
{
    return LINEAR_ONE * glint_weight(p, run, i) >> 5;
}
static inline uint32_t linear_max(const struct glint_paint *p, unsigned k)
{
    return GLINT_FLASH_U8(glint_formats[p->output.format].max[k]);
}

/* Steps 7 and 8 for a run: levels; the bits of those that may be another at V + W, whose arguments stay. The last pixel's chords
 * mostly serve the next. Step 8's sum rises by less than margin, as no chord is steeper than its octave's first. Dithered, every
 * fourth pixel has the same threshold. */
LINEAR_ALONE uint32_t linear_encode(union linear_pixel *pixels, unsigned count, const struct glint_paint *p,
                                    const struct glint_run *run, unsigned k)
{
    const uint32_t max = linear_max(p, k), steps = linear_steps(p, run);
    const unsigned stride = p->output.dither ? 4 : 1;
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
                margin = steps * ((rise >> bits) + 1) * max + 2;
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

/* Steps 7 and 8 from an argument. */
LINEAR_ALONE uint32_t linear_found(const struct glint_paint *p, const struct glint_run *run, unsigned i, unsigned k,
                                   uint32_t x)
{
    const uint32_t encoded = glint_srgb_encode((uint16_t)x);
    if (run->soft)
        return GLINT_FLASH_POINTER(run->soft->level)(p, run, i, k, (uint64_t)encoded << 32);
    return linear_level(encoded, linear_max(p, k), linear_threshold(p, run, i)) >> 16;
}

#if GLINT_CORTEX_M0PLUS_ASM
/* Step 7's argument, of a sample without maps, V not shifted down. */
LINEAR_ALONE uint32_t linear_argument(const struct glint_paint *p, const struct glint_sample *sample, unsigned k)
{
    const struct linear_parts parts =
        linear_parts_of(p->of.exact.p[k], p->of.exact.q[k], p->of.exact.r[k], GLINT_LINEAR_SHIFT);
    return linear_x(linear_v(&parts, sample->nl_q16, sample->f_q16), GLINT_LINEAR_SHIFT);
}
#else
#define linear_argument(p, sample, k) 0 /* nothing packs levels before */
#endif

/* The levels of those alone: the bits of what is another level at V + W. has_levels: levels have taken the arguments' places. */
LINEAR_ALONE uint32_t linear_settle(union linear_pixel *at, bool has_levels, uint32_t near,
                                    const struct glint_sample *sample, const struct glint_paint *p,
                                    const struct glint_run *run, unsigned k)
{
    const uint32_t steps = linear_steps(p, run);
    uint32_t open = 0;
    for (unsigned i = 0; near >> i; i++, at++, sample++) {
        if (!(near >> i & 1))
            continue;
        const uint32_t x = GLINT_CORTEX_M0PLUS_ASM && has_levels ? linear_argument(p, sample, k) : at->x[1];
        const uint32_t most = x + steps < LINEAR_ONE ? x + steps : LINEAR_ONE;
        const uint32_t found = linear_found(p, run, i, k, x);
        /* With nl = 0 V is P alone, rounded down by less than 1, and so x is exact. Not in grey, which sums parts of P (and whose
         * samples lie before: none is read here). */
        if ((glint_format_is_grey(p->output.format) || sample->nl_q16) && linear_found(p, run, i, k, most) != found)
            open |= (uint32_t)1 << i;
        at->levels[k] = (uint8_t)found;
    }
    return open;
}

#if GLINT_CORTEX_M0PLUS_ASM
/* What cortex_m0plus_linear.S takes: words in this order. */
struct linear_channels {
    const uint32_t *of; /* P, Q and R of the paint, side by side */
    uint32_t steps;
    const uint16_t *entries; /* the first octave's */
    uint32_t near[3];        /* the largest level; then the bits of what is near */
};
#define CHANNELS_AT(field, offset) (offsetof(struct linear_channels, field) == (offset))
typedef char linear_layout[CHANNELS_AT(of, GLINT_AT_CHANNELS_OF) && CHANNELS_AT(steps, GLINT_AT_CHANNELS_STEPS) &&
                                   CHANNELS_AT(entries, GLINT_AT_CHANNELS_ENTRIES) &&
                                   CHANNELS_AT(near, GLINT_AT_CHANNELS_NEAR) && sizeof(union linear_pixel) == 4
                               ? 1
                               : -1];
#undef CHANNELS_AT
void glint_linear_levels(union linear_pixel *pixels, const struct glint_sample *samples, unsigned count,
                         struct linear_channels *channels);

/* Levels of a run of RGB, undithered, without maps, V not shifted down. Behind the run's pixels, of each channel, the bits of what is near. */
LINEAR_ALONE void linear_rgb(union linear_pixel *pixels, const struct glint_sample *samples, unsigned count,
                             const struct glint_paint *p, const struct glint_run *run)
{
    struct linear_channels channels;
    struct glint_chords chords;
    glint_srgb_chords(&chords, 0);
    channels.of = p->of.exact.p;
    channels.steps = linear_steps(p, run);
    channels.entries = chords.entry;
    for (unsigned k = 0; k < 3; k++)
        channels.near[k] = linear_max(p, k);
    glint_linear_levels(pixels, samples, count, &channels);
    for (unsigned k = 0; k < 3; k++)
        pixels[GLINT_RUN + k].sum = channels.near[k];
}
#endif

/* Levels of a run: the bits of those that are open. */
static inline uint32_t linear_decide(union linear_pixel *pixels, const struct glint_sample *samples, unsigned count,
                                     const struct glint_paint *p, const struct glint_run *run, unsigned k)
{
    const uint32_t near = run->soft ? ((uint32_t)1 << count) - 1 : linear_encode(pixels, count, p, run, k);
    return near ? linear_settle(pixels, false, near, samples, p, run, k) : 0;
}

/* Grey's levels side by side. */
static inline void linear_pack(union linear_pixel *pixels, unsigned count)
{
    uint8_t *const levels = (uint8_t *)pixels;
    for (unsigned i = 1; i < count; i++)
        levels[i] = levels[4 * i];
}

static uint32_t linear_levels(const struct glint_paint *p, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    const bool grey = glint_format_is_grey(p->output.format), maps = run->albedo || run->gloss || p->of.exact.high;
    const unsigned shift = linear_shift(p);
    union linear_pixel pixels[GLINT_RUN + 3]; /* a step of 4 may end 3 past the last */
    uint32_t open = 0;
    if (grey) {
        for (unsigned i = 0; i < count; i++)
            pixels[i].sum = (uint32_t)1 << shift >> 1;
        for (unsigned k = 0; k < 3; k++, samples += run->apart)
            if (maps)
                linear_sum_maps(pixels, p, k, run, samples, count);
            else
                linear_sum_grey(pixels, p, k, samples, count);
        linear_arguments(pixels, count, shift);
        open = linear_decide(pixels, samples, count, p, run, 0);
        linear_pack(pixels, count);
#if GLINT_CORTEX_M0PLUS_ASM
    } else if (!maps && !run->apart && !run->soft && !p->output.dither && shift == GLINT_LINEAR_SHIFT) {
        linear_rgb(pixels, samples, count, p, run);
        for (unsigned k = 0; k < 3; k++)
            if (pixels[GLINT_RUN + k].sum)
                open |= linear_settle(pixels, true, pixels[GLINT_RUN + k].sum, samples, p, run, k);
#endif
    } else {
        for (unsigned k = 0; k < 3; k++, samples += run->apart) {
            if (maps)
                linear_sum_maps(pixels, p, k, run, samples, count);
            else
                linear_sum_rgb(pixels, p, k, samples, count);
            open |= linear_decide(pixels, samples, count, p, run, k);
        }
    }
    glint_store_run(p->output.format, run->line, run->x, (const uint8_t *)pixels, count, open);
    glint_levels_alpha(p->output.format, run, 0, count);
    return open;
}

/* Channel by channel, to keep the stack low. */
static void linear_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                         const struct glint_sample *sample, unsigned apart)
{
    const uint8_t format = paint->output.format;
    const uint8_t *albedo = run->albedo ? run->albedo + 3 * i : paint->material.albedo;
    const uint32_t gloss = (run->gloss ? run->gloss[i] : 255) * 257u;
    const bool grey = glint_format_is_grey(format);
    uint64_t parts = 0;
    uint8_t levels[4];
    for (unsigned k = 0; k < 3; k++, sample += apart) {
        const uint64_t v = glint_exact_value(&paint->material, k, glint_srgb_decode(albedo[k]), sample->nl_q16,
                                             (uint64_t)gloss * sample->f_q16);
        parts = grey ? parts + v * glint_luma(k) : v << 8;
        const uint16_t x = (uint16_t)(((parts >> 8) + ((uint64_t)1 << 31)) >> 32);
        if (!grey || k == 2)
            levels[k] = (uint8_t)linear_found(paint, run, i, grey ? 0 : k, x);
    }
    levels[0] = levels[grey ? 2 : 0];
    glint_store_run(format, run->line, run->x + i, levels, 1, 0);
}

const struct glint_use_format glint_use_linear GLINT_FLASH = {linear_draws, linear_fold, linear_levels, linear_exact,
                                                              NULL};

static uint32_t linear_steps_levels(const struct glint_paint *paint, const struct glint_run *run,
                                    const struct glint_sample *samples, unsigned count)
{
    return run->albedo || run->gloss || run->soft ? linear_levels(paint, run, samples, count)
                                                  : glint_levels_steps(linear_levels, paint, run, samples, count);
}

static void linear_steps_fold(struct glint_paint *paint, const struct glint_coefficients *c, unsigned up)
{
    paint->format = &glint_use_linear;
    linear_fold(paint, c, up);
}

const struct glint_use_format glint_use_linear_steps GLINT_FLASH = {linear_draws, linear_steps_fold,
                                                                    linear_steps_levels, linear_exact, NULL};
