/* SPDX-License-Identifier: MIT
 * The exact span. With N(k) = N0 + k s and D0 = N0 - H, t(k) = |N(k) - H|^2 / 2 = t0 + k (D0.s) + k^2 |s|^2 / 2. */
#include "glint_lobe_domain.h"
#include "glint_pixel.h"

static int64_t divide(int64_t a, int64_t b) /* to nearest; b > 0 */
{
    return (a < 0 ? a - b / 2 : a + b / 2) / b;
}

enum glint_err glint_span_init(struct glint_span *span, const struct glint_light *light, const struct glint_vec *first,
                               const struct glint_vec *last, uint16_t w)
{
    if (!span || !light || !first || !last || w > GLINT_SPAN_MAX)
        return GLINT_ERR_ARG;
    const int64_t t0 = (int64_t)(glint_distance_squared(first, &light->h) >> 1);
    const int64_t t1 = (int64_t)(glint_distance_squared(last, &light->h) >> 1);
    const int64_t nl0 = glint_dot(first, &light->l), nl1 = glint_dot(last, &light->l), limit = INT32_MAX - (1 << 13);
    /* t is convex, nl linear: the ends bound them, but for the rounding of the steps, < w^2 / 16 + w <= 2^21 */
    if (t0 > INT64_C(0xf0000000) || t1 > INT64_C(0xf0000000) || nl0 > limit || nl0 < -limit || nl1 > limit ||
        nl1 < -limit)
        return GLINT_ERR_VECTOR;
    const int64_t m = w > 1 ? w - 1 : 1;
    const int64_t ddt = divide((int64_t)glint_distance_squared(last, first), m * m);
    span->ddt_q30 = (uint32_t)ddt;
    span->dt_q30 = (uint32_t)divide(t1 - t0 - ddt * (m * (m - 1) / 2), m); /* so that the last pixel is right */
    span->t_q30 = (uint32_t)t0;
    span->nl_q30 = (int32_t)nl0;
    span->dnl_q30 = (int32_t)divide(nl1 - nl0, m);
    span->w = w;
    return GLINT_OK;
}

/* By t, or by the nearest c: as gateware does. */
static inline uint32_t lobe(const struct glint_shader *shader, uint32_t t_q30, bool by_c)
{
    if (!by_c)
        return glint_pixel_lobe(shader, t_q30);
    return glint_pixel_peak(shader, glint_lobe_eval(&shader->lobe, glint_c_of_t(t_q30)));
}

static inline enum glint_err shade(const struct glint_shader *shader, const struct glint_span *span,
                                   const struct glint_surface *surface, struct glint_box *highlight, bool by_c)
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
        const uint32_t f = nl_q16 ? lobe(shader, t >= GLINT_NEGATIVE_T ? 0 : t, by_c) : 0;
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

enum glint_err glint_shade_span(const struct glint_shader *shader, const struct glint_span *span,
                                const struct glint_surface *surface, struct glint_box *highlight)
{
    return shade(shader, span, surface, highlight, false);
}

enum glint_err glint_shade_span_c16(const struct glint_shader *shader, const struct glint_span *span,
                                    const struct glint_surface *surface, struct glint_box *highlight)
{
    return shade(shader, span, surface, highlight, true);
}
