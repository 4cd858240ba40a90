/* SPDX-License-Identifier: MIT
 * ALBEDO tables: how far from the exact paint. */
#include "base/memory.h"
#include "image/image.h"
#include "image/read.h"
#include "albedo.h"

#define scene host_scene /* shading.h has one of its own */
#include "scene/normals.h"
#include "scene/scene.h"
#undef scene

static const char *const normals_names[] = {"int16", "int8"};

static int channel(uint16_t pixel, int k)
{
    return k == 0 ? pixel >> 11 : k == 1 ? pixel >> 5 & 63 : pixel & 31;
}

static void expand(uint8_t rgb[3], uint16_t pixel)
{
    for (int k = 0; k < 3; k++)
        rgb[k] = (uint8_t)lround(channel(pixel, k) * 255. / (k == 1 ? 63 : 31));
}

/* ---- How far from the exact path ---- */

struct map {
    int w, h;
    struct glint_vec *normals; /* as the loops read them */
    void *held;
    uint16_t *albedo;
};

/* Of the rock wall, in a format. */
static struct map rock_wall(enum glint_normals format)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/tests/data/rockwall-height.png", getenv("GLINT_SOURCE"));
    struct image *heights = image_read(path);
    struct host_scene *scene = scene_from_heights(heights, 8, true);
    snprintf(path, sizeof path, "%s/tests/data/rockwall-albedo.png", getenv("GLINT_SOURCE"));
    struct image *image = image_read(path);
    uint8_t *rgb = image_rgb8(image);
    const int pixels = (int)(scene->width * scene->height);
    struct map map = {(int)scene->width, (int)scene->height, scene_normals_q15(scene), NULL,
                      allocate((size_t)pixels, 2)};
    uint32_t *words = allocate((size_t)pixels, 4);
    for (int p = 0; p < pixels; p++) {
        map.albedo[p] = (uint16_t)((rgb[3 * p] >> 3) << 11 | (rgb[3 * p + 1] >> 2) << 5 | rgb[3 * p + 2] >> 3);
        if (format != GLINT_NORMALS_INT16) {
            words[p] = glint_normals_pack(format, &map.normals[p]);
            map.normals[p] = glint_normals_unpack(format, words[p]);
        }
    }
    map.held = words;
    image_free(heights);
    image_free(image);
    scene_free(scene);
    free(rgb);
    return map;
}

static struct map random_map(enum glint_normals format, const struct look *look)
{
    enum { SIDE = 200 };
    struct map map = {SIDE, SIDE, allocate(SIDE * SIDE, sizeof *map.normals), NULL, allocate(SIDE * SIDE, 2)};
    uint32_t *words = allocate(SIDE * SIDE, 4);
    for (int p = 0; p < SIDE * SIDE; p++) {
        do
            map.normals[p] = random_normal(look);
        while (labs((long)dot(map.normals[p], map.normals[p]) - 1073741824) > 200000 || map.normals[p].z < 500);
        map.albedo[p] = (uint16_t)below(65536);
        if (format != GLINT_NORMALS_INT16) {
            words[p] = glint_normals_pack(format, &map.normals[p]);
            map.normals[p] = glint_normals_unpack(format, words[p]);
        }
    }
    map.held = words;
    return map;
}

static void map_free(struct map *map)
{
    free(map->normals);
    free(map->held);
    free(map->albedo);
}

/* Largest and mean difference in steps of the format from the exact paint, for the normals as they are stored. */
static void differences(const struct map *map, enum glint_normals format, const struct look *look, int largest[3],
                        double mean[3])
{
    const int pixels = map->w * map->h;
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, look, memory);
    uint16_t *exact = allocate((size_t)pixels, 2), *fast = allocate((size_t)pixels, 2);
    uint8_t *rgb = allocate((size_t)pixels, 3);
    for (int p = 0; p < pixels; p++)
        expand(rgb + 3 * p, map->albedo[p]);
    const ptrdiff_t line = 2 * map->w;
    const uint16_t w = (uint16_t)map->w, h = (uint16_t)map->h;
    const struct glint_maps vectors = {.normals = map->normals,
                                       .normals_stride = map->w * (ptrdiff_t)sizeof *map->normals,
                                       .albedo = rgb,
                                       .albedo_stride = 3 * map->w,
                                       .albedo_format = GLINT_RGB888};
    const struct glint_maps maps =
        maps_over(format, format == GLINT_NORMALS_INT8 ? map->held : map->normals, map->albedo, w);
    const struct glint_surface to_exact = {exact, line, 0, 0}, to_fast = {fast, line, 0, 0};
    assert_int_equal(draw_rect(look, &vectors, w, h, &to_exact, NULL), GLINT_OK);
    assert_int_equal(glint_draw_rect(&paint, &maps, w, h, &to_fast, NULL), GLINT_OK);
    for (int k = 0; k < 3; k++) {
        long sum = 0;
        largest[k] = 0;
        for (int p = 0; p < pixels; p++) {
            if (labs((long)dot(map->normals[p], look->l)) < 1 << 20)
                continue; /* the highlight's sudden end, where N.L = 0: a last bit decides */
            const int difference = abs(channel(exact[p], k) - channel(fast[p], k));
            largest[k] = difference > largest[k] ? difference : largest[k];
            sum += difference;
        }
        mean[k] = (double)sum / pixels;
    }
    free(exact);
    free(fast);
    free(rgb);
}

static void assert_near_exact(const struct map *map, enum glint_normals format, const struct look *look)
{
    int largest[3];
    double mean[3];
    differences(map, format, look, largest, mean);
    for (int k = 0; k < 3; k++)
        if (largest[k] > 2 || mean[k] > .5)
            fail_msg("%s, n = %u, channel %d: largest %d steps, mean %.3f", normals_names[format], look->material.n, k,
                     largest[k], mean[k]);
}

static void pixels_are_within_two_steps_of_the_exact_paint_on_a_real_normal_map(void **state)
{
    (void)state;
    static const uint16_t shininess[] = {5, 10, 60, 200, 1000};
    for (int format = GLINT_NORMALS_INT16; format <= GLINT_NORMALS_INT8; format++) {
        struct map map = rock_wall((enum glint_normals)format);
        for (int i = 0; i < 5; i++) {
            const struct look look = grey_look(shininess[i], GLINT_RGB565);
            assert_near_exact(&map, (enum glint_normals)format, &look);
        }
        map_free(&map);
    }
}

static void pixels_are_within_two_steps_of_the_exact_paint_for_random_normals_lights_and_materials(void **state)
{
    (void)state;
    for (int i = 0; i < 30; i++) {
        struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
        look.output.dither = false;
        look.material.model = look.material.model == GLINT_PHONG ? GLINT_BLINN : look.material.model;
        look.material.q = 8;
        make_grey(&look, below(20000), below(65536 - 20000));
        const enum glint_normals format = (enum glint_normals)(i % 2);
        struct map map = random_map(format, &look);
        assert_near_exact(&map, format, &look);
        map_free(&map);
    }
}

/* Of one pixel. */
static uint16_t drawn(const struct glint_paint *paint, enum glint_normals format, const struct glint_vec *normal,
                      uint16_t albedo)
{
    const uint32_t word = glint_normals_pack(format, normal);
    uint16_t out = 0;
    const struct glint_surface surface = {&out, 0, 0, 0};
    const struct glint_maps maps =
        maps_over(format, format == GLINT_NORMALS_INT8 ? (const void *)&word : normal, &albedo, 1);
    assert_int_equal(glint_draw_rect(paint, &maps, 1, 1, &surface, NULL), GLINT_OK);
    return out;
}

static void a_field_that_overflows_is_full_and_the_others_are_not_touched(void **state)
{
    (void)state;
    static const uint16_t colours[] = {0xffff, 0xf800, 0x07e0, 0x001f, 0xf81f, 0x0000, 0x8410};
    for (int k = 0; k < 4; k++) {
        struct look look = grey_look(60, GLINT_RGB565);
        for (int c = 0; c < 3; c++)
            look.material.specular_q16[c] = k == 3 || k == c ? 65536 : 0;
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
        for (size_t i = 0; i < sizeof colours / sizeof *colours; i++)
            for (int format = 0; format < 2; format++) {
                const uint16_t out = drawn(&paint, (enum glint_normals)format, &look.h, colours[i]);
                for (int c = 0; c < 3; c++) {
                    const int most = c == 1 ? 63 : 31, albedo = channel(colours[i], c);
                    if (k == 3 || k == c)
                        assert_in_range(channel(out, c), format ? most - 2 : most, most);
                    else
                        assert_in_range(channel(out, c), albedo * 8 / 10, albedo);
                }
            }
    }
}

/* Q1.15 vectors may be a little longer than 1. */
static void a_surface_that_faces_the_light_is_lit_in_full_though_its_normal_is_longer_than_1(void **state)
{
    (void)state;
    struct look look = grey_look(60, GLINT_RGB565);
    static const int32_t to_light[3] = {1, 1, 1};
    assert_int_equal(look_light(&look, to_light, in_front), GLINT_OK);
    assert_true(dot(look.l, look.l) > 1 << 30);
    make_grey(&look, 0, 65536);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    assert_int_equal(drawn(&paint, GLINT_NORMALS_INT16, &look.l, 0xffff), 0xffff);
}

static void a_span_is_within_two_steps_of_the_exact_span_wherever_it_lies(void **state)
{
    (void)state;
    for (int i = 0; i < 300; i++) {
        struct look look = grey_look(60, (enum glint_format)below(2));
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
        const struct glint_vec first = random_normal(&look);
        struct glint_vec last = {(int16_t)(first.x / 2 + 6000), first.y, first.z};
        struct glint_span span;
        const int32_t v[3] = {last.x, last.y, last.z};
        if (glint_vec_normalize(&last, v) || glint_span_init(&span, &paint, &first, &last, (uint16_t)(1 + below(320))))
            continue;
        uint16_t albedo[320], exact[320], fast[321], aligned[320];
        const uint16_t color = (uint16_t)below(65536);
        for (int x = 0; x < 320; x++)
            albedo[x] = color;
        expand(look.material.albedo, color);
        const struct glint_surface to_exact = {exact, 0, 0, 0}, to_fast = {fast, 0, 0, 0};
        const struct glint_surface unaligned = {(uint8_t *)fast + 1, 0, 0, 0};
        const struct glint_maps maps = {.albedo = (const uint8_t *)albedo, .albedo_format = GLINT_RGB565};
        assert_int_equal(draw_span(&look, &span, &to_exact, NULL), GLINT_OK);
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &to_fast, NULL), GLINT_OK);
        const bool swapped = look.output.format == GLINT_RGB565_SWAPPED;
        for (int x = 0; x < span.w; x++)
            for (int k = 0; k < 3; k++) {
                const uint16_t a = swapped ? (uint16_t)(exact[x] << 8 | exact[x] >> 8) : exact[x];
                const uint16_t b = swapped ? (uint16_t)(fast[x] << 8 | fast[x] >> 8) : fast[x];
                assert_in_range(abs(channel(a, k) - channel(b, k)), 0, 2);
            }
        memcpy(aligned, fast, sizeof aligned);
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &unaligned, NULL), GLINT_OK);
        assert_memory_equal((uint8_t *)fast + 1, aligned, 2u * span.w);
    }
}

static void a_span_whose_t_has_come_a_little_below_0_is_at_its_peak(void **state)
{
    (void)state;
    const struct look look = grey_look(60, GLINT_RGB565);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    uint16_t at[2];
    static const uint16_t albedo = 0x4208;
    const struct glint_maps maps = {.albedo = (const uint8_t *)&albedo, .albedo_format = GLINT_RGB565};
    for (int k = 0; k < 2; k++) {
        const struct glint_span span = {k ? 0 - UINT32_C(1000) : 0, 0, 0, 1 << 28, 0, 1, {{0, 0}, {0, 0}}};
        const struct glint_surface surface = {&at[k], 0, 0, 0};
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &surface, NULL), GLINT_OK);
    }
    assert_int_equal(at[0], at[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pixels_are_within_two_steps_of_the_exact_paint_on_a_real_normal_map),
        cmocka_unit_test(pixels_are_within_two_steps_of_the_exact_paint_for_random_normals_lights_and_materials),
        cmocka_unit_test(a_field_that_overflows_is_full_and_the_others_are_not_touched),
        cmocka_unit_test(a_surface_that_faces_the_light_is_lit_in_full_though_its_normal_is_longer_than_1),
        cmocka_unit_test(a_span_is_within_two_steps_of_the_exact_span_wherever_it_lies),
        cmocka_unit_test(a_span_whose_t_has_come_a_little_below_0_is_at_its_peak),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
