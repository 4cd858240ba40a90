/* SPDX-License-Identifier: MIT
 * For Eva: a run of GLINT_RUN samples, or of one, by each kind of pixel and by each model's loop, with any material, albedo, gloss,
 * mask, place on the screen, t, N.L and F; and steps 1 and 2 of any normal under any light.
 * eva: -eva-precision 1 -eva-min-loop-unroll 17 -eva-use-spec glint_msh_t,glint_schlick_t,glint_blinn_t,glint_gauss_t,glint_cayley_t,glint_lyon_t */
#include "eva.h"
#include "glint_lights_apart.h"
#include "glint_pixel.h"
#include "glint_pixel_prepared.h"
#include "glint_rect.h"

static uint8_t pixels[4 * (GLINT_RUN + 3)], albedo[3 * GLINT_RUN], gloss[GLINT_RUN], mask[GLINT_RUN + 3];

static struct glint_sample samples[3 * GLINT_RUN];

static void draw(const struct glint_shade_format *kind, const struct glint_shader *shader, const uint8_t *colours,
                 const uint8_t *shine, unsigned count)
{
    struct glint_prepared prepared;
    glint_prepared_fill(&prepared, shader, &glint_shade_lyon, kind);
    if (any) { /* as several lamps leave it */
        prepared.slack = (uint16_t)any;
        prepared.high = (uint8_t)any;
        prepared.w = any;
        prepared.w_maps = any;
        prepared.apart = GLINT_RUN;
    }
    const struct glint_run run = {pixels, any % 4, any, any, colours, shine, any ? mask : NULL};
    (void)kind->levels(&prepared, &run, samples, count);
    if (shader->space == GLINT_GAMMA)
        (void)glint_apart_levels(&prepared, &run, samples, count);
    kind->exact(shader, &run, any % count, any, any);
}

static void draws(const struct glint_shade_format *kind, uint8_t format, uint8_t space, bool dither, unsigned count)
{
    const struct glint_shader shader = any_shader(format, space, dither);
    ANY_BYTES(samples);
    ANY_BYTES(albedo);
    ANY_BYTES(gloss);
    ANY_BYTES(mask);
    draw(kind, &shader, NULL, NULL, count);
    draw(kind, &shader, NULL, gloss, count);
    draw(kind, &shader, albedo, NULL, count);
    draw(kind, &shader, albedo, gloss, count);
}

#define KIND(kind, format, space, name)                                                                                \
    void eva_##name(void)                                                                                              \
    {                                                                                                                  \
        draws(&glint_shade_##kind, format, space, false, GLINT_RUN);                                                   \
    }                                                                                                                  \
    void eva_##name##_dithered(void)                                                                                   \
    {                                                                                                                  \
        draws(&glint_shade_##kind, format, space, true, GLINT_RUN);                                                    \
    }
/* One sample: levels that are set where they are read. */
#define ONE(format, name)                                                                                              \
    void eva_##name##_one(void)                                                                                        \
    {                                                                                                                  \
        draws(&glint_shade_linear, format, GLINT_LINEAR, false, 1);                                                    \
    }
KIND(rgb565, GLINT_RGB565, GLINT_GAMMA, rgb565)
KIND(rgb565, GLINT_RGB565_SWAPPED, GLINT_GAMMA, rgb565_swapped)
KIND(rgb888, GLINT_RGB888, GLINT_GAMMA, rgb888)
KIND(bgr888, GLINT_BGR888, GLINT_GAMMA, bgr888)
KIND(bgr888, GLINT_XRGB8888, GLINT_GAMMA, xrgb8888)
KIND(bgr888, GLINT_ARGB8888, GLINT_GAMMA, argb8888)
KIND(grey, GLINT_GREY8, GLINT_GAMMA, grey8)
KIND(grey, GLINT_MONO, GLINT_GAMMA, mono)
KIND(linear, GLINT_RGB565, GLINT_LINEAR, linear_rgb565)
ONE(GLINT_RGB565, linear_rgb565)
KIND(linear, GLINT_RGB565_SWAPPED, GLINT_LINEAR, linear_rgb565_swapped)
ONE(GLINT_RGB565_SWAPPED, linear_rgb565_swapped)
KIND(linear, GLINT_RGB888, GLINT_LINEAR, linear_rgb888)
ONE(GLINT_RGB888, linear_rgb888)
KIND(linear, GLINT_BGR888, GLINT_LINEAR, linear_bgr888)
ONE(GLINT_BGR888, linear_bgr888)
KIND(linear, GLINT_XRGB8888, GLINT_LINEAR, linear_xrgb8888)
ONE(GLINT_XRGB8888, linear_xrgb8888)
KIND(linear, GLINT_ARGB8888, GLINT_LINEAR, linear_argb8888)
ONE(GLINT_ARGB8888, linear_argb8888)
KIND(linear, GLINT_GREY8, GLINT_LINEAR, linear_grey8)
ONE(GLINT_GREY8, linear_grey8)
KIND(linear, GLINT_MONO, GLINT_LINEAR, linear_mono)
ONE(GLINT_MONO, linear_mono)

/* F from below of any t < t_end, and t_end of any lobe. */
static void shine(const struct glint_shade_model *model)
{
    struct glint_near near = {1 + any % (GLINT_T_ONE + 1), any, 1 + any % GLINT_N_MAX, {0, 0, 0}};
    struct glint_sample sample = {any, any, 0};
    if (model->fold)
        model->fold(&near);
    model->run(&near, &sample, 1);
}
#define SHINE(model)                                                                                                   \
    void eva_##model##_near(void)                                                                                      \
    {                                                                                                                  \
        shine(&glint_shade_##model);                                                                                   \
    }
SHINE(msh)
SHINE(schlick)
SHINE(blinn)
SHINE(gauss)
SHINE(cayley)
SHINE(lyon)

static void geometry(void (*of)(const struct glint_light *, const struct glint_vec *, struct glint_sample *, unsigned))
{
    const struct glint_light light = any_light();
    const struct glint_vec normals[2] = {any_vector(), any_vector()};
    struct glint_sample samples[2];
    of(&light, normals, samples, 2);
}
void eva_samples_unit(void)
{
    geometry(glint_samples_unit);
}
void eva_samples_wide(void)
{
    geometry(glint_samples_wide);
}
void eva_samples_phong(void)
{
    geometry(glint_shade_phong.geometry);
}
uint32_t eva_phong_t(void)
{
    const struct glint_light light = any_light();
    const struct glint_vec normal = any_vector();
    return glint_phong_t(&normal, &light);
}

/* The 64-bit sequence of one pixel. */
void eva_pixel(void)
{
    const struct glint_shader shader = any_shader((uint8_t)(any % GLINT_FORMAT_COUNT), any & 1, any & 1);
    const struct glint_surface surface = {pixels, 0, (uint16_t)any, (uint16_t)any};
    glint_pixel_store(&shader, &surface, any % GLINT_RUN, 0, glint_pixel_nl(any_signed), any, albedo, (uint8_t)any);
}
