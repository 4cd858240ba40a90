/* SPDX-License-Identifier: MIT
 * Formats with blue first: from every source they have RGB888's channels, and the alpha that is stated. */
#include "lamps.h"
#include "meshes.h"

static const enum glint_format blue_first[] = {GLINT_BGR888, GLINT_XRGB8888, GLINT_ARGB8888};
enum { KINDS = 3, SCENES = 60 };

/* The format's bytes from those of RGB888, where there is coverage; NULL: 255. */
static void expect(uint8_t *line, enum glint_format format, const uint8_t *rgb, const uint8_t *coverage, unsigned w)
{
    const unsigned bytes = bytes_of(format, 1);
    for (unsigned x = 0; x < w; x++) {
        if (coverage && !coverage[x])
            continue;
        for (unsigned k = 0; k < 3; k++)
            line[bytes * x + 2 - k] = rgb[3 * x + k];
        if (format == GLINT_XRGB8888)
            line[4 * x + 3] = 255;
        if (format == GLINT_ARGB8888)
            line[4 * x + 3] = coverage ? coverage[x] : 255;
    }
}

static uint8_t wanted[LINE * (H + 2)];
static struct scene rgb, bgr;

/* A scene with some of its maps, and the same in format number i of those with blue first. */
static void two_scenes(unsigned i)
{
    scene_init(&rgb, GLINT_RGB888, (enum glint_space)(i & 1));
    memset(wanted, GUARD, sizeof wanted);
    rgb.maps.albedo = below(2) ? rgb.albedo : NULL;
    rgb.maps.gloss = below(2) ? rgb.gloss : NULL;
    rgb.maps.coverage = below(3) ? rgb.coverage : NULL;
    scene_copy(&bgr, &rgb);
    bgr.look.output.format = (uint8_t)blue_first[i % KINDS];
    for (unsigned p = 0; p < W * H; p++) /* RGB888 has no alpha */
        if (bgr.look.output.format == GLINT_ARGB8888 && rgb.coverage[p])
            rgb.coverage[p] = 255;
}

static void assert_lines_have_the_same_channels(unsigned lines)
{
    for (unsigned y = 0; y < lines; y++)
        expect(wanted + LINE * (1 + y), (enum glint_format)bgr.look.output.format, rgb.out + LINE * (1 + y),
               bgr.maps.coverage ? bgr.coverage + W * y : NULL, W);
    assert_memory_equal(bgr.out, wanted, sizeof wanted);
}

static void rectangles_have_the_channels_of_rgb888_and_alpha_is_the_coverage(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 2 * SCENES; i++) {
        struct glint_box a, b;
        two_scenes(i);
        assert_int_equal(draw_scene(&rgb, &a), GLINT_OK);
        assert_int_equal(draw_scene(&bgr, &b), GLINT_OK);
        assert_lines_have_the_same_channels(H);
        assert_true(same_box(&a, &b));
    }
}

static void rectangles_under_several_lights_have_them_too(void **state)
{
    (void)state;
    for (unsigned i = 0; i < SCENES; i++) {
        struct glint_light lights[GLINT_LIGHTS_MAX];
        struct glint_box a, b;
        two_scenes(i);
        random_lights(lights);
        if (i % 4 == 0) /* grey: in one sum */
            for (unsigned l = 0; l < GLINT_LIGHTS_MAX; l++)
                lights[l].color_q16[1] = lights[l].color_q16[2] = lights[l].color_q16[0];
        const unsigned count = i % (GLINT_LIGHTS_MAX + 1);
        draw_scene_under(&rgb, lights, count, &a);
        draw_scene_under(&bgr, lights, count, &b);
        assert_lines_have_the_same_channels(H);
        assert_true(same_box(&a, &b));
    }
}

static void spans_have_them_too(void **state)
{
    (void)state;
    for (unsigned i = 0; i < SCENES; i++) {
        const struct glint_span span = {below(1u << 30),          below(1 << 24),          below(1 << 18),
                                        (int32_t)below(1u << 30), (int32_t)below(1 << 24), W,
                                        {{0, 0}, {0, 0}}};
        struct glint_paint paint;
        two_scenes(i);
        rgb.look.material.model = bgr.look.material.model = GLINT_MSH;
        paint_of(&paint, &rgb.look);
        assert_int_equal(glint_draw_span(&paint, &span, &rgb.maps, &rgb.surface, NULL), GLINT_OK);
        assert_int_equal(glint_paint_exact_for(&paint, &bgr.look.material, &bgr.look.output, &glint_use_msh,
                                               i & 1 ? &glint_use_linear : &glint_use_rgb888),
                         GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, &bgr.look.light, 1, bgr.look.to_viewer), GLINT_OK);
        assert_int_equal(glint_draw_span(&paint, &span, &bgr.maps, &bgr.surface, NULL), GLINT_OK);
        assert_lines_have_the_same_channels(1);
    }
}

static void meshes_have_them_too(void **state)
{
    (void)state;
    static struct made_mesh mesh;
    static uint8_t of_rgb[3 * MESH_W * MESH_H], of_bgr[4 * MESH_W * MESH_H];
    const unsigned whole = MESH_H;
    mesh_ball(&mesh, 10, 12);
    for (unsigned i = 0; i < KINDS; i++) {
        const enum glint_format format = blue_first[i];
        const unsigned bytes = bytes_of(format, 1);
        struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
        set_model(&look, GLINT_MSH, 60, 8);
        look.material.ambient_q16[1] = 20000; /* no pixel is black */
        look.material.albedo[1] = 255;
        for (unsigned k = 0; k < 2; k++) {
            struct glint_paint paint;
            look.output.format = (uint8_t)(k ? format : GLINT_RGB888);
            paint_of(&paint, &look);
            memset(k ? of_bgr : of_rgb, 0, k ? sizeof of_bgr : sizeof of_rgb);
            mesh_picture(&mesh, &paint, k ? of_bgr : of_rgb, k ? bytes : 3, &whole, 1, false);
        }
        unsigned drawn = 0;
        for (unsigned p = 0; p < MESH_W * MESH_H; p++) {
            const uint8_t *const from = of_rgb + 3 * p, covered = from[1] != 0;
            uint8_t pixel[4] = {0, 0, 0, 0};
            if (covered)
                expect(pixel, format, from, NULL, 1);
            assert_memory_equal(of_bgr + bytes * p, pixel, bytes);
            drawn += covered;
        }
        assert_in_range(drawn, 1000, MESH_W * MESH_H);
    }
}

static void a_format_named_with_the_paint_refuses_the_others(void **state)
{
    (void)state;
    static const struct glint_use_format *const groups[] = {&glint_use_rgb565, &glint_use_rgb888, &glint_use_grey};
    for (unsigned format = 0; format <= GLINT_FORMAT_COUNT; format++)
        for (unsigned space = GLINT_GAMMA; space <= GLINT_LINEAR + 1; space++) {
            struct look look = random_look((enum glint_format)format, (enum glint_space)space);
            look.material.model = GLINT_MSH;
            const unsigned own = format <= GLINT_RGB565_SWAPPED ? 0 : is_grey((enum glint_format)format) ? 2 : 1;
            const bool is_there = format < GLINT_FORMAT_COUNT;
            struct glint_paint paint;
            for (unsigned group = 0; group < 3; group++)
                assert_int_equal(
                    glint_paint_exact_for(&paint, &look.material, &look.output, &glint_use_msh, groups[group]),
                    is_there && group == own && space == GLINT_GAMMA ? GLINT_OK : GLINT_ERR_FORMAT);
            assert_int_equal(
                glint_paint_exact_for(&paint, &look.material, &look.output, &glint_use_msh, &glint_use_linear),
                is_there && space == GLINT_LINEAR ? GLINT_OK : GLINT_ERR_FORMAT);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles_have_the_channels_of_rgb888_and_alpha_is_the_coverage),
        cmocka_unit_test(rectangles_under_several_lights_have_them_too),
        cmocka_unit_test(spans_have_them_too),
        cmocka_unit_test(meshes_have_them_too),
        cmocka_unit_test(a_format_named_with_the_paint_refuses_the_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
