/* SPDX-License-Identifier: MIT
 * Spans over COLOUR tables, up to GLINT_RUN pixels at a time. Of those it is cheap to know that all are alike, for t is
 * convex and nl linear; then each takes but the additions that its kind needs. */
#include "glint_tables.h"

#if !GLINT_CORTEX_M0PLUS_ASM
/* Modulo 2^32 t is convex and nl linear only where no sum wraps: with steps below 2^25 and ddt below 2^20, 31 steps
 * change nl by less than 2^30, and t by -2^30 .. 3 * 2^29. */
#define BIG ((uint32_t)1 << 25)

static inline bool is_big(uint32_t step)
{
    return (step + BIG) >> 26 != 0;
}

static inline void run(const struct glint_tables *tables, const struct glint_span *at, uint32_t w, uint16_t *out)
{
    const uint32_t m = w - 1u;
    const uint32_t last_nl = (uint32_t)at->nl_q30 + m * (uint32_t)at->dnl_q30;
    if (is_big((uint32_t)at->dnl_q30) || is_big(at->dt_q30) || at->ddt_q30 >> 20) {
        glint_run_mixed(tables, at, out, out + w);
    } else if ((int32_t)((uint32_t)at->nl_q30 | last_nl | at->t_q30) < 0) {
        if ((at->nl_q30 & (int32_t)last_nl) < 0)
            glint_run_dark(tables, at, out, out + w);
        else
            glint_run_mixed(tables, at, out, out + w);
    } else {
        const int32_t t_max = (int32_t)tables->t_max_q30, back = t_max - (int32_t)at->t_q30;
        const int32_t fall = (int32_t)(m * at->dt_q30);
        /* t is not below the tangent at the start */
        const int32_t highest = fall < 0 ? back - fall : back;
        if (highest < 0)
            glint_run_outside(tables, at, out, out + w);
        else if (back >= 0 && highest <= t_max && back - fall - (int32_t)((m * (m - 1) >> 1) * at->ddt_q30) >= 0)
            glint_run_inside(tables, at, out, out + w);
        else
            glint_run_mixed(tables, at, out, out + w);
    }
}

void glint_colour_run(const struct glint_tables *tables, const struct glint_span *at, uint16_t w, uint16_t *out)
{
    run(tables, at, w, out);
}

enum glint_err glint_tables_span(const struct glint_tables *tables, const struct glint_span *span,
                                 const struct glint_surface *surface)
{
    if (!tables || !span || !surface || !surface->pixels || tables->kind != GLINT_TABLES_COLOUR ||
        GLINT_MISALIGNED(surface->pixels, 16) || span->w - 1u >= GLINT_RUN)
        return glint_span_any(tables, span, surface);
    run(tables, span, span->w, (uint16_t *)surface->pixels);
    return GLINT_OK;
}
#endif
