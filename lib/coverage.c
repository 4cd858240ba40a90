/* SPDX-License-Identifier: MIT
 * Coverage: pixels that are blended over what the buffer holds, step 8 of sequence.md. */
#include "glint_fused.h"
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

/* ---- The same by 32 bits, in gamma space ---- */

/* Every format, maps, and channels apart: V as glint_levels_apart has it. */
static uint32_t coverage_any(const struct glint_paint *p, const struct glint_run *run,
                             const struct glint_sample *samples, unsigned count)
{
    const uint8_t format = p->output.format;
    const unsigned shift = (unsigned)p->of.exact.shift;
    const bool grey = glint_format_is_grey(format);
    const uint32_t w = glint_covered_w(p->of.exact.w_maps, shift, true);
    const uint8_t *albedo = run->albedo ? run->albedo : p->material.albedo;
    uint32_t bias[4], open = 0;
    glint_levels_bias(bias, p, run);
    glint_levels_alpha(format, run, 0, count);
    for (unsigned i = 0; i < count; i++, albedo += run->albedo ? 3 : 0) {
        const struct glint_sample *sample = samples + i;
        const uint32_t m = coverage_of(p, run, i);
        uint32_t sum = 0, undecided = 0;
        uint8_t levels[4];
        for (unsigned k = 0; k < 3; k++, sample += run->apart) {
            const uint32_t most = (uint32_t)GLINT_FLASH_U8(glint_formats[format].max[k]) << shift;
            const uint32_t f = run->gloss ? glint_by_255(sample->f_q16 * run->gloss[i]) : sample->f_q16;
            const uint32_t v = (albedo[k] * ((p->of.exact.ambient[k] + p->of.exact.diffuse[k] * sample->nl_q16) >> 7)) +
                               p->of.exact.r[k] * f;
            if (grey)
                sum += glint_levels_hold(v, (most >> 8) * glint_luma(k));
            else
                sum = glint_levels_hold(v, most);
            if (!grey || k == 2) {
                const unsigned at = grey ? 0 : k;
                const uint32_t q = coverage_under(format, run->line, run->x + i, at);
                /* Step 6 rounds down: by less than 1 here, which is taken off */
                const uint32_t level =
                    glint_covered_blend(sum, m, ((255 - m) * q) << (shift - 8), true) + bias[i & 3] - grey;
                undecided |= level ^ (level + w);
                levels[at] = (uint8_t)(level >> shift);
            }
        }
        if (undecided >> shift)
            open |= (uint32_t)1 << i;
        else
            glint_store_run(format, run->line, run->x + i, levels, 1, 0);
    }
    return open;
}

/* RGB without maps: V as glint_levels_sum has it, without its threshold. turns: the thresholds may differ. */
GLINT_INLINE uint32_t coverage_rgb(const struct glint_paint *p, const struct glint_run *run,
                                   const struct glint_sample *sample, unsigned count, bool deep, bool turns)
{
    const unsigned shift = (unsigned)p->of.exact.shift;
    const uint8_t format = p->output.format;
    const bool swapped = format == GLINT_RGB565_SWAPPED;
    const unsigned red_at = glint_format_is_blue_first(format) ? 2 : 0, blue_at = 2 - red_at;
    const unsigned bytes = !deep ? 2 : red_at && format != GLINT_BGR888 ? 4 : 3;
    const uint32_t most = (uint32_t)(deep ? 255 : 31) << shift, most_green = (uint32_t)(deep ? 255 : 63) << shift;
    const uint32_t w = glint_covered_w(p->of.exact.w, shift, deep);
    const uint8_t *coverage = run->coverage + run->x;
    uint8_t *out = run->line + bytes * run->x + swapped;
    const ptrdiff_t other = swapped ? -1 : 1;
    uint32_t bias[4], base[3], open = 0;
    glint_levels_bias(bias, p, run);
    for (unsigned k = 0; k < 3; k++)
        base[k] = p->of.exact.p[k] - (p->output.dither ? 0 : bias[0]);
    const struct glint_sample *const first = sample, *const end = sample + count;
    const uint32_t *threshold = bias;
    for (; sample != end; sample++, out += bytes) {
        const uint32_t m = *coverage++, rest = (255 - m) << (shift - 8), t = *threshold;
        const uint32_t under = deep ? 0 : (uint32_t)out[other] << 8 | out[0];
        uint32_t v[3];
        glint_levels_sum(v, p, base, sample, NULL, NULL, false);
        const uint32_t red =
            glint_covered_blend(glint_levels_hold(v[0], most), m, rest * (deep ? out[red_at] : under >> 11), deep) + t;
        uint32_t undecided = red ^ (red + w);
        const uint32_t green = glint_covered_blend(glint_levels_hold(v[1], most_green), m,
                                                   rest * (deep ? out[1] : under >> 5 & 63), deep) +
                               t;
        undecided |= green ^ (green + w);
        const uint32_t blue =
            glint_covered_blend(glint_levels_hold(v[2], most), m, rest * (deep ? out[blue_at] : under & 31), deep) + t;
        undecided |= blue ^ (blue + w);
        if (undecided >> shift) {
            open |= (uint32_t)1 << (sample - first);
        } else if (deep) {
            out[red_at] = (uint8_t)(red >> shift);
            out[1] = (uint8_t)(green >> shift);
            out[blue_at] = (uint8_t)(blue >> shift);
        } else {
            const uint32_t pixel = red >> shift << 11 | green >> shift << 5 | blue >> shift;
            out[0] = (uint8_t)pixel;
            out[other] = (uint8_t)(pixel >> 8);
        }
        if (turns && ++threshold == bias + 4)
            threshold = bias;
    }
    return open;
}

/* Loops of their own, so that each has the registers to itself. */
static __attribute__((noinline)) uint32_t coverage_565(const struct glint_paint *p, const struct glint_run *run,
                                                       const struct glint_sample *samples, unsigned count)
{
    return coverage_rgb(p, run, samples, count, false, false);
}
static __attribute__((noinline)) uint32_t coverage_565_dithered(const struct glint_paint *p,
                                                                const struct glint_run *run,
                                                                const struct glint_sample *samples, unsigned count)
{
    return coverage_rgb(p, run, samples, count, false, true);
}
static __attribute__((noinline)) uint32_t coverage_888(const struct glint_paint *p, const struct glint_run *run,
                                                       const struct glint_sample *samples, unsigned count)
{
    glint_levels_alpha(p->output.format, run, 0, count);
    return coverage_rgb(p, run, samples, count, true, true);
}

static uint32_t coverage_levels(const struct glint_paint *paint, const struct glint_run *run,
                                const struct glint_sample *samples, unsigned count)
{
    if (run->albedo || run->gloss || run->apart || glint_format_is_grey(paint->output.format))
        return coverage_any(paint, run, samples, count);
    return (!glint_format_is_565(paint->output.format) ? coverage_888
            : paint->output.dither                     ? coverage_565_dithered
                                                       : coverage_565)(paint, run, samples, count);
}

static void coverage_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                           const struct glint_sample *sums, unsigned apart)
{
    const uint8_t format = paint->output.format;
    const bool grey = glint_format_is_grey(format);
    uint8_t levels[4];
    uint64_t parts = 0;
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

static void coverage_over(const struct glint_paint *paint, const struct glint_run *run, uint32_t x, const uint8_t *old,
                          unsigned count)
{
    const bool swapped = paint->output.format == GLINT_RGB565_SWAPPED;
    const uint8_t *coverage = run->coverage + x;
    uint8_t *low = run->line + 2 * x + swapped, *high = run->line + 2 * x + !swapped;
    for (old += swapped; count--; coverage++, low += 2, high += 2, old += 2) {
        const uint32_t m = *coverage;
        if (m == 255)
            continue;
        const uint32_t p = (uint32_t)*high << 8 | *low, q = (uint32_t)(swapped ? old[-1] : old[1]) << 8 | *old,
                       pixel = glint_over(p, q, m);
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
    glint_tables_plainly(paint, run, raws, count);
    coverage_over(paint, run, run->x, old, count);
}

/* As many as can be kept at a time. */
static void coverage_line(const struct glint_paint *paint, const struct glint_lines *lines)
{
    const struct glint_run *const run = &lines->run;
    const uint32_t stop = run->x + lines->count;
    uint8_t old[2 * GLINT_RUN];
    for (uint32_t x = run->x, end; x != stop; x = end) {
        end = stop - x > GLINT_RUN ? x + GLINT_RUN : stop;
        coverage_keep(old, run->line + 2 * x, (unsigned)(end - x));
        GLINT_FLASH_POINTER(paint->of.tables.filled.use->line)(paint, lines, x, end);
        coverage_over(paint, run, x, old, (unsigned)(end - x));
    }
}

/* ---- Runs ---- */

/* Where the level of coverage at `at`, which is before stop, ends: 0, 255, or what is between. Four at a time, where all are the same. */
static const uint8_t *coverage_end(const uint8_t *at, const uint8_t *stop)
{
    const uint8_t first = *at;
    if (first && first != 255) {
        while (at != stop && (uint8_t)(*at - 1) < 254)
            at++;
        return at;
    }
    const uint32_t all = first ? UINT32_MAX : 0;
    for (;;) {
        if (((uintptr_t)at & 3) == 0)
            while (stop - at >= 4 && *(const coverage_word *)(const void *)at == all)
                at += 4;
        do {
            if (at == stop || *at != first)
                return at;
            at++;
        } while ((uintptr_t)at & 3);
    }
}

/* The same over pixels of a surface alone. */
static uint32_t coverage_end_gaps(const struct glint_lines *lines, uint32_t x, uint32_t end)
{
    const uint32_t *const words = (const uint32_t *)(const void *)lines->normals;
    const bool full = lines->run.coverage[x] == 255;
    while (x < end && words[x] >> 16 && lines->run.coverage[x] && (lines->run.coverage[x] == 255) == full)
        x++;
    return x;
}

/* run.x < w */
static void coverage_next(struct glint_lines *lines)
{
    struct glint_run *const run = &lines->run;
    const uint8_t *const coverage = run->coverage, *const stop = coverage + lines->w, *at = coverage + run->x;
    const uint32_t *const words = lines->has_gaps ? (const uint32_t *)(const void *)lines->normals : NULL;
    if (!*at)
        at = coverage_end(at, stop);
    while (words && at != stop && !(*at && words[at - coverage] >> 16))
        at++;
    const uint32_t x = (uint32_t)(at - coverage),
                   end = (uint32_t)(stop - at) < lines->most ? lines->w : x + lines->most;
    run->x = x;
    lines->count = 0;
    if (at == stop)
        return;
    glint_run_soften(run, lines->paint, *at == 255 ? NULL : lines->soft);
    lines->count = (uint16_t)((words ? coverage_end_gaps(lines, x, end)
                                     : (uint32_t)(coverage_end(at, coverage + end) - coverage)) -
                              x);
}

/* ---- Beside a core's line, which draws what is full ---- */

#if GLINT_LINE
static void coverage_edge_plain(const struct glint_paint *paint, struct glint_lines *lines, struct glint_bounds *bounds,
                                unsigned count, uint32_t y)
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

static uint32_t coverage_edge(const struct glint_paint *paint, struct glint_lines *lines, struct glint_line_loop *loop,
                              glint_draw_edge *draw, struct glint_bounds *bounds, uint32_t y)
{
    struct glint_run *const run = &lines->run;
    lines->most = GLINT_RUN;
#if GLINT_CORTEX_M0PLUS_ASM
    if (loop && !lines->albedo && !paint->of.exact.high) {
        run->x = paint->output.format == GLINT_RGB565 ? glint_line_rgb565_soft(loop, run->x)
                                                      : glint_line_rgb565_soft_swapped(loop, run->x);
        if (run->x == lines->w || (uint8_t)(run->coverage[run->x] - 1) >= 254)
            return run->x;
        lines->most = 1; /* it left one open */
    }
#else
    (void)loop;
#endif
    coverage_next(lines);
    const uint32_t end = run->x + lines->count;
    (draw ? draw : coverage_edge_plain)(paint, lines, bounds, lines->count, y);
    glint_run_soften(run, paint, NULL);
    return end;
}
#define COVERAGE_EDGE coverage_edge
#else
#define COVERAGE_EDGE NULL
#endif

const struct glint_use_coverage glint_use_coverage GLINT_FLASH = {{NULL, NULL, coverage_levels, coverage_exact, NULL},
                                                                  coverage_level,
                                                                  coverage_pixels,
                                                                  coverage_line,
                                                                  coverage_next,
                                                                  COVERAGE_EDGE};
