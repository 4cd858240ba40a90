/* SPDX-License-Identifier: MIT
 * RGB888 in gamma space. */
#include "glint_pixel_levels.h"

static bool rgb888_draws(const struct glint_shader *shader)
{
    return shader->format == GLINT_RGB888 && shader->space == GLINT_GAMMA;
}

static void rgb888_fold(struct glint_prepared *prepared)
{
    const struct glint_levels_kind kind = {{255, 255, 255}, {256, 256, 256}};
    glint_levels_fold(prepared, kind, !prepared->shader.dither);
}

static uint32_t rgb888_dithered(const struct glint_prepared *prepared, const struct glint_run *run,
                                const struct glint_sample *samples, unsigned count)
{
    return glint_levels_rgb(prepared, run, samples, count, GLINT_LEVELS_RED_FIRST, false, true);
}

static uint32_t rgb888_mapped(const struct glint_prepared *prepared, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    return glint_levels_rgb(prepared, run, samples, count, GLINT_LEVELS_RED_FIRST, true, true);
}

static uint32_t rgb888_levels(const struct glint_prepared *prepared, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    return run->albedo || run->gloss ? rgb888_mapped(prepared, run, samples, count)
                                     : rgb888_dithered(prepared, run, samples, count);
}

static void rgb888_exact(const struct glint_shader *shader, const struct glint_run *run, unsigned i, uint32_t nl_q16,
                         uint32_t f_q16)
{
    const uint32_t x = run->x + i, weight = glint_exact_weight(shader, run->left + x, run->y);
    uint64_t v[3];
    glint_levels_exact(v, shader, run, i, nl_q16, f_q16);
    for (int k = 0; k < 3; k++)
        run->line[3 * x + (uint32_t)k] = (uint8_t)glint_exact_level(v[k], 255, weight);
}

const struct glint_shade_format glint_shade_rgb888 GLINT_FLASH = {rgb888_draws, rgb888_fold, rgb888_levels,
                                                                  rgb888_exact, NULL};
