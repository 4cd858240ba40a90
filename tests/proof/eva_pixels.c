/* SPDX-License-Identifier: MIT
 * For Eva: a run of GLINT_RUN samples, or of one, by each group of formats and by each model's loop, with any material, colour, albedo, gloss,
 * coverage, place on the screen, t, N.L and F; and steps 1 and 2 of any normal under any light.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-ilevel 64 -eva-use-spec VALUES */
#include "eva.h"
#include "glint_lobe.h"
#include "glint_pixel.h"

static uint8_t pixels[4 * (GLINT_RUN + 3)], albedo[3 * GLINT_RUN], gloss[GLINT_RUN], coverage[GLINT_RUN + 3];

static struct glint_sample samples[3 * GLINT_RUN];

/* Under one white light, one coloured light, or as several leave it. */
static void draw(const struct glint_use_format *format, const struct glint_output *output, const uint8_t *colours,
                 const uint8_t *shine, unsigned count)
{
    const struct glint_material material = any_material(GLINT_LYON);
    struct glint_paint paint;
    struct glint_run run = {pixels, any % 4, any, any, colours, shine, any ? coverage : NULL, 0, format, NULL};
    (void)glint_paint_exact_for(&paint, &material, output, &glint_use_lyon, format);
    if (any) {
        for (unsigned k = 0; k < 3; k++)
            paint.color_q16[k] = any % (GLINT_LIGHT_COLOR_MAX + 1);
        glint_paint_fold(&paint, any & 1);
    } else if (any) {
        paint.of.exact.slack = (uint16_t)any;
        paint.of.exact.high = (uint16_t)any;
        paint.of.exact.w = any;
        paint.of.exact.w_maps = any;
        run.apart = GLINT_RUN;
    }
    (void)format->levels(&paint, &run, samples, count);
    if (output->space == GLINT_GAMMA)
        (void)glint_levels_apart(&paint, &run, samples, count);
    format->exact(&paint, &run, any % count, samples, any & 1);
}

/* The same blended: in gamma space by what draws coverage. */
static void blend(uint8_t format, const struct glint_use_format *use, bool dither)
{
    const struct glint_output output = {format, GLINT_GAMMA, dither};
    ANY_BYTES(samples);
    ANY_BYTES(albedo);
    ANY_BYTES(coverage);
    ANY_BYTES(pixels);
    for (unsigned mapped = 0; mapped < 2; mapped++) {
        const struct glint_material material = any_material(GLINT_LYON);
        struct glint_paint paint;
        struct glint_run run = {pixels,   any % 4, any, any, mapped ? albedo : NULL, mapped ? gloss : NULL,
                                coverage, 0,       use, NULL};
        (void)glint_paint_exact_for(&paint, &material, &output, &glint_use_lyon, use);
        glint_run_soften(&run, &paint, &glint_use_coverage);
        (void)glint_run_levels(&paint, &run, samples, GLINT_RUN);
        glint_run_exact(&paint, &run, any % GLINT_RUN, samples, any & 1);
    }
}
void eva_blend_rgb565(void)
{
    blend(GLINT_RGB565, &glint_use_rgb565, false);
    blend(GLINT_RGB565_SWAPPED, &glint_use_rgb565, true);
}
void eva_blend_rgb888(void)
{
    blend(GLINT_RGB888, &glint_use_rgb888, true);
    blend(GLINT_XRGB8888, &glint_use_rgb888, false);
}
void eva_blend_grey(void)
{
    blend(GLINT_GREY8, &glint_use_grey, false);
    blend(GLINT_MONO, &glint_use_grey, true);
}

static void draws(const struct glint_use_format *use, uint8_t format, uint8_t space, bool dither, unsigned count)
{
    const struct glint_output output = {format, space, dither};
    ANY_BYTES(samples);
    ANY_BYTES(albedo);
    ANY_BYTES(gloss);
    ANY_BYTES(coverage);
    draw(use, &output, NULL, NULL, count);
    draw(use, &output, NULL, gloss, count);
    draw(use, &output, albedo, NULL, count);
    draw(use, &output, albedo, gloss, count);
}

#define KIND(kind, format, space, name)                                                                                \
    void eva_##name(void)                                                                                              \
    {                                                                                                                  \
        draws(&glint_use_##kind, format, space, false, GLINT_RUN);                                                     \
    }                                                                                                                  \
    void eva_##name##_dithered(void)                                                                                   \
    {                                                                                                                  \
        draws(&glint_use_##kind, format, space, true, GLINT_RUN);                                                      \
    }
/* One sample: levels that are set where they are read. */
#define ONE(format, name)                                                                                              \
    void eva_##name##_one(void)                                                                                        \
    {                                                                                                                  \
        draws(&glint_use_linear, format, GLINT_LINEAR, false, 1);                                                      \
    }
KIND(rgb565, GLINT_RGB565, GLINT_GAMMA, rgb565)
KIND(rgb565, GLINT_RGB565_SWAPPED, GLINT_GAMMA, rgb565_swapped)
KIND(rgb888, GLINT_RGB888, GLINT_GAMMA, rgb888)
KIND(rgb888, GLINT_BGR888, GLINT_GAMMA, bgr888)
KIND(rgb888, GLINT_XRGB8888, GLINT_GAMMA, xrgb8888)
KIND(rgb888, GLINT_ARGB8888, GLINT_GAMMA, argb8888)
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

/* F from below of any t, its ends apart, and t_end of any lobe. */
static void shine(const struct glint_use_model *model)
{
    const uint32_t one = GLINT_T_ONE, ts[] = {0, one, 1 + any % (one - 1), one + 1 + any % (UINT32_MAX - one)};
    struct glint_paint paint;
    paint.of.exact.t_end = 1 + any % (GLINT_T_ONE + 1);
    paint.of.exact.f_max = any;
    paint.of.exact.n = 1 + any % GLINT_N_MAX;
    if (model->fold)
        model->fold(&paint);
    for (unsigned i = 0; i < sizeof ts / sizeof *ts; i++) {
        struct glint_sample sample = {ts[i], any, 0};
        model->run(&paint, &sample, 1);
    }
}
#define SHINE_own(model)                                                                                               \
    void eva_##model##_near(void)                                                                                      \
    {                                                                                                                  \
        shine(&glint_use_##model);                                                                                     \
    }
#define SHINE_shared(model)
#define SHINE(number, name, function, use, grain) SHINE_##use(name)
GLINT_MODELS(SHINE)

static void geometry(glint_geometry *of)
{
    const struct glint_view view = any_view();
    const struct glint_vec normals[2] = {any_vector(), any_vector()};
    struct glint_sample made[2];
    of(&view.l, &view.v, &view.h, normals, made, 2);
}
void eva_samples_half(void)
{
    geometry(glint_samples_half);
}
void eva_samples_phong(void)
{
    geometry(glint_samples_phong);
}

/* One pixel by the 64-bit sequence, under a white light or a coloured one. */
static void exactly(const struct glint_use_format *use, uint8_t format, uint8_t space)
{
    const struct glint_output output = {format, space, any & 1};
    const struct glint_material material = any_material(GLINT_LYON);
    const struct glint_run run = {pixels, any % 4, any, any, any & 1 ? albedo : NULL, any & 1 ? gloss : NULL,
                                  NULL,   0,       use, NULL};
    const struct glint_sample sample = {any, any % 65537, any};
    struct glint_paint paint;
    (void)glint_paint_exact_for(&paint, &material, &output, &glint_use_lyon, use);
    paint.of.exact.high = (uint16_t)any;
    for (unsigned k = 0; k < 3; k++)
        paint.color_q16[k] = any % (GLINT_LIGHT_COLOR_MAX + 1);
    glint_paint_exactly(&paint, &run, any % GLINT_RUN, &sample);
}
void eva_paint_exactly(void)
{
    ANY_BYTES(albedo);
    ANY_BYTES(gloss);
    exactly(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA);
    exactly(&glint_use_rgb888, GLINT_ARGB8888, GLINT_GAMMA);
    exactly(&glint_use_grey, GLINT_MONO, GLINT_GAMMA);
    for (uint8_t format = 0; format < GLINT_FORMAT_COUNT; format++)
        exactly(&glint_use_linear, format, GLINT_LINEAR);
}
