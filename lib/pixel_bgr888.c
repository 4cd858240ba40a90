/* SPDX-License-Identifier: MIT
 * Bytes with blue first in gamma space: BGR888, XRGB8888 and ARGB8888. */
#include "glint_pixel_levels.h"

static bool bgr888_draws(const struct glint_shader *shader)
{
    return glint_format_is_blue_first(shader->format) && shader->space == GLINT_GAMMA;
}

static void bgr888_fold(struct glint_prepared *prepared)
{
    const struct glint_levels_kind kind = {{255, 255, 255}, {256, 256, 256}};
    glint_levels_fold(prepared, kind, !prepared->shader.dither);
}

static uint32_t bgr888_dithered(const struct glint_prepared *prepared, const struct glint_run *run,
                                const struct glint_sample *samples, unsigned count)
{
    return glint_levels_rgb(prepared, run, samples, count, GLINT_LEVELS_BLUE_FIRST, false, true);
}

static uint32_t bgr888_mapped(const struct glint_prepared *prepared, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    return glint_levels_rgb(prepared, run, samples, count, GLINT_LEVELS_BLUE_FIRST, true, true);
}

static uint32_t bgr888_levels(const struct glint_prepared *prepared, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    glint_levels_alpha(prepared->shader.format, run, 0, count);
    return run->albedo || run->gloss ? bgr888_mapped(prepared, run, samples, count)
                                     : bgr888_dithered(prepared, run, samples, count);
}

static void bgr888_exact(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                         uint32_t f_q16)
{
    const uint32_t x = run->x + i, weight = glint_exact_weight(shader, run->left + x, run->y);
    uint64_t v[3];
    uint8_t levels[4];
    glint_levels_exact(v, shader, run, i, nl_q16, f_q16);
    for (int k = 0; k < 3; k++)
        levels[k] = (uint8_t)glint_exact_level(v[k], 255, weight);
    glint_exact_store(shader->format, run->line, x, levels);
}

const struct glint_shade_format glint_shade_bgr888 GLINT_FLASH = {bgr888_draws, bgr888_fold, bgr888_levels,
                                                                  bgr888_exact, NULL};
