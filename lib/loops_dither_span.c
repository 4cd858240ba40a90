/* SPDX-License-Identifier: MIT
 * Spans over COLOUR tables with dither, run by run as loops_span.c. */
#include "glint_loops_dither.h"
#include "glint_loops_run.h"
#include "glint_math_align.h"
#include "glint_pixel.h"

static void dithered_dark(const struct glint_dither_look *look, uint16_t *out, const uint16_t *end, uint32_t phase)
{
    for (; out != end; phase = glint_dither_next(phase))
        *out++ = glint_dither_past(look, -1, phase);
}

static void dithered_outside(const struct glint_dither_look *look, const struct glint_span *at, uint16_t *out,
                             const uint16_t *end, uint32_t phase)
{
    const uint32_t dnl = (uint32_t)at->dnl_q30;
    uint32_t nl = (uint32_t)at->nl_q30 + look->nudge;
    for (; out != end; phase = glint_dither_next(phase), nl += dnl)
        *out++ = glint_dither_past(look, (int32_t)(nl >> GLINT_DITHER_ROW_SHIFT), phase);
}

static inline void dithered_inside(const struct glint_dither_look *look, const struct glint_span *at, uint16_t *out,
                                   const uint16_t *end, uint32_t phase, bool swapped)
{
    const uint32_t ddt = at->ddt_q30, dnl = (uint32_t)at->dnl_q30;
    uint32_t back = look->t_max - at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30 + look->nudge;
    for (; out != end; phase = glint_dither_next(phase)) {
        *out++ = glint_dither_within(look, nl >> GLINT_DITHER_ROW_SHIFT, phase, back >> look->shift, swapped);
        back -= dt;
        dt += ddt;
        nl += dnl;
    }
}

/* Pixel by pixel, stored byte by byte: any, at any address. */
static void run_any(const struct glint_dither_look *look, const struct glint_span *at, uint8_t *out, uint32_t w,
                    uint32_t phase, bool swapped)
{
    uint32_t t = at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30;
    for (const uint8_t *end = out + 2 * w; out != end; out += 2, phase = glint_dither_next(phase)) {
        const uint16_t pixel = glint_dither_pixel(look, t >= GLINT_NEGATIVE_T ? 0 : t, nl, phase, swapped);
        out[0] = ((const uint8_t *)&pixel)[0];
        out[1] = ((const uint8_t *)&pixel)[1];
        t += dt;
        dt += at->ddt_q30;
        nl += (uint32_t)at->dnl_q30;
    }
}

static void dithered_run(const struct glint_dither_look *look, const struct glint_span *at, uint32_t w, uint8_t *bytes,
                         uint32_t phase, bool swapped)
{
    uint16_t *const out = (uint16_t *)(void *)bytes;
    switch (GLINT_MISALIGNED(bytes, 16) ? GLINT_RUN_MIXED : glint_run_kind(at, w, look->t_max)) {
    case GLINT_RUN_DARK:
        dithered_dark(look, out, out + w, phase);
        break;
    case GLINT_RUN_OUTSIDE:
        dithered_outside(look, at, out, out + w, phase);
        break;
    case GLINT_RUN_INSIDE:
        if (swapped)
            dithered_inside(look, at, out, out + w, phase, true);
        else
            dithered_inside(look, at, out, out + w, phase, false);
        break;
    default: /* GLINT_RUN_MIXED */
        run_any(look, at, bytes, w, phase, swapped);
    }
}

void glint_dither_span(const struct glint_tables *tables, const struct glint_span *span,
                       const struct glint_surface *surface)
{
    const struct glint_dither_look look = glint_dither_look_up(tables, surface->y);
    uint8_t *out = (uint8_t *)surface->pixels;
    struct glint_span at = *span;
    for (uint32_t left = at.w; left; out += 2 * GLINT_SPAN_RUN) { /* GLINT_SPAN_RUN is a multiple of 4: x mod 4 stays */
        const uint32_t w = left < GLINT_SPAN_RUN ? left : GLINT_SPAN_RUN;
        dithered_run(&look, &at, w, out, 2 * (surface->x & 3u), glint_is_swapped(tables));
        glint_run_next(&at);
        left -= w;
    }
}
