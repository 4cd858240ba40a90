/* SPDX-License-Identifier: MIT
 * The exact span of any model and format, and the one by c, as gateware draws it. */
#include "glint_lobe_domain.h"
#include "glint_pixel.h"

enum glint_err glint_shade_span(const struct glint_shader *shader, const struct glint_span *span,
                                const struct glint_surface *surface, struct glint_box *highlight)
{
    struct glint_prepared prepared;
    if (!shader || !span || !surface || !surface->pixels)
        return GLINT_ERR_ARG;
    const enum glint_err err = glint_shade_prepare(&prepared, shader);
    return err ? err : glint_shade_prepared_span(&prepared, span, surface, highlight);
}

enum glint_err glint_shade_span_c16(const struct glint_shader *shader, const struct glint_span *span,
                                    const struct glint_surface *surface, struct glint_box *highlight)
{
    if (!shader || !span || !surface || !surface->pixels)
        return GLINT_ERR_ARG;
    const enum glint_err err = glint_pixel_check(shader);
    if (err)
        return err;
    uint32_t t = span->t_q30, dt = span->dt_q30;
    uint32_t nl = (uint32_t)span->nl_q30;
    struct glint_box box = {0, 0, 0, 0};
    for (uint16_t x = 0; x < span->w; x++) {
        const uint32_t nl_q16 = glint_pixel_nl((int32_t)nl);
        const int32_t c_q16 = glint_c_of_t(t >= GLINT_NEGATIVE_T ? 0 : t);
        const uint32_t f = nl_q16 ? glint_pixel_peak(shader, glint_lobe_eval(&shader->lobe, c_q16)) : 0;
        glint_pixel_store(shader, surface, x, 0, nl_q16, f, shader->material.albedo, 255);
        if (f) {
            if (box.w == 0)
                box.x = x;
            box.w = (uint16_t)(x - box.x + 1);
            box.h = 1;
        }
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
    if (highlight)
        *highlight = box;
    return GLINT_OK;
}
