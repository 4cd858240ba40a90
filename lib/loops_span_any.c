/* SPDX-License-Identifier: MIT */
#include "glint_loops_span_any.h"
#include "glint_loops_dither.h"
#include "glint_loops_small.h"
#include "glint_pixel.h"
#include "glint_tables_geometry.h"

/* Pixel by pixel, each on its own and stored byte by byte: slow, right for every address and every span. */
static void colour_span_odd(const struct glint_tables *tables, const struct glint_span *span, uint8_t *out)
{
    struct glint_span at = *span;
    for (uint16_t x = 0; x < span->w; x++, out += 2) {
        uint16_t pixel = tables->dark;
        if (at.nl_q30 >= 0) {
            const uint32_t t = at.t_q30 >= GLINT_NEGATIVE_T ? 0 : at.t_q30;
            uint32_t step = 0;
            if (t <= tables->t_max_q30)
                step = tables->columns[(tables->t_max_q30 - t) >> tables->shift];
            pixel =
                tables->colour.colours[((uint32_t)at.nl_q30 >> GLINT_COLOUR_ROW_SHIFT) * GLINT_COLOUR_STEPS + step / 2];
        }
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
