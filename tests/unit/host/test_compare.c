/* SPDX-License-Identifier: MIT
 * What compares pictures: differences, their places, the error map. */
#include <math.h>
#include <string.h>

#include "unit.h"

#include "base/memory.h"
#include "compare/compare.h"
#include "compare/difference.h"
#include "draw/canvas.h"
#include "image/levels.h"
#include "image/picture.h"
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

static void a_wrong_sample_is_found_with_its_place(void **state)
{
    (void)state;
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    struct levels *levels = shade_scene(scene, &plain);
    struct comparison before, after;
    compare(scene, &plain, levels, &before);
    uint8_t *sample = &levels->values[3 * (40 * SIDE + 17) + 1];
    *sample = (uint8_t)(*sample + 20);
    compare(scene, &plain, levels, &after);
    assert_int_equal(after.rounded.x, 17);
    assert_int_equal(after.rounded.y, 40);
    assert_int_equal(after.rounded.channel, 1);
    assert_true(fabs(after.rounded.largest - 20) <= 1.001);
    assert_true(difference_psnr_db(&after.rounded) < difference_psnr_db(&before.rounded));
    assert_true(difference_mean(&after.rounded) > difference_mean(&before.rounded));
    levels_free(levels);
    scene_free(scene);
}

static void equal_pictures_have_infinite_psnr_and_known_errors_their_formula(void **state)
{
    (void)state;
    struct difference d = {.samples = 4};
    assert_true(isinf(difference_psnr_db(&d)));
    d = (struct difference){.samples = 4, .differing = 1, .sum = 2, .sum_of_squares = 4, .largest = 2};
    assert_true(fabs(difference_psnr_db(&d) - 20 * log10(255)) < 1e-9); /* mean square 1 */
    assert_true(fabs(difference_mean(&d) - .5) < 1e-12);
}

static void joined_differences_keep_the_place_and_the_channel_of_the_largest(void **state)
{
    (void)state;
    struct difference small = {0}, large = {0}, joined = {0};
    difference_add(&small, .5, .25, 1, 2, 1);
    difference_add(&large, .5, 0, 3, 4, 2);
    difference_merge(&joined, &small);
    difference_merge(&joined, &large);
    difference_merge(&joined, &small);
    assert_string_equal(difference_channel(&joined, 3), "blue");
    assert_int_equal(joined.x, 3);
    assert_int_equal(joined.y, 4);
    assert_int_equal(joined.samples, 3);
}

static void what_is_masked_is_black_and_not_compared(void **state)
{
    (void)state;
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    scene->mask = allocate(SIDE, SIDE);
    memset(scene->mask + SIDE * 10, 1, SIDE * 5);
    struct levels *levels = shade_scene(scene, &plain);
    struct comparison c;
    compare(scene, &plain, levels, &c);
    assert_int_equal(c.rounded.samples, 3 * SIDE * 5);
    assert_true(c.rounded.largest < 1.001);
    assert_int_equal(levels->values[3 * (SIDE * 9 + SIDE / 2)], 0);
    assert_true(levels->values[3 * (SIDE * 12 + SIDE / 2)] > 0);
    levels_free(levels);
    scene_free(scene);
}

static void the_error_map_shows_the_amplified_error(void **state)
{
    (void)state;
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    struct levels *levels = shade_scene(scene, &plain);
    struct comparison c;
    compare(scene, &plain, levels, &c);
    const unsigned times = error_map_amplification(&c.blinn_unrounded);
    assert_true(c.blinn_unrounded.largest * times <= 255 && c.blinn_unrounded.largest * times * 2 > 255);
    struct picture *map = error_map(scene, &plain, levels, GLINT_BLINN, times);
    unsigned brightest = 0;
    for (int i = 0; i < 3 * SIDE * SIDE; i++)
        brightest = map->samples[i] > brightest ? map->samples[i] : brightest;
    assert_int_equal(brightest, lround(c.blinn_unrounded.largest * times));
    const struct difference *d = &c.blinn_unrounded;
    assert_int_equal(map->samples[3 * (d->y * SIDE + d->x) + d->channel], brightest);
    picture_free(map);
    levels_free(levels);
    scene_free(scene);
}

static void levels_are_shown_as_the_nearest_of_255(void **state)
{
    (void)state;
    uint8_t values[3 * 64];
    for (int i = 0; i < 64; i++) {
        values[3 * i] = values[3 * i + 2] = (uint8_t)(i / 2);
        values[3 * i + 1] = (uint8_t)i;
    }
    const struct levels levels = {64, 1, 3, {31, 63, 31}, values};
    struct picture *picture = levels_picture(&levels, WIDEN_NEAREST);
    for (int i = 0; i < 64; i++) {
        assert_int_equal(picture->samples[3 * i], lround(i / 2 * 255 / 31.));
        assert_int_equal(picture->samples[3 * i + 1], lround(i * 255 / 63.));
    }
    assert_false(picture->mono);
    picture_free(picture);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_wrong_sample_is_found_with_its_place),
        cmocka_unit_test(equal_pictures_have_infinite_psnr_and_known_errors_their_formula),
        cmocka_unit_test(joined_differences_keep_the_place_and_the_channel_of_the_largest),
        cmocka_unit_test(what_is_masked_is_black_and_not_compared),
        cmocka_unit_test(the_error_map_shows_the_amplified_error),
        cmocka_unit_test(levels_are_shown_as_the_nearest_of_255),
    };
    return cmocka_run_group_tests_name("compare", tests, NULL, NULL);
}
