/* SPDX-License-Identifier: MIT
 * The demo's sphere by the library. */
#ifndef SPHERE_MODEL_H
#define SPHERE_MODEL_H

#include <math.h>

#include <vector>

extern "C" {
#include "orbit.h"
}
#include "sphere.h"
#include "span_model.h"

/* A paint under the frame's light: its L and H, and what spans are made under. */
static inline struct glint_paint orbit_frame(unsigned frame)
{
    int32_t to[3];
    struct glint_paint paint = {};
    orbit_light(to, frame, ORBIT_FRAMES);
    (void)span_model_light(&paint, to);
    return paint;
}

static inline struct glint_vec sphere_normal(int32_t i, int32_t j)
{
    /* a double holds 2^30 and its root's neighbours exactly */
    const struct glint_vec n = {(int16_t)(SPHERE_STEP * i), (int16_t)(SPHERE_STEP * j),
                                (int16_t)floor(sqrt((double)sphere_z2(i, j)))};
    return n;
}

static inline std::vector<glint_span> sphere_row(int row, const struct glint_paint &light)
{
    const int32_t j = SPHERE_Y - row, half = sphere_half_width(j);
    std::vector<glint_span> spans;
    for (int32_t done = 0, left = 2 * half, w; left > 0; done += w, left -= w) {
        w = sphere_span(done, left);
        const struct glint_vec from = sphere_normal(done - half, j), to = sphere_normal(done - half + w, j);
        struct glint_span span;
        (void)glint_span_init(&span, &light, &from, &to, (uint16_t)(w + 1));
        span.w =
            (uint16_t)(w + (left == w)); /* the pixel after the last is the next span's, but at the end of the row */
        spans.push_back(span);
    }
    return spans;
}

#endif
