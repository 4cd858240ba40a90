/* SPDX-License-Identifier: MIT
 * The exact span. With N(k) = N0 + k s and D0 = N0 - H, t(k) = |N(k) - H|^2 / 2 = t0 + k (D0.s) + k^2 |s|^2 / 2. */
#include "glint_pixel.h"
#include "glint_pixel_prepared.h"

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

/* The next samples of a span that advances. */
static void span_walk(struct glint_span *at, struct glint_sample *sample, unsigned count)
{
    const struct glint_sample *end = sample + count;
    uint32_t t = at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30;
    do {
        const uint32_t nl_q16 = glint_sample_nl((int32_t)nl);
        sample->nl_q16 = nl_q16;
        sample->t_q30 = nl_q16 == 0 ? UINT32_MAX : t >= GLINT_NEGATIVE_T ? 0 : t;
        t += dt;
        dt += at->ddt_q30;
        nl += (uint32_t)at->dnl_q30;
    } while (++sample != end);
    at->t_q30 = t;
    at->dt_q30 = dt;
    at->nl_q30 = (int32_t)nl;
}

enum glint_err glint_shade_prepared_span(const struct glint_prepared *prepared, const struct glint_span *span,
                                         const struct glint_surface *surface, struct glint_box *highlight)
{
    if (!prepared || !span || !surface || !surface->pixels)
        return GLINT_ERR_ARG;
    struct glint_run run = {(uint8_t *)surface->pixels, 0, surface->x, surface->y, NULL, NULL, NULL};
    struct glint_sample samples[GLINT_RUN];
    struct glint_span at = *span;
    uint32_t first = span->w, last = 0;
    while (run.x < span->w) {
        const uint32_t left = span->w - run.x;
        const unsigned count = left < GLINT_RUN ? (unsigned)left : GLINT_RUN;
        span_walk(&at, samples, count);
        glint_prepared_run(prepared, &run, samples, count);
        for (unsigned i = 0; highlight && i < count; i++) {
            if (samples[i].t_q30 >= prepared->near.t_end)
                continue;
            first = run.x + i < first ? run.x + i : first;
            last = run.x + i + 1;
        }
        run.x += count;
    }
    if (highlight) {
        const struct glint_box none = {0, 0, 0, 0}, box = {(uint16_t)first, 0, (uint16_t)(last - first), 1};
        *highlight = last ? box : none;
    }
    return GLINT_OK;
}
