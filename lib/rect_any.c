/* SPDX-License-Identifier: MIT
 * The exact rectangle of any model and format: it links all of them. */
#include "glint_pixel.h"
#include "glint_rect.h"

enum glint_err glint_rect_check(const struct glint_shader *shader, const struct glint_source *source,
                                const struct glint_surface *surface)
{
    return !shader || !glint_rect_can(source, surface) ? GLINT_ERR_ARG : glint_pixel_check(shader);
}

enum glint_err glint_shade_rect(const struct glint_shader *shader, const struct glint_source *source, uint16_t w,
                                uint16_t h, const struct glint_surface *surface, struct glint_box *highlight)
{
    struct glint_prepared prepared;
    enum glint_err err = glint_rect_check(shader, source, surface);
    if (!err)
        err = glint_shade_prepare(&prepared, shader);
    return err ? err : glint_shade_prepared_rect(&prepared, source, w, h, surface, highlight);
}
