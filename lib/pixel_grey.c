/* SPDX-License-Identifier: MIT
 * GREY8, GREY4, GREY2 and MONO in gamma space. A level is the sum of three parts, each held to its channel's share. */
#include "glint_pixel.h"

static bool grey_draws(const struct glint_output *output)
{
    return glint_format_is_grey(output->format) && output->space == GLINT_GAMMA;
}

static uint32_t grey_max(const struct glint_paint *paint)
{
    return GLINT_FLASH_U8(glint_formats[paint->output.format].max[0]);
}

GLINT_INLINE uint32_t grey_loop(const struct glint_paint *p, const struct glint_run *run,
                                const struct glint_sample *sample, unsigned count, bool maps)
{
    const unsigned shift = (unsigned)p->of.exact.shift;
    const uint32_t w = maps ? p->of.exact.w_maps : p->of.exact.w, max = grey_max(p), most = max << shift;
    /* The shares of 1.0: low by < 1 */
    const uint32_t red = (most >> 8) * GLINT_LUMA_RED, green = (most >> 8) * GLINT_LUMA_GREEN,
                   blue = (most >> 8) * GLINT_LUMA_BLUE;
    const uint8_t *albedo = maps && run->albedo ? run->albedo : p->material.albedo, *gloss = run->gloss;
    const unsigned step = maps && run->albedo ? 3 : 0;
    uint32_t bias[4], open = 0;
    uint8_t levels[GLINT_RUN];
    glint_levels_bias(bias, p, run);
    for (unsigned i = 0; i < count; i++, sample++, albedo += maps ? step : 0) {
        uint32_t v[3];
        glint_levels_sum(v, p, p->of.exact.p, sample, albedo, gloss ? gloss + i : gloss, maps);
        /* Step 6 rounds down: by less than 1 here, which is taken off */
        const uint32_t sum = bias[i & 3] - 1 + glint_levels_hold(v[0], red) + glint_levels_hold(v[1], green) +
                             glint_levels_hold(v[2], blue);
        const uint32_t held = glint_levels_hold(sum, most);
        levels[i] = (uint8_t)(held >> shift);
        if ((held ^ (held + w)) >> shift)
            open |= (uint32_t)1 << i;
    }
    glint_store_run(p->output.format, run->line, run->x, levels, count, open);
    return open;
}

static uint32_t grey_plain(const struct glint_paint *paint, const struct glint_run *run,
                           const struct glint_sample *samples, unsigned count)
{
    return grey_loop(paint, run, samples, count, false);
}

static uint32_t grey_mapped(const struct glint_paint *paint, const struct glint_run *run,
                            const struct glint_sample *samples, unsigned count)
{
    return grey_loop(paint, run, samples, count, true);
}

static uint32_t grey_levels(const struct glint_paint *paint, const struct glint_run *run,
                            const struct glint_sample *samples, unsigned count)
{
    return run->albedo || run->gloss ? grey_mapped(paint, run, samples, count) : grey_plain(paint, run, samples, count);
}

static void grey_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                       const struct glint_sample *sums, unsigned apart)
{
    uint64_t parts = 0;
    for (unsigned k = 0; k < 3; k++, sums += apart)
        parts += glint_exact_channel(paint, run, i, k, sums) * glint_luma(k);
    const uint8_t level = (uint8_t)glint_exact_level(parts >> 8, grey_max(paint), glint_weight(paint, run, i));
    glint_store_run(paint->output.format, run->line, run->x + i, &level, 1, 0);
}

const struct glint_use_format glint_use_grey GLINT_FLASH = {grey_draws, glint_levels_fold, grey_levels, grey_exact,
                                                            NULL};
