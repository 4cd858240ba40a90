/* SPDX-License-Identifier: MIT
 * RGB565 in either order, and RGB888, BGR888, XRGB8888 and ARGB8888, in gamma space. */
#include "glint_fused.h"
#include "glint_pixel.h"

static bool rgb565_draws(const struct glint_output *output)
{
    return glint_format_is_565(output->format) && output->space == GLINT_GAMMA;
}

/* Loops of their own, so that each has the registers to itself. */
#define RGB_LOOP(name, kind, maps, dither)                                                                             \
    static uint32_t name(const struct glint_paint *paint, const struct glint_run *run,                                 \
                         const struct glint_sample *samples, unsigned count)                                           \
    {                                                                                                                  \
        return glint_levels_rgb(paint, run, samples, count, kind, maps, dither);                                       \
    }
#ifdef __OPTIMIZE_SIZE__ /* one loop for both */
#define rgb565_plain rgb565_dithered
#else
RGB_LOOP(rgb565_plain, GLINT_LEVELS_565, false, false)
#endif
RGB_LOOP(rgb565_dithered, GLINT_LEVELS_565, false, true)
RGB_LOOP(rgb565_mapped, GLINT_LEVELS_565, true, true)
RGB_LOOP(rgb888_plain, GLINT_LEVELS_888, false, true)
RGB_LOOP(rgb888_mapped, GLINT_LEVELS_888, true, true)
#undef RGB_LOOP

static uint32_t rgb565_levels(const struct glint_paint *paint, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    return run->albedo || run->gloss ? rgb565_mapped(paint, run, samples, count)
           : paint->output.dither    ? rgb565_dithered(paint, run, samples, count)
                                     : rgb565_plain(paint, run, samples, count);
}

static void rgb565_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                         const struct glint_sample *sums, unsigned apart)
{
    uint8_t levels[4];
    glint_exact_levels(levels, paint, run, i, sums, apart);
    const uint32_t rgb = (uint32_t)levels[0] << 11 | (uint32_t)levels[1] << 5 | levels[2];
    const bool swapped = paint->output.format == GLINT_RGB565_SWAPPED;
    uint8_t *out = run->line + 2 * (run->x + i);
    out[swapped] = (uint8_t)rgb;
    out[!swapped] = (uint8_t)(rgb >> 8);
}

const struct glint_use_format glint_use_rgb565 GLINT_FLASH = {rgb565_draws, glint_levels_fold, rgb565_levels,
                                                              rgb565_exact, GLINT_LINE_BEGIN};

static uint32_t rgb565_steps_levels(const struct glint_paint *paint, const struct glint_run *run,
                                    const struct glint_sample *samples, unsigned count)
{
    return run->albedo || run->gloss ? rgb565_levels(paint, run, samples, count)
                                     : glint_levels_steps(rgb565_levels, paint, run, samples, count);
}

static void rgb565_steps_fold(struct glint_paint *paint, const struct glint_coefficients *c, unsigned up)
{
    paint->format = &glint_use_rgb565;
    glint_levels_fold(paint, c, up);
}

#if GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED
static bool rgb565_steps_begin(struct glint_line_loop *loop, const struct glint_paint *paint, bool albedo)
{
    if (!glint_line_begin(loop, paint, albedo))
        return false;
    loop->steps = paint->of.exact.steps;
    loop->dark = loop->steps[0];
    if (!albedo)
        loop->draw = paint->output.format == GLINT_RGB565 ? glint_line_rgb565_steps : glint_line_rgb565_steps_swapped;
    return true;
}
#else
#define rgb565_steps_begin GLINT_LINE_BEGIN
#endif

const struct glint_use_format glint_use_rgb565_steps GLINT_FLASH = {
    rgb565_draws, rgb565_steps_fold, rgb565_steps_levels, rgb565_exact, rgb565_steps_begin};

static bool rgb888_draws(const struct glint_output *output)
{
    return (output->format == GLINT_RGB888 || glint_format_is_blue_first(output->format)) &&
           output->space == GLINT_GAMMA;
}

static uint32_t rgb888_levels(const struct glint_paint *paint, const struct glint_run *run,
                              const struct glint_sample *samples, unsigned count)
{
    glint_levels_alpha(paint->output.format, run, 0, count);
    return run->albedo || run->gloss ? rgb888_mapped(paint, run, samples, count)
                                     : rgb888_plain(paint, run, samples, count);
}

static void rgb888_exact(const struct glint_paint *paint, const struct glint_run *run, unsigned i,
                         const struct glint_sample *sums, unsigned apart)
{
    uint8_t levels[4];
    glint_exact_levels(levels, paint, run, i, sums, apart);
    const bool blue_first = glint_format_is_blue_first(paint->output.format);
    uint8_t *out = run->line + (GLINT_FLASH_U8(glint_formats[paint->output.format].bits) >> 3) * (run->x + i);
    out[0] = levels[blue_first ? 2 : 0];
    out[1] = levels[1];
    out[2] = levels[blue_first ? 0 : 2];
}

const struct glint_use_format glint_use_rgb888 GLINT_FLASH = {rgb888_draws, glint_levels_fold, rgb888_levels,
                                                              rgb888_exact, GLINT_LINE_BEGIN_888};
