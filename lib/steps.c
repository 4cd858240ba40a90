/* SPDX-License-Identifier: MIT
 * A paint's steps: what it draws without highlight is of N.L alone. Where the ends of a step of N.L, and so all of it, are one pixel the table has
 * this, elsewhere, at one step in eight, 0. */
#include "glint_pixel.h"
#include "glint_port.h"

enum glint_err glint_paint_steps_for(struct glint_paint *paint, const struct glint_use_format *format, void *memory,
                                     size_t bytes)
{
    uint16_t *const steps = (uint16_t *)memory;
    struct glint_run run = {NULL, 0, 0, 0, NULL, NULL, NULL, 0, NULL, NULL};
    if (!paint || !paint->format || paint->several || !format || !memory || GLINT_MISALIGNED(memory, 16) ||
        bytes < GLINT_STEPS_BYTES)
        return GLINT_ERR_ARG;
    if (!glint_format_is_565(paint->output.format) || paint->output.dither ||
        !GLINT_FLASH_POINTER(format->draws)(&paint->output))
        return GLINT_ERR_FORMAT;
    paint->of.exact.steps = steps;
    run.format = paint->format;
    for (uint32_t i = 0; i <= 65536 >> GLINT_STEPS_LOG; i++) {
        uint8_t ends[2][2];
        struct glint_sample samples[2] = {{UINT32_MAX, i << GLINT_STEPS_LOG, 0}, {UINT32_MAX, 0, 0}};
        samples[1].nl_q16 = samples[0].nl_q16 | (i << GLINT_STEPS_LOG < 65536 ? (1u << GLINT_STEPS_LOG) - 1 : 0);
        run.line = ends[0];
        steps[i] = 0; /* not the pixel of a table before */
        const uint32_t open = glint_run_levels(paint, &run, samples, 2);
        for (unsigned k = 0; k < 2; k++)
            if (open >> k & 1)
                glint_paint_sums(paint, &run, k, samples[k].nl_q16, 0);
        const bool one = ends[0][0] == ends[1][0] && ends[0][1] == ends[1][1];
        steps[i] = (uint16_t)(one ? ends[0][0] | ends[0][1] << 8 : 0);
    }
    paint->format = format;
    return GLINT_OK;
}
