/* SPDX-License-Identifier: MIT
 * Random lights about the random scenes: directional, with a place, and white. */
#ifndef GLINT_UNIT_LAMPS_H
#define GLINT_UNIT_LAMPS_H

#include "shading.h"

enum { ONE_Q30 = 1 << 30, PIXEL = 16 };

static inline int32_t within(int32_t limit)
{
    return (int32_t)below(2 * (uint32_t)limit + 1) - limit;
}

static inline int32_t cosine(double degrees)
{
    return (int32_t)lround(ONE_Q30 * cos(degrees * M_PI / 180));
}

/* Which one a light is. */
enum kind { DIRECTIONAL, POINT, SPOT };
static inline enum kind kind_of(const struct glint_light *light)
{
    static const int32_t here[3] = {0, 0, 1};
    struct glint_light directional, point;
    assert_int_equal(glint_light_directional(&directional, here), GLINT_OK);
    assert_int_equal(glint_light_point(&point, here, 1), GLINT_OK);
    return light->kind == directional.kind ? DIRECTIONAL : light->kind == point.kind ? POINT : SPOT;
}

static inline struct glint_light random_light(void)
{
    struct glint_light light;
    enum glint_err err;
    do {
        const int32_t a[3] = {(int32_t)below(W * PIXEL), (int32_t)below(H * PIXEL), within(600)};
        const int32_t b[3] = {(int32_t)below(W * PIXEL), (int32_t)below(H * PIXEL), within(100)};
        const int32_t direction[3] = {within(100), within(100), within(100) + 50};
        const uint32_t range = 1 + below(1500);
        const double inner = below(9000) / 100., outer = inner + below(3000) / 100.;
        switch (below(3)) {
        case DIRECTIONAL:
            err = direction[0] | direction[1] || direction[2] > 0 ? glint_light_directional(&light, direction)
                                                                  : GLINT_ERR_VECTOR; /* not straight behind */
            break;
        case POINT:
            err = glint_light_point(&light, a, range);
            break;
        default:
            err = glint_light_spot(&light, a, b, range, cosine(inner), cosine(outer));
        }
    } while (err != GLINT_OK);
    for (int k = 0; k < 3; k++)
        light.color_q16[k] = below(4) ? below(65537) : 65536;
    return light;
}

static inline void random_lights(struct glint_light lights[GLINT_LIGHTS_MAX])
{
    for (unsigned i = 0; i < GLINT_LIGHTS_MAX; i++)
        lights[i] = random_light();
}

static inline void white(struct glint_light *light)
{
    for (int k = 0; k < 3; k++)
        light->color_q16[k] = 65536;
}

/* An exact paint of the look under these, seen from the look's viewer. */
static inline enum glint_err draw_under(const struct look *look, const struct glint_light *lights, unsigned count,
                                        const struct glint_maps *maps, uint16_t w, uint16_t h,
                                        const struct glint_surface *target, struct glint_box *highlight)
{
    struct glint_paint paint;
    assert_int_equal(glint_paint_exact(&paint, &look->material, &look->output), GLINT_OK);
    const enum glint_err err = glint_paint_light(&paint, lights, count, look->to_viewer);
    return err ? err : glint_draw_rect(&paint, maps, w, h, target, highlight);
}

/* The same of a scene. */
static inline void draw_scene_under(struct scene *s, const struct glint_light *lights, unsigned count,
                                    struct glint_box *highlight)
{
    assert_int_equal(draw_under(&s->look, lights, count, &s->maps, W, H, &s->surface, highlight), GLINT_OK);
}

#endif
