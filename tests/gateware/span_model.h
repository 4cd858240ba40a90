/* SPDX-License-Identifier: MIT
 * The span unit's pixels, by the sequence that firmware/gateware/README.md states: lib/sequence.md's span and pixel but for step 3, which takes F from
 * the cosine. In 64 bits, of a material with albedo 255 in gamma space, undithered. */
#ifndef SPAN_MODEL_H
#define SPAN_MODEL_H

#include <string.h>

#include "glint.h"

static inline uint32_t span_model_c_min(const struct glint_material *m)
{
    return glint_cutoff((enum glint_model)m->model, m->n, m->q ? m->q : 6);
}

/* A channel: floor(min(1, ambient + diffuse nl + specular F) max + 1/2), 2^32 = 1.0. */
static inline uint32_t span_model_level(const struct glint_material *m, int k, uint32_t nl, uint32_t f)
{
    const uint64_t one = (uint64_t)1 << 32, max = k == 1 ? 63 : 31;
    const uint64_t sum =
        ((uint64_t)m->ambient_q16[k] << 16) + (uint64_t)m->diffuse_q16[k] * nl + (uint64_t)m->specular_q16[k] * f;
    return (uint32_t)(((sum < one ? sum : one) * max + one / 2) >> 32);
}

/* RGB565 of each pixel. */
static inline void span_model(const struct glint_material *m, uint32_t c_min, const struct glint_span *span,
                              uint16_t *pixels)
{
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    for (unsigned x = 0; x < span->w; x++) {
        const int64_t nl_q16 = ((int64_t)(int32_t)nl + (1 << 13)) >> 14;
        const uint32_t lit = nl_q16 < 0 ? 0 : nl_q16 > 65536 ? 65536 : (uint32_t)nl_q16;
        const uint32_t used = t >= UINT32_C(0xf8000000) ? 0 : t; /* a little below 0 */
        const int32_t c = 65536 - (int32_t)(((uint64_t)used + (1 << 13)) >> 14);
        uint32_t f = lit && c >= (int32_t)c_min ? glint_eval((enum glint_model)m->model, m->n, c) : 0;
        f = m->clamp_peak && f > 65536 ? 65536 : f;
        pixels[x] = (uint16_t)(span_model_level(m, 0, lit, f) << 11 | span_model_level(m, 1, lit, f) << 5 |
                               span_model_level(m, 2, lit, f));
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
}
/* A paint under a light from there, seen from the front: what glint_span_init makes spans under. */
static inline enum glint_err span_model_light(struct glint_paint *paint, const int32_t to_light[3])
{
    static const int32_t in_front[3] = {0, 0, 1};
    struct glint_material material;
    struct glint_output output;
    struct glint_light light;
    memset(&material, 0, sizeof material);
    memset(&output, 0, sizeof output);
    material.n = 60;
    enum glint_err err = glint_light_directional(&light, to_light);
    if (err == GLINT_OK)
        err = glint_paint_exact_for(paint, &material, &output, &glint_use_msh, &glint_use_rgb565);
    return err == GLINT_OK ? glint_paint_light(paint, &light, 1, in_front) : err;
}

#endif
