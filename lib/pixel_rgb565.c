/* SPDX-License-Identifier: MIT
 * RGB565 in gamma space, either order. */
#include "glint_pixel_levels.h"
#include "glint_pixel_line.h"

static bool rgb565_draws(const struct glint_shader *shader)
{
    return glint_format_is_565(shader->format) && shader->space == GLINT_GAMMA;
}

static void rgb565_fold(struct glint_prepared *prepared)
{
    const struct glint_levels_kind kind = {{31, 63, 31}, {256, 256, 256}};
    glint_levels_fold(prepared, kind, !prepared->shader.dither);
}

static uint32_t rgb565_plain(const struct glint_prepared *prepared, const struct glint_run *run,
                             const struct glint_sample *samples, unsigned count)
{
    return glint_levels_rgb(prepared, run, samples, count, GLINT_LEVELS_565, false, false);
}

static uint32_t rgb565_dithered(const struct glint_prepared *prepared, const struct glint_run *run,
                                const struct glint_sample *samples, unsigned count)
{
    return glint_levels_rgb(prepared, run, samples, count, GLINT_LEVELS_565, false, true);
}

static uint32_t rgb565_mapped(const struct glint_prepared *prepared, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    return glint_levels_rgb(prepared, run, samples, count, GLINT_LEVELS_565, true, true);
}

static uint32_t rgb565_levels(const struct glint_prepared *prepared, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    return run->albedo || run->gloss ? rgb565_mapped(prepared, run, samples, count)
           : prepared->shader.dither ? rgb565_dithered(prepared, run, samples, count)
                                     : rgb565_plain(prepared, run, samples, count);
}

static void rgb565_exact(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                         uint32_t f_q16)
{
    const uint32_t x = run->x + i, weight = glint_exact_weight(shader, run->left + x, run->y);
    uint64_t v[3];
    glint_levels_exact(v, shader, run, i, nl_q16, f_q16);
    const uint32_t rgb = glint_exact_level(v[0], 31, weight) << 11 | glint_exact_level(v[1], 63, weight) << 5 |
                         glint_exact_level(v[2], 31, weight);
    const bool swapped = shader->format == GLINT_RGB565_SWAPPED;
    uint8_t *out = run->line + 2 * x;
    out[swapped] = (uint8_t)rgb;
    out[!swapped] = (uint8_t)(rgb >> 8);
}

const struct glint_shade_format glint_shade_rgb565 GLINT_FLASH = {rgb565_draws, rgb565_fold, rgb565_levels,
                                                                  rgb565_exact, GLINT_LINE_BEGIN};
