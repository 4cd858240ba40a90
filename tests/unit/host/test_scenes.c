/* SPDX-License-Identifier: MIT
 * Normals from height and normal maps, and the built-in scenes. */
#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "image/image.h"
#include "image/read.h"
#include "files.h"

#include "scene/normals.h"
#include "scene/scene.h"
#include "scene/scenes.h"

static struct image *made(uint32_t width, uint32_t height, int bits, int color_type, const uint16_t *samples)
{
    make_png("made.png",
             &(struct made_png){
                 .width = width, .height = height, .bits = bits, .color_type = color_type, .samples = samples});
    return image_read("made.png");
}

static void assert_normal(const double got[3], double x, double y, double z)
{
    const double length = sqrt(x * x + y * y + z * z);
    const double wanted[3] = {x / length, y / length, z / length};
    for (int k = 0; k < 3; k++)
        if (!(fabs(got[k] - wanted[k]) < 1e-9))
            fail_msg("normal %g,%g,%g, expected %g,%g,%g", got[0], got[1], got[2], wanted[0], wanted[1], wanted[2]);
}

/* ---- height maps ---- */

enum { WIDTH = 7, HEIGHT = 5 };

static struct scene *plane(int per_column, int per_line, double scale, bool wraps)
{
    uint16_t samples[WIDTH * HEIGHT];
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        samples[i] = (uint16_t)(20000 + per_column * (i % WIDTH) + per_line * (i / WIDTH));
    struct image *map = made(WIDTH, HEIGHT, 16, PNG_COLOR_TYPE_GRAY, samples);
    struct scene *scene = scene_from_heights(map, scale, wraps);
    image_free(map);
    return scene;
}

static void a_plane_has_one_normal_up_to_its_edges(void **state)
{
    (void)state;
    /* 1311 = 0.02 of 65535: at a scale of 50 pixels a slope of 1 to the right; lines go down, so down a fall of 2. */
    struct scene *scene = plane(1311, -2622, 50, false);
    const double slope = 50 * 1311 / 65535.;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        assert_normal(scene->normals[i], -slope, -2 * slope, 1);
    scene_free(scene);
}

static void a_finer_step_than_eight_bits_is_seen(void **state)
{
    (void)state;
    struct scene *scene = plane(1, 0, 1000, false);
    assert_normal(scene->normals[WIDTH + 3], -1000 / 65535., 0, 1);
    scene_free(scene);
}

static void a_negative_scale_turns_hills_into_hollows(void **state)
{
    (void)state;
    struct scene *scene = plane(1311, 0, -50, false);
    assert_normal(scene->normals[0], 50 * 1311 / 65535., 0, 1);
    scene_free(scene);
}

static void a_wrapped_map_goes_on_at_the_other_edge(void **state)
{
    (void)state;
    struct scene *scene = plane(1311, 0, 50, true);
    const double slope = 50 * 1311 / 65535.;
    assert_normal(scene->normals[3], -slope, 0, 1);
    assert_normal(scene->normals[0], (WIDTH - 2) / 2. * slope, 0, 1);
    assert_normal(scene->normals[WIDTH - 1], (WIDTH - 2) / 2. * slope, 0, 1);
    scene_free(scene);
}

static void a_map_one_pixel_wide_is_flat_across(void **state)
{
    (void)state;
    const uint16_t samples[] = {0, 100, 200};
    struct image *map = made(1, 3, 8, PNG_COLOR_TYPE_GRAY, samples);
    for (int wraps = 0; wraps < 2; wraps++) {
        struct scene *scene = scene_from_heights(map, 2.55, wraps);
        assert_normal(scene->normals[1], 0, 1, 1);
        scene_free(scene);
    }
    image_free(map);
}

/* ---- normal maps ---- */

static void eight_bit_components_run_from_minus_one_to_one(void **state)
{
    (void)state;
    const uint16_t samples[] = {255, 128, 200, 0, 50, 255, 128, 128, 255};
    struct image *map = made(3, 1, 8, PNG_COLOR_TYPE_RGB, samples);
    struct scene *scene = scene_from_normals(map, false, NULL);
    for (int i = 0; i < 3; i++) {
        const uint16_t *s = &samples[3 * i];
        assert_normal(scene->normals[i], 2 * s[0] / 255. - 1, 2 * s[1] / 255. - 1, 2 * s[2] / 255. - 1);
    }
    scene_free(scene);
    image_free(map);
}

static void sixteen_bits_count_to_the_last(void **state)
{
    (void)state;
    const uint16_t samples[] = {40001, 30000, 60000, 40002, 30000, 60000};
    struct image *map = made(2, 1, 16, PNG_COLOR_TYPE_RGB, samples);
    struct scene *scene = scene_from_normals(map, false, NULL);
    for (int i = 0; i < 2; i++)
        assert_normal(scene->normals[i], 2 * samples[3 * i] / 65535. - 1, 2 * 30000 / 65535. - 1,
                      2 * 60000 / 65535. - 1);
    assert_true(scene->normals[0][0] != scene->normals[1][0]);
    scene_free(scene);
    image_free(map);
}

static void flip_y_turns_green_over(void **state)
{
    (void)state;
    const uint16_t samples[] = {200, 210, 220};
    struct image *map = made(1, 1, 8, PNG_COLOR_TYPE_RGB, samples);
    struct scene *up = scene_from_normals(map, false, NULL), *down = scene_from_normals(map, true, NULL);
    assert_true(up->normals[0][1] > .1);
    assert_normal(down->normals[0], up->normals[0][0], -up->normals[0][1], up->normals[0][2]);
    scene_free(up);
    scene_free(down);
    image_free(map);
}

static void assert_xy(int color_type, const uint16_t *samples)
{
    struct image *map = made(2, 1, 8, color_type, samples);
    struct scene *scene = scene_from_normals(map, false, NULL);
    const double x = 2 * 178 / 255. - 1, y = 2 * 77 / 255. - 1;
    assert_normal(scene->normals[0], x, y, sqrt(1 - x * x - y * y));
    assert_normal(scene->normals[1], 1, 1, 0); /* longer than 1 by itself: z is 0 */
    scene_free(scene);
    image_free(map);
}

static void z_is_reconstructed_from_two_channels_or_where_blue_is_black(void **state)
{
    (void)state;
    assert_xy(PNG_COLOR_TYPE_GRAY_ALPHA, (const uint16_t[]){178, 77, 255, 255});
    assert_xy(PNG_COLOR_TYPE_RGB, (const uint16_t[]){178, 77, 0, 255, 255, 0});
    assert_xy(PNG_COLOR_TYPE_RGB_ALPHA, (const uint16_t[]){178, 77, 0, 9, 255, 255, 0, 9});
}

static void assert_map_refused(int bits, int color_type, const uint16_t *samples, const char *why)
{
    const png_color palette[2] = {{128, 128, 255}, {0, 0, 0}};
    make_png("map.png", &(struct made_png){.width = 2,
                                           .height = 1,
                                           .bits = bits,
                                           .color_type = color_type,
                                           .samples = samples,
                                           .palette = color_type == PNG_COLOR_TYPE_PALETTE ? palette : NULL,
                                           .palette_count = 2});
    assert_fails("$GLINT render --normals map.png -o out.png", "map.png");
    assert_fails("$GLINT render --normals map.png -o out.png", why);
    assert_false(exists("out.png"));
}

static void what_cannot_be_a_normal_map_is_refused_with_the_reason(void **state)
{
    (void)state;
    const uint16_t ones[] = {1, 1, 1, 1, 1, 1};
    assert_map_refused(8, PNG_COLOR_TYPE_PALETTE, (const uint16_t[]){0, 1}, "palette");
    assert_map_refused(1, PNG_COLOR_TYPE_GRAY, ones, "1 bit a sample");
    assert_map_refused(4, PNG_COLOR_TYPE_GRAY, ones, "4 bits a sample");
    assert_map_refused(8, PNG_COLOR_TYPE_GRAY, ones, "one channel");
    assert_map_refused(8, PNG_COLOR_TYPE_RGB, ones, "grey throughout");
}

static void a_vector_of_length_0_is_named_by_its_place(void **state)
{
    (void)state;
    assert_map_refused(8, PNG_COLOR_TYPE_RGB, (const uint16_t[]){128, 128, 255, 128, 127, 128}, "1,0");
    assert_map_refused(16, PNG_COLOR_TYPE_RGB, (const uint16_t[]){32768, 32767, 32768, 128, 127, 50000}, "0,0");
}

static void what_the_mask_leaves_out_may_have_length_0(void **state)
{
    (void)state;
    const uint16_t map[] = {128, 128, 255, 128, 127, 128}, mask[] = {255, 0}, wrong[] = {0, 255};
    make_png("map.png",
             &(struct made_png){.width = 2, .height = 1, .bits = 8, .color_type = PNG_COLOR_TYPE_RGB, .samples = map});
    make_png("mask.png", &(struct made_png){.width = 2, .height = 1, .bits = 8, .samples = mask});
    make_png("wrong.png", &(struct made_png){.width = 2, .height = 1, .bits = 8, .samples = wrong});
    assert_quiet("$GLINT render --normals map.png --mask mask.png -o drawn.png");
    assert_fails("$GLINT render --normals map.png --mask wrong.png -o out.png", "length 0");
}

/* ---- as the library takes them ---- */

static void normals_are_rounded_to_the_nearest_q15(void **state)
{
    (void)state;
    struct scene *scene = scene_new(3, 1);
    memcpy(scene->normals[1], (const double[3]){-1, 0, 0}, sizeof(double[3]));
    memcpy(scene->normals[2], (const double[3]){.6, -.8, 1.49 / 32768}, sizeof(double[3]));
    struct glint_vec *q15 = scene_normals_q15(scene);
    assert_int_equal(q15[0].z, 32767);
    assert_int_equal(q15[0].x, 0);
    assert_int_equal(q15[1].x, -32768);
    assert_int_equal(q15[2].x, 19661); /* 19660.8 */
    assert_int_equal(q15[2].y, -26214);
    assert_int_equal(q15[2].z, 1);
    free(q15);
    scene_free(scene);
}

static void a_map_is_cut_or_repeated_from_its_corner(void **state)
{
    (void)state;
    struct scene *scene = plane(1311, 700, 50, true);
    scene->gloss = allocate(WIDTH * HEIGHT, 1);
    scene->albedo = allocate(WIDTH * HEIGHT, 3);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        scene->gloss[i] = (uint8_t)i;
        scene->albedo[3 * i + 2] = (uint8_t)(i + 100);
    }
    double before[WIDTH * HEIGHT][3];
    memcpy(before, scene->normals, sizeof before);
    static const struct {
        uint32_t width, height, lines; /* of the first map that are left then */
    } sizes[] = {{2 * WIDTH + 1, HEIGHT - 2, HEIGHT}, {WIDTH, 2 * HEIGHT + 1, HEIGHT - 2}};
    for (unsigned k = 0; k < 2; k++) {
        const uint32_t width = sizes[k].width, height = sizes[k].height;
        scene_repeat(scene, width, height);
        assert_int_equal(scene->width, width);
        assert_int_equal(scene->height, height);
        assert_null(scene->mask);
        for (uint32_t i = 0; i < width * height; i++) {
            const uint32_t from = i / width % sizes[k].lines * WIDTH + i % width % WIDTH;
            assert_memory_equal(scene->normals[i], before[from], sizeof before[0]);
            assert_int_equal(scene->gloss[i], from);
            assert_int_equal(scene->albedo[3 * i + 2], from + 100);
        }
    }
    scene_free(scene);
}

/* ---- built-in scenes ---- */

static void every_scene_can_be_drawn_at_any_size(void **state)
{
    (void)state;
    const uint32_t sizes[][2] = {{1, 1}, {2, 3}, {1, 40}, {97, 40}, {64, 64}};
    for (int i = 0; scene_names[i]; i++) {
        for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
            struct scene *scene = scene_draw(scene_names[i], sizes[s][0], sizes[s][1]);
            assert_non_null(scene);
            for (uint32_t p = 0; p < sizes[s][0] * sizes[s][1]; p++) {
                const double *n = scene->normals[p];
                assert_true(fabs(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1) < 1e-9);
                assert_true(n[2] > 0);
            }
            scene_free(scene);
        }
    }
    assert_refused("$GLINT render --scene teacup -o out.png", "sphere, watchface, coin");
}

static void the_sphere_has_the_normals_of_a_sphere(void **state)
{
    (void)state;
    enum { SIDE = 200 };
    struct scene *scene = scene_draw("sphere", SIDE, SIDE);
    const double radius = .8 * SIDE / 2;
    for (int x = 30; x < 170; x += 7) {
        const double dx = (x + .5 - SIDE / 2.) / radius, dy = (SIDE / 2. - 60.5) / radius;
        if (dx * dx + dy * dy < .9)
            assert_normal(scene->normals[60 * SIDE + x], dx, dy, sqrt(1 - dx * dx - dy * dy));
    }
    assert_normal(scene->normals[0], 0, 0, 1); /* the wall */
    assert_int_equal(scene->gloss[0], 0);
    assert_int_equal(scene->gloss[100 * SIDE + 100], 255);
    scene_free(scene);
}

/* Reliefs: what rises from the left faces left. */
static void the_rims_of_watch_and_coin_face_outwards(void **state)
{
    (void)state;
    enum { SIDE = 200 };
    for (int i = 1; scene_names[i]; i++) {
        struct scene *scene = scene_draw(scene_names[i], SIDE, SIDE);
        double left = 0, right = 0, top = 0;
        for (int k = 2; k < 9; k++) {
            left = fmin(left, scene->normals[SIDE / 2 * SIDE + k][0]);
            right = fmax(right, scene->normals[SIDE / 2 * SIDE + SIDE - 1 - k][0]);
            top = fmax(top, scene->normals[k * SIDE + SIDE / 2][1]);
        }
        assert_true(left < -.3 && right > .3 && top > .3);
        scene_free(scene);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_plane_has_one_normal_up_to_its_edges),
        cmocka_unit_test(a_finer_step_than_eight_bits_is_seen),
        cmocka_unit_test(a_negative_scale_turns_hills_into_hollows),
        cmocka_unit_test(a_wrapped_map_goes_on_at_the_other_edge),
        cmocka_unit_test(a_map_one_pixel_wide_is_flat_across),
        cmocka_unit_test(eight_bit_components_run_from_minus_one_to_one),
        cmocka_unit_test(sixteen_bits_count_to_the_last),
        cmocka_unit_test(flip_y_turns_green_over),
        cmocka_unit_test(z_is_reconstructed_from_two_channels_or_where_blue_is_black),
        cmocka_unit_test(what_cannot_be_a_normal_map_is_refused_with_the_reason),
        cmocka_unit_test(a_vector_of_length_0_is_named_by_its_place),
        cmocka_unit_test(what_the_mask_leaves_out_may_have_length_0),
        cmocka_unit_test(normals_are_rounded_to_the_nearest_q15),
        cmocka_unit_test(a_map_is_cut_or_repeated_from_its_corner),
        cmocka_unit_test(every_scene_can_be_drawn_at_any_size),
        cmocka_unit_test(the_sphere_has_the_normals_of_a_sphere),
        cmocka_unit_test(the_rims_of_watch_and_coin_face_outwards),
    };
    return cmocka_run_group_tests_name("scenes", tests, scratch_make, scratch_remove);
}
