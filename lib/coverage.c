/* SPDX-License-Identifier: MIT
 * Coverage: pixels that are blended over what the buffer holds, step 8 of sequence.md. */
#include "glint_tables.h"

#ifdef __GNUC__
typedef uint32_t __attribute__((may_alias)) coverage_word;
#else
typedef uint32_t coverage_word;
#endif

/* ---- Step 8 ---- */

/* Level k of pixel x of a line. */
static uint32_t coverage_under(uint8_t format, const uint8_t *line, uint32_t x, unsigned k)
{
    const unsigned bits = GLINT_FLASH_U8(glint_formats[format].bits);
    const uint8_t *at = line + (bits * x >> 3);
    if (bits == 16) {
        const bool swapped = format == GLINT_RGB565_SWAPPED;
        const uint32_t pixel = (uint32_t)at[!swapped] << 8 | at[swapped];
        return k == 0 ? pixel >> 11 : k == 1 ? pixel >> 5 & 63 : pixel & 31;
    }
    if (bits < 8)
        return (uint32_t)*at >> ((8 - bits) & ~(bits * x)) & ((1u << bits) - 1);
    return at[glint_format_is_blue_first(format) ? 2 - k : k];
}

/* z / (255 65535), z <= 255 (255 65535 + 65535): < 2^32 */
static uint32_t coverage_divide(uint32_t z)
{
    const uint32_t y = (z + (z >> 16) + 1) >> 16; /* z / 65535, as glint_exact_level has it */
    return (y + (y >> 8) + 1) >> 8;               /* y / 255, y < 65535 */
}

/* ARGB8888 is drawn in full: its alpha is the coverage. */
static uint32_t coverage_of(const struct glint_paint *paint, const struct glint_run *run, unsigned i)
{
    return paint->output.format == GLINT_ARGB8888 ? 255 : run->coverage[run->x + i];
}

static uint8_t coverage_level(const struct glint_paint *paint, const struct glint_run *run, unsigned i, unsigned k,
                              uint64_t x)
{
    const uint8_t format = paint->output.format;
    const uint32_t m = coverage_of(paint, run, i);
    const uint32_t under = UINT32_C(65535) * (255 - m) * coverage_under(format, run->line, run->x + i, k);
    const uint64_t over = x * (m * GLINT_FLASH_U8(glint_formats[format].max[k])); /* < 2^64 */
    const uint64_t threshold = (uint64_t)(255 * UINT32_C(65535)) * glint_weight(paint, run, i) << 27;
    return (uint8_t)coverage_divide((uint32_t)((over + ((uint64_t)under << 32) + threshold) >> 32));
}

/* ---- The same by 32 bits, in gamma space ----
 *
 * With a = m / 255 a blended level is the upper bits of a V + (1 - a) q 2^shift + threshold. V is linear in N.L and F: these, and what V has
 * without them, are scaled by a, rounded down. So the sum is low by no more than W and what that rounding takes; and V was high by no more
 * than what thresholds lack for it (paint->of.exact.high). */

/* What W grows by, for the largest factors: of N.L, which is low by < nl units, of F, and of what is without. */
static uint32_t coverage_w(const struct glint_paint *p, const uint32_t of_nl[3], uint32_t nl, uint32_t f,
                           uint32_t fixed)
{
    uint32_t most = 0, sum = 0;
    for (unsigned k = 0; k < 3; k++) {
        const uint32_t w = nl * of_nl[k] + f * p->of.exact.r[k] + fixed;
        most = w > most ? w : most;
        sum += w;
    }
    return (glint_format_is_grey(p->output.format) ? sum : most) +
           255u * 36; /* 255 times what both glint_covered_one lack, <= 17 each */
}

/* Every format, maps, and channels apart: V as glint_levels_apart has it. */
static uint32_t coverage_any(const struct glint_paint *p, const struct glint_run *run,
                             const struct glint_sample *samples, unsigned count)
{
    const uint8_t format = p->output.format;
    const unsigned shift = (unsigned)p->of.exact.shift;
    const bool grey = glint_format_is_grey(format);
    /* Factors of N.L and of what is without it come times 255 / 2^7; N.L and F are low by < 1 + 2^-6 */
    uint32_t of_nl[3];
    for (unsigned k = 0; k < 3; k++)
        of_nl[k] = 2 * p->of.exact.diffuse[k];
    const uint32_t w = p->of.exact.w_maps + coverage_w(p, of_nl, 2, 2, 2 * 5 << 8);
    const uint8_t *albedo = run->albedo ? run->albedo : p->material.albedo;
    uint32_t bias[4], open = 0;
    glint_levels_bias(bias, p, run);
    glint_levels_alpha(format, run, 0, count);
    for (unsigned i = 0; i < count; i++, albedo += run->albedo ? 3 : 0) {
        const struct glint_sample *sample = samples + i;
        const uint32_t m = coverage_of(p, run, i), rest = glint_covered_one(255 - m, shift);
        const uint32_t one = glint_covered_one(m, shift);
        uint32_t sum = bias[i & 3] - grey, undecided = 0;
        uint8_t levels[4];
        for (unsigned k = 0; k < 3; k++, sample += run->apart) {
            const uint32_t max = GLINT_FLASH_U8(glint_formats[format].max[k]);
            const uint32_t nl = glint_by_255(sample->nl_q16 * m);
            const uint32_t f =
                glint_by_255((run->gloss ? glint_by_255(sample->f_q16 * run->gloss[i]) : sample->f_q16) * m);
            uint32_t v =
                (albedo[k] * ((glint_covered_part(p->of.exact.ambient[k], m) + p->of.exact.diffuse[k] * nl) >> 7)) +
                p->of.exact.r[k] * f;
            v = sum + glint_levels_hold(v, grey ? (max * one >> 8) * glint_luma(k) : max * one);
            if (grey)
                sum = v;
            if (!grey || k == 2) {
                const unsigned at = grey ? 0 : k;
                v += rest * coverage_under(format, run->line, run->x + i, at);
                undecided |= v ^ (v + w);
                levels[at] = (uint8_t)(v >> shift);
            }
        }
        if (undecided >> shift)
            open |= (uint32_t)1 << i;
        else
            glint_store_run(format, run->line, run->x + i, levels, 1, 0);
    }
    return open;
}

/* A channel's V, blended over a level, and its threshold. */
GLINT_INLINE uint32_t coverage_channel(const struct glint_paint *p, unsigned k, const uint32_t fixed[3], uint32_t m_257,
                                       uint32_t nl, uint32_t f, uint32_t most)
{
    return glint_levels_hold(glint_covered_fixed(fixed[k], m_257) + p->of.exact.q[k] * nl + p->of.exact.r[k] * f, most);
}

/* RGB565 without maps, under one light: N.L <= 2^16, F < 33/32 2^16. a and 1 - a are low by 255 of 2^shift together. */
static uint32_t coverage_565(const struct glint_paint *p, const struct glint_run *run,
                             const struct glint_sample *sample, unsigned count)
{
    const unsigned shift = (unsigned)p->of.exact.shift, swapped = p->output.format == GLINT_RGB565_SWAPPED;
    const uint32_t unit = glint_covered_unit(shift);
    const uint32_t w = p->of.exact.w + coverage_w(p, p->of.exact.q, 2, 4, (uint32_t)2 << 16) + (63 << 8);
    const uint8_t *coverage = run->coverage + run->x;
    uint8_t *out = run->line + 2 * run->x;
    uint32_t bias[4], fixed[3], open = 0;
    glint_levels_bias(bias, p, run);
    for (unsigned k = 0; k < 3; k++)
        fixed[k] = (p->of.exact.p[k] - (p->output.dither ? 0 : bias[0])) >> 16;
    const struct glint_sample *const first = sample, *const end = sample + count;
    const uint32_t *threshold = bias;
    for (; sample != end; sample++, out += 2) {
        const uint32_t m = *coverage++, m_257 = (m << 8) + m, rest = (255 - m) * unit, one = m * unit;
        const uint32_t nl = glint_covered_nl(sample->nl_q16, m_257), f = glint_covered_f(sample->f_q16, m_257);
        const uint32_t under = (uint32_t)out[1 - swapped] << 8 | out[swapped];
        uint32_t v = coverage_channel(p, 0, fixed, m_257, nl, f, 31 * one) + rest * (under >> 11) + *threshold;
        uint32_t undecided = v ^ (v + w), pixel = v >> shift << 6;
        v = coverage_channel(p, 1, fixed, m_257, nl, f, 63 * one) + rest * (under >> 5 & 63) + *threshold;
        undecided |= v ^ (v + w);
        pixel = (pixel | v >> shift) << 5;
        v = coverage_channel(p, 2, fixed, m_257, nl, f, 31 * one) + rest * (under & 31) + *threshold;
        undecided |= v ^ (v + w);
        pixel |= v >> shift;
        if (undecided >> shift) {
            open |= (uint32_t)1 << (sample - first);
        } else {
            out[swapped] = (uint8_t)pixel;
            out[1 - swapped] = (uint8_t)(pixel >> 8);
        }
        if (++threshold == bias + 4)
            threshold = bias;
    }
    return open;
}

/* The first that is neither 0 nor 255. */
static const uint8_t *coverage_plain(const uint8_t *at, const uint8_t *stop)
{
    while (at != stop && (uint8_t)(*at - 1) >= 254) {
        at++;
        if (((uintptr_t)at & 3) == 0)
            while (stop - at >= 4 && *(const coverage_word *)(const void *)at + 1 < 2)
                at += 4;
    }
    return at;
}

/* A run without maps or channels of their own, in RGB565? */
static bool coverage_is_plain(const struct glint_paint *paint, const struct glint_run *run)
{
    return glint_format_is_565(paint->output.format) && !run->albedo && !run->gloss && !paint->several;
}

static uint32_t coverage_levels(const struct glint_run *run, const struct glint_paint *paint,
                                const struct glint_sample *samples, unsigned count)
{
    /* In linear space it blends by coverage_level; ARGB8888 does not blend, but its channels may be apart. */
    if (paint->output.space != GLINT_GAMMA || (paint->output.format == GLINT_ARGB8888 && !run->apart))
        return GLINT_FLASH_POINTER(paint->format->levels)(paint, run, samples, count);
    return (coverage_is_plain(paint, run) ? coverage_565 : coverage_any)(paint, run, samples, count);
}

static void coverage_exact(const struct glint_run *run, const struct glint_paint *paint, unsigned i,
                           const struct glint_sample *sums, unsigned apart)
{
    const uint8_t format = paint->output.format;
    const bool grey = glint_format_is_grey(format);
    uint8_t levels[4];
    uint64_t parts = 0;
    if (paint->output.space != GLINT_GAMMA) { /* it blends by coverage_level */
        GLINT_FLASH_POINTER(paint->format->exact)(paint, run, i, sums, apart);
        return;
    }
    for (unsigned k = 0; k < 3; k++, sums += apart) {
        const uint64_t x = glint_exact_channel(paint, run, i, k, sums);
        parts += x * glint_luma(k);
        if (!grey)
            levels[k] = coverage_level(paint, run, i, k, x);
    }
    if (grey)
        levels[0] = coverage_level(paint, run, i, 0, parts >> 8);
    glint_store_run(format, run->line, run->x + i, levels, 1, 0);
}

/* ---- From finished levels: tables, in RGB565 ---- */

/* v = m p + (255 - m) q + 128 of each channel, (v + (v >> 8)) >> 8; red and blue side by side. */
static void coverage_over(const struct glint_paint *paint, const struct glint_run *run, const uint8_t *old,
                          unsigned count)
{
    const bool swapped = paint->output.format == GLINT_RGB565_SWAPPED;
    const uint8_t *coverage = run->coverage + run->x;
    uint8_t *low = run->line + 2 * run->x + swapped, *high = run->line + 2 * run->x + !swapped;
    for (old += swapped; count--; coverage++, low += 2, high += 2, old += 2) {
        const uint32_t m = *coverage, rest = 255 - m;
        if (!rest)
            continue;
        const uint32_t p = (uint32_t)*high << 8 | *low, q = (uint32_t)(swapped ? old[-1] : old[1]) << 8 | *old;
        uint32_t both = m * ((p >> 11) << 16 | (p & 31)) + rest * ((q >> 11) << 16 | (q & 31)) + 0x00800080;
        uint32_t green = m * (p >> 5 & 63) + rest * (q >> 5 & 63) + 128;
        both = (both + (both >> 8 & 0x00ff00ff)) >> 8;
        green = (green + (green >> 8)) >> 8;
        const uint32_t pixel = (both >> 16 << 11) | green << 5 | (both & 31);
        *low = (uint8_t)pixel;
        *high = (uint8_t)(pixel >> 8);
    }
}

static void coverage_keep(uint8_t old[2 * GLINT_RUN], const uint8_t *pixels, unsigned count)
{
    for (unsigned i = 0; i < 2 * count; i++)
        old[i] = pixels[i];
}

static void coverage_pixels(const struct glint_run *run, const struct glint_paint *paint, const struct glint_raw *raws,
                            unsigned count)
{
    uint8_t old[2 * GLINT_RUN];
    coverage_keep(old, run->line + 2 * run->x, count);
    GLINT_FLASH_POINTER(paint->of.tables.filled.use->pixels)(paint, run, raws, count);
    coverage_over(paint, run, old, count);
}

/* As many as can be kept at a time. */
static void coverage_line(const struct glint_paint *paint, const struct glint_lines *lines)
{
    const uint32_t stop = lines->run.x + lines->count;
    struct glint_run run = lines->run;
    uint8_t old[2 * GLINT_RUN];
    for (uint32_t end; run.x != stop; run.x = end) {
        end = stop - run.x > GLINT_RUN ? run.x + GLINT_RUN : stop;
        coverage_keep(old, run.line + 2 * run.x, (unsigned)(end - run.x));
        GLINT_FLASH_POINTER(paint->of.tables.filled.use->line)(paint, lines, run.x, end);
        coverage_over(paint, &run, old, (unsigned)(end - run.x));
    }
}

/* ---- Beside the line in assembly, which draws what is full ---- */

static __attribute__((noinline)) void coverage_edge(const struct glint_paint *paint, struct glint_lines *lines,
                                                    struct glint_bounds *bounds, unsigned count, uint32_t y)
{
    struct glint_sample samples[GLINT_RUN];
    struct glint_run *const run = &lines->run;
    run->albedo = lines->albedo ? lines->albedo + 3 * run->x : NULL;
    glint_samples_half(&paint->l, &paint->v, &paint->h, (const struct glint_vec *)(const void *)lines->normals + run->x,
                       samples, count);
    for (unsigned i = 0; i < count; i++)
        if (samples[i].t_q30 < paint->of.exact.t_end)
            glint_bounds_add(bounds, run->x + i, y);
    glint_paint_run(paint, run, samples, count);
}

static void coverage_edges(const struct glint_paint *paint, struct glint_lines *lines, struct glint_bounds *bounds,
                           uint32_t y, glint_draw_edge *edge)
{
    const uint8_t *const coverage = lines->run.coverage, *const stop = coverage + lines->w;
    lines->run.soft = lines->soft;
    for (const uint8_t *at = coverage; (at = coverage_plain(at, stop)) != stop;) {
        const uint8_t *end = at + 1;
        while (end != stop && end - at < (ptrdiff_t)GLINT_RUN && (uint8_t)(*end - 1) < 254)
            end++;
        lines->run.x = (uint32_t)(at - coverage);
        (edge ? edge : coverage_edge)(paint, lines, bounds, (unsigned)(end - at), y);
        at = end;
    }
    lines->run.soft = NULL;
}

const struct glint_use_coverage glint_use_coverage GLINT_FLASH = {coverage_levels, coverage_exact, coverage_level,
                                                                  coverage_pixels, coverage_line,  coverage_edges};
