/* SPDX-License-Identifier: MIT */
#include "glint_loops_span_any.h"
#include "glint_loops_dither.h"
#include "glint_loops_look.h"
#include "glint_loops_small.h"

/* Stored byte by byte: slow, right for every address. */
static void colour_span_odd(const struct glint_tables *tables, const struct glint_span *span, uint8_t *out)
{
    const struct glint_look look = glint_look_up(tables);
    struct glint_span at = *span;
    for (uint16_t x = 0; x < span->w; x++, out += 2) {
        uint16_t pixel;
        glint_look_store(&look, look.t_max - at.t_q30, (uint32_t)at.nl_q30, &pixel);
        out[0] = ((const uint8_t *)&pixel)[0];
        out[1] = ((const uint8_t *)&pixel)[1];
        at.t_q30 += at.dt_q30;
        at.dt_q30 += at.ddt_q30;
        at.nl_q30 = (int32_t)((uint32_t)at.nl_q30 + (uint32_t)at.dnl_q30);
    }
}

enum glint_err glint_span_any(const struct glint_tables *tables, const struct glint_span *span,
                              const struct glint_surface *surface)
{
    if (!tables || !span || !surface || !surface->pixels || tables->kind == GLINT_TABLES_ALBEDO)
        return GLINT_ERR_ARG;
    if (tables->kind == GLINT_TABLES_SMALL)
        glint_small_span(tables, span, surface);
    else if (tables->dither)
        glint_dither_span(tables, span, surface);
    else
        colour_span_odd(tables, span, (uint8_t *)surface->pixels);
    return GLINT_OK;
}
