/* SPDX-License-Identifier: MIT
 * glint_paint_steps: the same pixels as without it, and what it refuses. */
#include "shading.h"

enum { PART = 4096 };
static uint16_t steps[GLINT_STEPS_BYTES / 2 + 1];

static struct look undithered(enum glint_format format, enum glint_space space)
{
    struct look look = random_look(format, space);
    set_model(&look, GLINT_MSH, 60, 8);
    look.output.dither = false;
    return look;
}

/* N.L = first.. in Q16, far from the highlight, or a t that falls to 0 and rises. */
static void draw_part(const struct glint_paint *paint, uint32_t first, uint16_t w, bool shines, uint16_t out[PART])
{
    const struct glint_surface surface = {out, 2 * PART, 0, 0};
    const struct glint_span span = {shines ? 1u << 24 : 1u << 31,
                                    shines ? 0u - 16378 : 0,
                                    shines ? 8 : 0,
                                    (int32_t)(first << 14),
                                    1 << 14,
                                    w,
                                    {{0, 0}, {0, 0}}};
    memset(out, GUARD, 2 * PART);
    assert_int_equal(glint_draw_span(paint, &span, NULL, &surface, NULL), GLINT_OK);
}

static void every_pixel_of_a_paint_with_steps_is_that_without(void **state)
{
    (void)state;
    static uint16_t found[PART], wanted[PART];
    for (int i = 0; i < 24; i++) {
        struct look look = undithered(i % 2 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, i % 5 ? GLINT_GAMMA : GLINT_LINEAR);
        struct glint_paint paint, plain;
        set_model(&look, (uint8_t)(i % GLINT_MODEL_COUNT), 60, 8);
        for (int k = 0; k < 3; k++) {
            look.light.color_q16[k] = i % 3 ? 65536 : below(200000);
            look.material.ambient_q16[k] =
                i % 4 ? look.material.ambient_q16[k] : 0; /* black is 0, which marks a step */
        }
        paint_of(&plain, &look);
        paint = plain;
        assert_int_equal(glint_paint_steps(&paint, steps, GLINT_STEPS_BYTES), GLINT_OK);
        memset(steps, GUARD, sizeof steps);
        assert_int_equal(glint_paint_steps(&paint, steps, GLINT_STEPS_BYTES), GLINT_OK);
        for (uint32_t first = 0; first <= 65536; first += PART)
            for (int shines = 0; shines < 2; shines++) {
                draw_part(&paint, first, first < 65536 ? PART : 1, shines, found);
                draw_part(&plain, first, first < 65536 ? PART : 1, shines, wanted);
                assert_memory_equal(found, wanted, sizeof found);
            }
    }
}

/* N.L just below a step's end is rounded to the next one's first value: assembly looks it up before. */
static void a_step_is_one_pixel_up_to_the_first_value_of_the_next(void **state)
{
    (void)state;
    static uint16_t wanted[65536 + PART];
    for (int i = 0; i < 100; i++) {
        const struct look look = undithered(i % 2 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, GLINT_GAMMA);
        struct glint_paint paint;
        paint_of(&paint, &look);
        for (uint32_t first = 0; first <= 65536; first += PART)
            draw_part(&paint, first, first < 65536 ? PART : 1, false, wanted + first);
        assert_int_equal(glint_paint_steps(&paint, steps, sizeof steps), GLINT_OK);
        for (uint32_t nl = 0; nl <= 65536; nl++) {
            const uint8_t *bytes = (const uint8_t *)&wanted[nl];
            const uint16_t pixel = (uint16_t)(bytes[0] | bytes[1] << 8), step = steps[nl / 64];
            if (step)
                assert_int_equal(step, pixel);
            if (nl && nl % 64 == 0 && steps[nl / 64 - 1])
                assert_int_equal(steps[nl / 64 - 1], pixel);
        }
    }
}

static void lights_of_another_colour_and_several_draw_as_without_steps(void **state)
{
    (void)state;
    static uint16_t found[PART], wanted[PART];
    static const struct glint_vec normals[3] = {{0, 0, 32767}, {20000, 0, 25953}, {0, -20000, 25953}};
    static const struct glint_maps maps = {.normals = normals, .normals_stride = sizeof normals};
    for (int i = 0; i < 8; i++) {
        struct look look = undithered(GLINT_RGB565, i & 4 ? GLINT_LINEAR : GLINT_GAMMA);
        struct glint_paint paint, plain;
        paint_of(&plain, &look);
        paint = plain;
        assert_int_equal(glint_paint_steps(&paint, steps, sizeof steps), GLINT_OK);
        struct glint_light lights[2] = {look.light, look.light};
        struct glint_surface surface = {found, sizeof found, 0, 0};
        for (int k = 0; k < 3; k++)
            lights[0].color_q16[k] = i % 2 ? 65536 : 40000;
        assert_int_equal(glint_paint_light(&paint, lights, i & 2 ? 2 : 1, in_front), GLINT_OK);
        assert_int_equal(glint_paint_light(&plain, lights, i & 2 ? 2 : 1, in_front), GLINT_OK);
        assert_int_equal(glint_draw_rect(&paint, &maps, 3, 1, &surface, NULL), GLINT_OK);
        surface.pixels = wanted;
        assert_int_equal(glint_draw_rect(&plain, &maps, 3, 1, &surface, NULL), GLINT_OK);
        assert_memory_equal(found, wanted, 6);
    }
}

static void what_maps_change_is_drawn_as_without_steps(void **state)
{
    (void)state;
    enum { WIDTH = 64 };
    static uint16_t found[WIDTH], wanted[WIDTH];
    struct glint_vec normals[WIDTH];
    uint8_t coverage[WIDTH], albedo[3 * WIDTH], gloss[WIDTH];
    for (int i = 0; i < 400; i++) {
        struct look look = undithered(i % 2 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, i % 5 ? GLINT_GAMMA : GLINT_LINEAR);
        struct glint_maps maps = {.normals = normals, .normals_stride = sizeof normals};
        struct glint_paint paint, plain;
        if (i & 4) {
            maps.coverage = coverage;
            maps.coverage_stride = sizeof coverage;
        }
        if (i & 8) {
            maps.albedo = albedo;
            maps.albedo_stride = sizeof albedo;
            maps.albedo_format = GLINT_RGB888;
        }
        if (i & 16) {
            maps.gloss = gloss;
            maps.gloss_stride = sizeof gloss;
        }
        for (int x = 0; x < WIDTH; x++) {
            normals[x] = random_normal(&look);
            coverage[x] = (uint8_t)(x % 4 ? below(256) : 255);
            gloss[x] = (uint8_t)below(256);
            for (int k = 0; k < 3; k++)
                albedo[3 * x + k] = (uint8_t)below(256);
            found[x] = wanted[x] = (uint16_t)below(65536);
        }
        paint_of(&plain, &look);
        paint = plain;
        assert_int_equal(glint_paint_steps(&paint, steps, sizeof steps), GLINT_OK);
        struct glint_surface surface = {found, sizeof found, 0, 0};
        assert_int_equal(glint_draw_rect(&paint, &maps, WIDTH, 1, &surface, NULL), GLINT_OK);
        surface.pixels = wanted;
        assert_int_equal(glint_draw_rect(&plain, &maps, WIDTH, 1, &surface, NULL), GLINT_OK);
        assert_memory_equal(found, wanted, sizeof found);
    }
}

static void steps_are_the_same_whatever_their_memory_held(void **state)
{
    (void)state;
    static uint16_t first[GLINT_STEPS_BYTES / 2], second[GLINT_STEPS_BYTES / 2];
    const struct glint_output output = {GLINT_RGB565, GLINT_GAMMA, false};
    struct glint_material material = {.model = GLINT_MSH,
                                      .n = 80,
                                      .ambient_q16 = {6000, 6000, 6000},
                                      .diffuse_q16 = {50000, 50000, 50000},
                                      .albedo = {200, 180, 160}};
    struct glint_paint paint, other;
    assert_int_equal(glint_paint_exact(&paint, &material, &output), GLINT_OK);
    for (int i = 0; i < 3; i++)
        material.ambient_q16[i] -= 98; /* all a step later */
    assert_int_equal(glint_paint_exact(&other, &material, &output), GLINT_OK);
    assert_int_equal(glint_paint_steps(&paint, first, sizeof first), GLINT_OK);
    assert_int_equal(glint_paint_steps(&other, second, sizeof second), GLINT_OK);
    assert_int_equal(glint_paint_steps(&paint, second, sizeof second), GLINT_OK); /* a second time */
    assert_memory_equal(first, second, sizeof first);
}

static void steps_of_what_has_none_are_refused(void **state)
{
    (void)state;
    struct look look = undithered(GLINT_RGB565, GLINT_GAMMA);
    struct glint_paint paint, zeros;
    const struct glint_light two[2] = {look.light, look.light};
    memset(&zeros, 0, sizeof zeros);
    paint_of(&paint, &look);
    memset(steps, GUARD, sizeof steps);
    assert_int_equal(glint_paint_steps(NULL, steps, sizeof steps), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_steps(&zeros, steps, sizeof steps), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_steps(&paint, NULL, sizeof steps), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_steps_for(&paint, NULL, steps, sizeof steps), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_steps(&paint, (uint8_t *)steps + 1, GLINT_STEPS_BYTES), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_steps(&paint, steps, GLINT_STEPS_BYTES - 1), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_light(&paint, two, 2, in_front), GLINT_OK);
    assert_int_equal(glint_paint_steps(&paint, steps, sizeof steps), GLINT_ERR_ARG);
    for (int i = 0; i < 4; i++) {
        look = undithered(i % 2 ? GLINT_RGB888 : GLINT_RGB565, i < 2 ? GLINT_LINEAR : GLINT_GAMMA);
        look.output.dither = i == 2;
        paint_of(&paint, &look);
        assert_int_equal(glint_paint_steps_for(&paint, &glint_use_rgb565_steps, steps, sizeof steps), GLINT_ERR_FORMAT);
        if (i)
            assert_int_equal(glint_paint_steps(&paint, steps, sizeof steps), GLINT_ERR_FORMAT);
    }
    for (size_t i = 0; i < sizeof steps; i++)
        assert_int_equal(((uint8_t *)steps)[i], GUARD);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_pixel_of_a_paint_with_steps_is_that_without),
        cmocka_unit_test(a_step_is_one_pixel_up_to_the_first_value_of_the_next),
        cmocka_unit_test(lights_of_another_colour_and_several_draw_as_without_steps),
        cmocka_unit_test(what_maps_change_is_drawn_as_without_steps),
        cmocka_unit_test(steps_are_the_same_whatever_their_memory_held),
        cmocka_unit_test(steps_of_what_has_none_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
