/* SPDX-License-Identifier: MIT
 * Internal. Gamma space: one description of the formats' fold and of their loop.
 *
 * Channel k's part of a level is V 2^-shift; without maps V = P + Q nl + R F, with them
 * V = (albedo (ambient + diffuse nl) >> 7) + R (F gloss / 255), held to MOST. In RGB a part is a level, and in grey their sum is. */
#ifndef GLINT_PIXEL_LEVELS_H
#define GLINT_PIXEL_LEVELS_H

#include "glint_pixel_exact.h"
#include "glint_pixel_prepared.h"

/* A kind of pixel: the largest level of each channel, and of 256 how much of it a channel is: 256 each, or the luma. */
struct glint_levels_kind {
    uint8_t max[3];
    uint16_t part[3];
};

/* P, Q, R and W; with the threshold of an undithered level in P, where the loop adds none. */
void glint_levels_fold(struct glint_prepared *prepared, struct glint_levels_kind kind, bool threshold);

/* The thresholds of four pixels side by side, times 2^shift, 2^(shift - 5) or more, less what V may be high by, < 2^(shift - 7). */
void glint_levels_bias(uint32_t bias[4], const struct glint_prepared *prepared, const struct glint_run *run);

/* P of the channels of four pixels side by side, each with its pixel's threshold. */
void glint_levels_base(uint32_t base[12], const struct glint_prepared *prepared, const struct glint_run *run);

/* Steps 4 to 6 of a sample, in 64 bits. */
void glint_levels_exact(uint64_t v[3], const struct glint_shader *shader, const struct glint_run *run, unsigned i,
                        uint32_t nl_q16, uint32_t f_q16);

#define GLINT_INLINE static inline __attribute__((always_inline))

/* x / 255 for x <= 33/16 2^16 255, as lights sum to: low by < 1 + 2^-6, never high (tests/proof). 1 / 255 = 2^-8 + 2^-16 + 2^-24 + .. */
GLINT_INLINE uint32_t glint_by_255(uint32_t x)
{
    return (x + (x >> 8) + (x >> 16)) >> 8;
}

/* V of a sample's channels, without maps from `base`. What the compiler is told of maps decides what is left of it. */
GLINT_INLINE void glint_levels_sum(uint32_t v[3], const struct glint_prepared *p, const uint32_t base[3],
                                   const struct glint_sample *sample, const uint8_t *albedo, const uint8_t *gloss,
                                   bool maps)
{
    const uint32_t nl = sample->nl_q16;
    uint32_t f = sample->f_q16;
    if (maps) {
        if (gloss)
            f = glint_by_255(f * *gloss);
        v[0] = (albedo[0] * ((p->ambient[0] + p->diffuse[0] * nl) >> 7)) + p->r[0] * f;
        v[1] = (albedo[1] * ((p->ambient[1] + p->diffuse[1] * nl) >> 7)) + p->r[1] * f;
        v[2] = (albedo[2] * ((p->ambient[2] + p->diffuse[2] * nl) >> 7)) + p->r[2] * f;
    } else {
        v[0] = base[0] + p->q[0] * nl + p->r[0] * f;
        v[1] = base[1] + p->q[1] * nl + p->r[1] * f;
        v[2] = base[2] + p->q[2] * nl + p->r[2] * f;
    }
}

/* V held to the largest level: W < 2^shift then changes no bit of it. */
GLINT_INLINE uint32_t glint_levels_hold(uint32_t v, uint32_t most)
{
    if (__builtin_expect(v > most, 0))
        v = most;
    return v;
}

/* Alpha of samples i.., where the format has one. */
GLINT_INLINE void glint_levels_alpha(uint8_t format, const struct glint_run *run, unsigned i, unsigned count)
{
    if (format >= GLINT_XRGB8888)
        glint_exact_alpha(format, run->line, run->x + i, count, run->mask);
}

enum glint_levels_order { GLINT_LEVELS_565, GLINT_LEVELS_RED_FIRST, GLINT_LEVELS_BLUE_FIRST };

/* The loop of RGB. */
GLINT_INLINE uint32_t glint_levels_rgb(const struct glint_prepared *p, const struct glint_run *run,
                                       const struct glint_sample *sample, unsigned count, enum glint_levels_order order,
                                       bool maps, bool dither)
{
    const bool deep = order != GLINT_LEVELS_565;
    const unsigned shift = (unsigned)p->shift;
    const uint32_t w = maps ? p->w_maps : p->w;
    const uint32_t most = (uint32_t)(deep ? 255 : 31) << shift, most_green = (uint32_t)(deep ? 255 : 63) << shift;
    const uint8_t *albedo = maps && run->albedo ? run->albedo : p->shader.material.albedo, *gloss = run->gloss;
    const unsigned step = maps && run->albedo ? 3 : 0;
    const bool swapped = p->shader.format == GLINT_RGB565_SWAPPED;
    const unsigned red_at = order == GLINT_LEVELS_BLUE_FIRST ? 2 : 0;
    const unsigned bytes = !deep ? 2 : order == GLINT_LEVELS_BLUE_FIRST && p->shader.format != GLINT_BGR888 ? 4 : 3;
    uint8_t *out = run->line + bytes * run->x + (swapped ? 1 : 0);
    const ptrdiff_t other = swapped ? -1 : 1;
    uint32_t bias[4], bases[12], open = 0;
    const uint32_t *base = p->p;
    const bool turns = !maps && dither && (!deep || p->shader.dither); /* from a pixel's base to the next's */
    if (maps) {
        glint_levels_bias(bias, p, run);
    } else if (turns) {
        glint_levels_base(bases, p, run);
        base = bases;
    }
    const struct glint_sample *const first = sample, *const end = sample + count;
    for (unsigned next = 0; sample != end; sample++, out += bytes) {
        const unsigned i = maps ? next++ : 0; /* else it is found where a pixel stays open */
        uint32_t v[3];
        glint_levels_sum(v, p, base, sample, albedo, gloss ? gloss + i : gloss, maps);
        const uint32_t threshold = maps ? bias[i & 3] : 0;
        const uint32_t red = glint_levels_hold(v[0] + threshold, most);
        const uint32_t green = glint_levels_hold(v[1] + threshold, most_green);
        const uint32_t blue = glint_levels_hold(v[2] + threshold, most);
        albedo += maps ? step : 0;
        if (((red ^ (red + w)) | (green ^ (green + w)) | (blue ^ (blue + w))) >> shift) {
            open |= (uint32_t)1 << (sample - first);
        } else if (deep) {
            out[red_at] = (uint8_t)(red >> shift);
            out[1] = (uint8_t)(green >> shift);
            out[2 - red_at] = (uint8_t)(blue >> shift);
        } else {
            const uint32_t pixel = red >> shift << 11 | green >> shift << 5 | blue >> shift;
            out[0] = (uint8_t)pixel;
            out[other] = (uint8_t)(pixel >> 8);
        }
        if (turns) {
            base += 3;
            if (base == bases + 12)
                base = bases;
        }
    }
    return open;
}

#endif
