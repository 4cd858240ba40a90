/* SPDX-License-Identifier: MIT
 * Internal. Runs of a span, up to GLINT_SPAN_RUN pixels: which are all alike. */
#ifndef GLINT_LOOPS_RUN_H
#define GLINT_LOOPS_RUN_H

#include "glint.h"
#include "glint_tables_geometry.h"

/* nl < 0 throughout; lit, and past t_max throughout; lit, and t = 0..t_max throughout; any. */
enum glint_run_kind { GLINT_RUN_DARK, GLINT_RUN_OUTSIDE, GLINT_RUN_INSIDE, GLINT_RUN_MIXED };

/* Modulo 2^32 t is convex and nl linear only where no sum wraps: with steps below 2^25 and ddt below 2^20, 31 steps
 * change nl by less than 2^30, and t by -2^30 .. 3 * 2^29. */
#define GLINT_RUN_BIG ((uint32_t)1 << 25)

static inline bool glint_run_is_big(uint32_t step)
{
    return (step + GLINT_RUN_BIG) >> 26 != 0;
}

/* w = 1..GLINT_SPAN_RUN. */
static inline enum glint_run_kind glint_run_kind(const struct glint_span *at, uint32_t w, uint32_t t_max_q30)
{
    const uint32_t m = w - 1u;
    const uint32_t last_nl = (uint32_t)at->nl_q30 + m * (uint32_t)at->dnl_q30;
    if (glint_run_is_big((uint32_t)at->dnl_q30) || glint_run_is_big(at->dt_q30) || at->ddt_q30 >> 20)
        return GLINT_RUN_MIXED;
    if ((int32_t)((uint32_t)at->nl_q30 | last_nl | at->t_q30) < 0)
        return (at->nl_q30 & (int32_t)last_nl) < 0 ? GLINT_RUN_DARK : GLINT_RUN_MIXED;
    const int32_t t_max = (int32_t)t_max_q30, back = t_max - (int32_t)at->t_q30;
    const int32_t fall = (int32_t)(m * at->dt_q30);
    const int32_t highest = fall < 0 ? back - fall : back; /* t is not below the tangent at the start */
    if (highest < 0)
        return GLINT_RUN_OUTSIDE;
    return back >= 0 && highest <= t_max && back - fall - (int32_t)((m * (m - 1) >> 1) * at->ddt_q30) >= 0
               ? GLINT_RUN_INSIDE
               : GLINT_RUN_MIXED;
}

/* The span from the next run on: t is quadratic in the pixel's number. */
static inline void glint_run_next(struct glint_span *at)
{
    const uint32_t n = GLINT_SPAN_RUN;
    at->t_q30 += n * at->dt_q30 + n * (n - 1) / 2 * at->ddt_q30;
    at->dt_q30 += n * at->ddt_q30;
    at->nl_q30 = (int32_t)((uint32_t)at->nl_q30 + n * (uint32_t)at->dnl_q30);
}

#endif
