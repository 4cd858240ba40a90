/* SPDX-License-Identifier: MIT
 * The library's pictures against the double-precision reference. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "unit.h"

#include "compare/compare.h"
#include "base/memory.h"
#include "compare/reference.h"
#include "draw/canvas.h"
#include "image/format.h"
#include "image/levels.h"
#include "image/picture.h"
#include "models/models.h"
#include "scene/scenes.h"

enum { SIDE = 96 };

static const struct shading plain = {.model = GLINT_MSH,
                                     .n = 60,
                                     .q = 8,
                                     .lamps = {{.direction = {-1, 1, 1}, .color = {1, 1, 1}}},
                                     .lamp_count = 1,
                                     .view = {0, 0, 1},
                                     .ambient = {.15, .15, .15},
                                     .diffuse = {.85, .85, .85},
                                     .specular = {.8, .8, .8},
                                     .color = {255, 128, 0},
                                     .format = GLINT_RGB888};

static struct comparison comparison_of(const struct scene *scene, const struct shading *shading)
{
    struct comparison comparison;
    struct levels *levels = shade_scene(scene, shading);
    compare(scene, shading, levels, &comparison);
    levels_free(levels);
    return comparison;
}

/* ---- the reference by itself ---- */

static void a_mirror_facing_light_and_viewer_has_the_peak(void **state)
{
    (void)state;
    struct scene *scene = scene_new(1, 1);
    struct shading shading = plain;
    memcpy(shading.lamps[0].direction, (const double[3]){0, 0, 5}, sizeof shading.lamps[0].direction);
    double value[3];
    for (unsigned k = 0; k < 3; k++)
        shading.specular[k] = .25;
    reference_line(scene, &shading, GLINT_MSH, 0, value);
    assert_float_equal(value[0], 1, 0); /* albedo and highlight exceed white */
    assert_true(fabs(value[1] - (128 / 255. + .25 * 1.024)) < 1e-12);
    assert_true(fabs(value[2] - .25 * 1.024) < 1e-12);
    shading.clamp_peak = true;
    reference_line(scene, &shading, GLINT_MSH, 0, value);
    assert_true(fabs(value[2] - .25) < 1e-12);
    scene_free(scene);
}

static void a_light_from_behind_leaves_the_ambient_part(void **state)
{
    (void)state;
    struct scene *scene = scene_new(1, 1);
    struct shading shading = plain;
    memcpy(shading.lamps[0].direction, (const double[3]){1, 0, -.01}, sizeof shading.lamps[0].direction);
    shading.n = 1;
    double value[3];
    reference_line(scene, &shading, GLINT_MSH, 0, value);
    assert_true(fabs(value[0] - .15) < 1e-12);
    scene_free(scene);
}

static void under_the_cutoff_there_is_no_highlight(void **state)
{
    (void)state;
    struct scene *scene = scene_new(1, 1);
    struct shading shading = plain;
    shading.diffuse[2] = shading.ambient[2] = 0;
    memcpy(shading.lamps[0].direction, (const double[3]){.6, 0, .8},
           sizeof shading.lamps[0].direction); /* N.H = sqrt(.9) */
    const double c = sqrt(.9), f = model_double(GLINT_BLINN, 60, c);
    assert_true(f > ldexp(1, -5) && f < ldexp(1, -4));
    double value[3];
    shading.q = 5;
    reference_line(scene, &shading, GLINT_BLINN, 0, value);
    assert_true(fabs(value[2] - .8 * f) < 1e-12);
    shading.q = 4;
    reference_line(scene, &shading, GLINT_BLINN, 0, value);
    assert_float_equal(value[2], 0, 0);
    scene_free(scene);
}

static void phong_takes_the_mirrored_light(void **state)
{
    (void)state;
    struct scene *scene = scene_new(1, 1);
    struct shading shading = plain;
    shading.n = 3;
    shading.diffuse[2] = shading.ambient[2] = 0;
    memcpy(shading.lamps[0].direction, (const double[3]){.6, 0, .8},
           sizeof shading.lamps[0].direction); /* R = (-.6, 0, .8), V.R = .8 */
    double value[3];
    reference_line(scene, &shading, GLINT_PHONG, 0, value);
    assert_true(fabs(value[2] - .8 * .8 * .8 * .8) < 1e-12);
    scene_free(scene);
}

static void in_linear_space_an_albedo_lit_fully_comes_back(void **state)
{
    (void)state;
    struct scene *scene = scene_new(256, 1);
    scene->albedo = allocate(256, 3);
    for (int i = 0; i < 256; i++)
        memset(&scene->albedo[3 * i], i, 3);
    struct shading shading = plain;
    shading.space = GLINT_LINEAR;
    for (unsigned k = 0; k < 3; k++) {
        shading.ambient[k] = 1;
        shading.diffuse[k] = shading.specular[k] = 0;
    }
    double values[3 * 256];
    reference_line(scene, &shading, GLINT_MSH, 0, values);
    struct levels *levels = shade_scene(scene, &shading);
    for (int i = 0; i < 256; i++) {
        assert_true(fabs(255 * values[3 * i] - i) < 1e-4);
        assert_int_equal(levels->values[3 * i], i);
    }
    levels_free(levels);
    scene_free(scene);
}

static void dither_thresholds_cover_a_step_evenly(void **state)
{
    (void)state;
    for (int i = 0; i < 64; i++) {
        const double value = (i + .5) / 64;
        unsigned sum = 0;
        for (uint32_t p = 0; p < 16; p++)
            sum += reference_level(value / 31, 31, true, p % 4, p / 4);
        assert_true(fabs(sum / 16. - value) <= 1 / 32.);
    }
    assert_int_equal(reference_level(1, 31, true, 0, 1), 31);
    assert_int_equal(reference_level(0, 31, true, 0, 3), 0);
    assert_int_equal(reference_level(.5, 255, false, 0, 0), 128);
}

/* ---- the library against it ---- */

/* The highlight steps where N.L passes 0 and where F passes the cutoff; in linear space, sRGB's slope at black makes up to
 * 10 levels of the latter. Near such an edge a last bit of a vector decides on which side a pixel lies. So each pixel is
 * compared with the reference at its normal and at four more that are moved by 2^-12, many last bits, to the left, the
 * right, up and down: one of them lies on the library's side. Elsewhere they differ by less than a level. */
enum { NUDGES = 5 };

static struct scene nudged(const struct scene *scene, int nudge)
{
    static const double moves[NUDGES][2] = {{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    struct scene moved = *scene;
    moved.normals = allocate(SIDE * SIDE, sizeof *moved.normals);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double *n = moved.normals[i];
        for (int k = 0; k < 3; k++)
            n[k] = scene->normals[i][k] + (k < 2 ? ldexp(moves[nudge][k], -12) : 0);
        const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int k = 0; k < 3; k++)
            n[k] /= length;
    }
    return moved;
}

/* The first sample that is more than a level from all references, or -1. */
static int first_sample_apart(const struct scene scenes[NUDGES], const struct shading *shading)
{
    struct levels *levels = shade_scene(&scenes[0], shading);
    const int line = SIDE * (int)levels->channels;
    int apart = -1;
    for (int y = 0; y < SIDE && apart < 0; y++) {
        static double values[NUDGES][3 * SIDE];
        for (int k = 0; k < NUDGES; k++)
            reference_line(&scenes[k], shading, shading->model, (uint32_t)y, values[k]);
        for (int i = 0; i < line && apart < 0; i++) {
            const int channel = i % (int)levels->channels, x = i / (int)levels->channels;
            int nearest = 255;
            for (int k = 0; k < NUDGES; k++) {
                const unsigned level =
                    reference_level(values[k][i], levels->max[channel], shading->dither, (uint32_t)x, (uint32_t)y);
                const int off = abs((int)level - levels->values[y * line + i]);
                nearest = off < nearest ? off : nearest;
            }
            if (nearest > 1)
                apart = y * line + i;
        }
    }
    levels_free(levels);
    return apart;
}

static void every_model_format_and_space_is_within_a_level_of_the_reference(void **state)
{
    (void)state;
    static const enum glint_format formats[] = {GLINT_RGB565, GLINT_RGB565_SWAPPED, GLINT_RGB888, GLINT_GREY8,
                                                GLINT_MONO};
    struct scene *scene = scene_draw("sphere", SIDE, SIDE), scenes[NUDGES];
    for (int k = 0; k < NUDGES; k++)
        scenes[k] = nudged(scene, k);
    for (int i = 0; i < GLINT_MODEL_COUNT * 5 * 4; i++) {
        struct shading shading = plain;
        shading.model = (enum glint_model)(i % GLINT_MODEL_COUNT);
        shading.format = formats[i / GLINT_MODEL_COUNT % 5];
        shading.space = i / GLINT_MODEL_COUNT / 5 % 2 ? GLINT_LINEAR : GLINT_GAMMA;
        shading.dither = i / GLINT_MODEL_COUNT / 10;
        const struct comparison c = comparison_of(scene, &shading);
        const int apart = first_sample_apart(scenes, &shading);
        assert_int_equal(c.rounded.samples, SIDE * SIDE * format_channels(shading.format));
        if (apart >= 0 || (double)c.rounded.differing > .02 * (double)c.rounded.samples)
            fail_msg("%s, format %d, space %d, dither %d: sample %d, %g %% differ", model_names[shading.model],
                     shading.format, shading.space, shading.dither, apart,
                     100. * (double)c.rounded.differing / (double)c.rounded.samples);
    }
    for (int k = 0; k < NUDGES; k++)
        free(scenes[k].normals);
    scene_free(scene);
}

/* Without a cutoff's edge, what is left beyond the rounding is the input's: Q1.15 vectors. */
static void without_a_cutoff_little_but_the_rounding_is_left(void **state)
{
    (void)state;
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    for (int model = 0; model < GLINT_MODEL_COUNT; model++) {
        for (unsigned n = 1; n <= 1000; n *= 10) {
            struct shading shading = plain;
            shading.model = (enum glint_model)model;
            shading.n = n;
            shading.q = 16;
            const struct comparison c = comparison_of(scene, &shading);
            if (c.unrounded.largest > .75 || c.rounding.largest > .5000001)
                fail_msg("%s, n %u: largest %g", model_names[model], n, c.unrounded.largest);
        }
    }
    scene_free(scene);
}

static void gloss_dims_the_highlight_alike(void **state)
{
    (void)state;
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    for (int i = 0; i < SIDE * SIDE; i++)
        scene->gloss[i] = (uint8_t)(i * 7);
    const struct comparison c = comparison_of(scene, &plain);
    assert_true(c.rounded.largest < 1.001);
    assert_true((double)c.rounded.differing < .02 * (double)c.rounded.samples);
    scene_free(scene);
}

static const struct lamp lamps[] = {
    {.kind = LAMP_POINT, .position = {30, 20, 40}, .range = 150, .color = {1.5, .7, .3}},
    {.kind = LAMP_SPOT,
     .position = {90, 90, 60},
     .target = {48, 40},
     .range = 200,
     .cone = {10, 25},
     .color = {1, 1, 1}},
    {.direction = {1, -1, .5}, .color = {.2, .3, .5}},
    {.kind = LAMP_SPOT,
     .position = {48, 48, 100},
     .target = {60, 60},
     .range = 150,
     .cone = {0, 40},
     .color = {0, 2, 0}}};

static void four_lights_of_every_kind_are_as_near(void **state)
{
    (void)state;
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    for (int i = 0; i < GLINT_MODEL_COUNT * 4; i++) {
        struct shading shading = plain;
        shading.model = (enum glint_model)(i % GLINT_MODEL_COUNT);
        shading.lamp_count = 1 + (unsigned)i / GLINT_MODEL_COUNT;
        for (unsigned k = 0; k < shading.lamp_count; k++)
            shading.lamps[k] = lamps[k];
        shading.q = 16;
        assert_false(shading_is_plain(&shading));
        const struct comparison c = comparison_of(scene, &shading);
        if (c.unrounded.largest > .6 || c.rounding.largest > .5000001)
            fail_msg("%s, %u lights: largest %g", model_names[shading.model], shading.lamp_count, c.unrounded.largest);
    }
    scene_free(scene);
}

static void white_light_divided_among_lamps_is_the_same_light(void **state)
{
    (void)state;
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    struct shading shading = plain;
    assert_true(shading_is_plain(&shading));
    double one[3 * SIDE], parts[3 * SIDE];
    reference_line(scene, &shading, GLINT_MSH, SIDE / 3, one);
    shading.lamp_count = 4;
    for (unsigned k = 0; k < 4; k++)
        shading.lamps[k] = (struct lamp){.direction = {-1, 1, 1}, .color = {.25, .25, .25}};
    reference_line(scene, &shading, GLINT_MSH, SIDE / 3, parts);
    for (int i = 0; i < 3 * SIDE; i++)
        assert_near(parts[i], one[i], 1e-12);
    scene_free(scene);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_mirror_facing_light_and_viewer_has_the_peak),
        cmocka_unit_test(a_light_from_behind_leaves_the_ambient_part),
        cmocka_unit_test(under_the_cutoff_there_is_no_highlight),
        cmocka_unit_test(phong_takes_the_mirrored_light),
        cmocka_unit_test(in_linear_space_an_albedo_lit_fully_comes_back),
        cmocka_unit_test(dither_thresholds_cover_a_step_evenly),
        cmocka_unit_test(every_model_format_and_space_is_within_a_level_of_the_reference),
        cmocka_unit_test(without_a_cutoff_little_but_the_rounding_is_left),
        cmocka_unit_test(four_lights_of_every_kind_are_as_near),
        cmocka_unit_test(white_light_divided_among_lamps_is_the_same_light),
        cmocka_unit_test(gloss_dims_the_highlight_alike),
    };
    return cmocka_run_group_tests_name("reference", tests, NULL, NULL);
}
