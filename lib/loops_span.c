/* SPDX-License-Identifier: MIT
 * Spans over COLOUR tables, GLINT_SPAN_RUN pixels at a time: a run. Of a run it is cheap to know that all its pixels are alike,
 * as t is convex and nl linear: three loops for three kinds take only the additions that their kind needs, and a fourth
 * takes any run. */
#include "glint_loops_look.h"
#include "glint_loops_run.h"
#include "glint_loops_span_any.h"
#include "glint_math_align.h"
#include "glint_math_assembly.h"
#include "glint_tables_geometry.h"

#if !GLINT_CORTEX_M0PLUS_ASM
/* nl < 0 throughout. */
static void run_dark(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out, const uint16_t *end)
{
    (void)at;
    const uint16_t pixel = tables->dark;
    while (out != end)
        *out++ = pixel;
}

/* Lit, and past the last column: nl alone. Unrolled by hand, as compilers do not at -O2. */
static void run_outside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                        const uint16_t *end)
{
    const struct glint_look look = glint_look_up(tables);
    const uint32_t dnl = (uint32_t)at->dnl_q30;
    uint32_t nl = (uint32_t)at->nl_q30;
    for (; end - out >= 4; out += 4) {
        out[0] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
        out[1] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
        out[2] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
        out[3] = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
    }
    for (; out != end; out++) {
        *out = glint_look_colour(&look, glint_look_row(nl));
        nl += dnl;
    }
}

/* Lit, and all columns: back = t_max - t, so that a column is back >> shift; here scaled, so that the shift is a constant. */
static void run_inside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                       const uint16_t *end)
{
    const struct glint_look look = glint_look_up(tables);
    const unsigned top = 32 - GLINT_COLOUR_COLUMNS_LOG, scale = top - tables->shift; /* a column takes the rest */
    uint32_t back = (tables->t_max_q30 - at->t_q30) << scale, dback = (0 - at->dt_q30) << scale;
    uint32_t nl = (uint32_t)at->nl_q30;
    const uint32_t ddback = (0 - at->ddt_q30) << scale, dnl = (uint32_t)at->dnl_q30;
    for (; out != end; out++) {
        *out = glint_look_colour(&look, glint_look_row(nl) + look.columns[back >> top]);
        back += dback;
        dback += ddback;
        nl += dnl;
    }
}

/* Anything: each pixel is asked. */
static void run_mixed(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                      const uint16_t *end)
{
    const struct glint_look look = glint_look_up(tables);
    uint32_t back = look.t_max - at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30;
    const uint32_t ddt = at->ddt_q30, dnl = (uint32_t)at->dnl_q30;
    for (; out != end; out++) {
        glint_look_store(&look, back, nl, out);
        back -= dt;
        dt += ddt;
        nl += dnl;
    }
}

static void run(const struct glint_tables *tables, const struct glint_span *at, uint32_t w, uint16_t *out)
{
    switch (glint_run_kind(at, w, tables->t_max_q30)) {
    case GLINT_RUN_DARK:
        run_dark(tables, at, out, out + w);
        break;
    case GLINT_RUN_OUTSIDE:
        run_outside(tables, at, out, out + w);
        break;
    case GLINT_RUN_INSIDE:
        run_inside(tables, at, out, out + w);
        break;
    default: /* GLINT_RUN_MIXED */
        run_mixed(tables, at, out, out + w);
    }
}

enum glint_err glint_tables_span(const struct glint_tables *tables, const struct glint_span *span,
                                 const struct glint_surface *surface)
{
    if (!tables || !span || !surface || !surface->pixels || tables->kind != GLINT_TABLES_COLOUR || tables->dither ||
        GLINT_MISALIGNED(surface->pixels, 16))
        return glint_span_any(tables, span, surface);
    uint16_t *out = (uint16_t *)surface->pixels;
    if (span->w <= GLINT_SPAN_RUN) {
        if (span->w)
            run(tables, span, span->w, out);
        return GLINT_OK;
    }
    struct glint_span at = *span;
    uint32_t left = at.w;
    for (; left > GLINT_SPAN_RUN; left -= GLINT_SPAN_RUN, out += GLINT_SPAN_RUN) {
        run(tables, &at, GLINT_SPAN_RUN, out);
        glint_run_next(&at);
    }
    run(tables, &at, left, out);
    return GLINT_OK;
}
#endif
