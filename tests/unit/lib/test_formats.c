/* SPDX-License-Identifier: MIT
 * Formats with blue first: on every path they have RGB888's channels, and the alpha that is stated. */
#include "lamps.h"
#include "meshes.h"

static const enum glint_format blue_first[] = {GLINT_BGR888, GLINT_XRGB8888, GLINT_ARGB8888};
enum { KINDS = 3, SCENES = 60 };

/* The format's bytes from those of RGB888, where the mask is not 0; mask NULL: 255. */
static void expect(uint8_t *line, enum glint_format format, const uint8_t *rgb, const uint8_t *mask, unsigned w)
{
    const unsigned bytes = bytes_of(format, 1);
    for (unsigned x = 0; x < w; x++) {
        if (mask && !mask[x])
            continue;
        for (unsigned k = 0; k < 3; k++)
            line[bytes * x + 2 - k] = rgb[3 * x + k];
        if (format == GLINT_XRGB8888)
            line[4 * x + 3] = 255;
        if (format == GLINT_ARGB8888)
            line[4 * x + 3] = mask ? mask[x] : 255;
    }
}

static uint8_t wanted[LINE * (H + 2)];
static struct scene rgb, bgr;

/* The scene a second time, in format number i of those with blue first. */
static void scene_again(unsigned i)
{
    memset(wanted, GUARD, sizeof wanted);
    for (unsigned p = 0; p < W * H; p++)
        rgb.mask[p] = (uint8_t)(below(4) ? 1 + below(255) : 0);
    bgr = rgb;
    bgr.shader.format = (uint8_t)blue_first[i % KINDS];
    bgr.surface.pixels = bgr.out + LINE;
    bgr.source.normals = bgr.normals;
    bgr.source.albedo = below(2) ? bgr.albedo : NULL;
    bgr.source.gloss = below(2) ? bgr.gloss : NULL;
    bgr.source.mask = below(3) ? bgr.mask : NULL;
    rgb.source.albedo = bgr.source.albedo;
    rgb.source.gloss = bgr.source.gloss;
    rgb.source.mask = bgr.source.mask;
}

static void assert_lines_have_the_same_channels(unsigned lines, bool masked)
{
    const enum glint_format format = (enum glint_format)bgr.shader.format;
    for (unsigned y = 0; y < lines; y++)
        expect(wanted + LINE * (1 + y), format, rgb.out + LINE * (1 + y),
               masked && rgb.source.mask ? rgb.mask + W * y : NULL, W);
    assert_memory_equal(bgr.out, wanted, sizeof wanted);
}

static void rectangles_have_the_channels_of_rgb888_and_alpha_is_the_mask(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 2 * SCENES; i++) {
        struct glint_box a, b;
        scene_init(&rgb, GLINT_RGB888, (enum glint_space)(i & 1));
        scene_again(i);
        assert_int_equal(glint_shade_rect(&rgb.shader, &rgb.source, W, H, &rgb.surface, &a), GLINT_OK);
        assert_int_equal(glint_shade_rect(&bgr.shader, &bgr.source, W, H, &bgr.surface, &b), GLINT_OK);
        assert_lines_have_the_same_channels(H, true);
        assert_memory_equal(&a, &b, sizeof a);
    }
}

static void rectangles_under_lamps_have_them_too(void **state)
{
    (void)state;
    for (unsigned i = 0; i < SCENES; i++) {
        struct glint_lamp lamps[GLINT_LAMPS_MAX];
        struct glint_box a, b;
        scene_init(&rgb, GLINT_RGB888, (enum glint_space)(i & 1));
        scene_again(i);
        random_lamps(lamps);
        if (i % 4 == 0) /* white: in one sum */
            for (unsigned l = 0; l < GLINT_LAMPS_MAX; l++)
                lamps[l].color_q16[1] = lamps[l].color_q16[2] = lamps[l].color_q16[0];
        const unsigned count = i % (GLINT_LAMPS_MAX + 1);
        assert_int_equal(glint_shade_lights(&rgb.shader, lamps, count, &rgb.source, W, H, &rgb.surface, &a), GLINT_OK);
        assert_int_equal(glint_shade_lights(&bgr.shader, lamps, count, &bgr.source, W, H, &bgr.surface, &b), GLINT_OK);
        assert_lines_have_the_same_channels(H, true);
        assert_memory_equal(&a, &b, sizeof a);
    }
}

static void prepared_spans_and_spans_by_c_have_them_without_a_mask(void **state)
{
    (void)state;
    for (unsigned i = 0; i < SCENES; i++) {
        const struct glint_span span = {below(1u << 30),          below(1 << 24),          below(1 << 18),
                                        (int32_t)below(1u << 30), (int32_t)below(1 << 24), W};
        struct glint_prepared prepared;
        scene_init(&rgb, GLINT_RGB888, (enum glint_space)(i & 1));
        rgb.shader.lobe.model = GLINT_MSH;
        scene_again(i);
        assert_int_equal(glint_shade_span(&rgb.shader, &span, &rgb.surface, NULL), GLINT_OK);
        assert_int_equal(glint_shade_prepare_for(&prepared, &bgr.shader, &glint_shade_msh,
                                                 i & 1 ? &glint_shade_linear : &glint_shade_bgr888),
                         GLINT_OK);
        assert_int_equal(glint_shade_prepared_span(&prepared, &span, &bgr.surface, NULL), GLINT_OK);
        assert_lines_have_the_same_channels(1, false);
        assert_int_equal(glint_shade_span_c16(&rgb.shader, &span, &rgb.surface, NULL), GLINT_OK);
        assert_int_equal(glint_shade_span_c16(&bgr.shader, &span, &bgr.surface, NULL), GLINT_OK);
        assert_lines_have_the_same_channels(1, false);
    }
}

static void small_tables_have_them_in_rectangles_and_spans(void **state)
{
    (void)state;
    static uint32_t rgb_memory[GLINT_TABLES_SMALL_BYTES / 4], bgr_memory[GLINT_TABLES_SMALL_BYTES / 4];
    for (unsigned i = 0; i < SCENES; i++) {
        struct glint_tables a, b;
        struct glint_tables_light light;
        const ptrdiff_t stride = W * (ptrdiff_t)sizeof *rgb.normals;
        scene_init(&rgb, GLINT_RGB888, GLINT_GAMMA);
        rgb.shader.lobe.model = GLINT_MSH;
        for (unsigned p = 0; p < W * H; p++) /* 0: no surface */
            rgb.normals[p] = below(5) ? rgb.normals[p] : (struct glint_vec){0, 0, 0};
        scene_again(i);
        assert_int_equal(glint_tables_fill(&a, GLINT_TABLES_SMALL, &rgb.shader, rgb_memory, sizeof rgb_memory), 0);
        assert_int_equal(glint_tables_fill(&b, GLINT_TABLES_SMALL, &bgr.shader, bgr_memory, sizeof bgr_memory), 0);
        assert_memory_equal(rgb_memory, bgr_memory, sizeof rgb_memory);
        assert_int_equal(glint_tables_light_init(&light, &a, &rgb.shader.light), GLINT_OK);
        assert_int_equal(glint_tables_rect(&a, &light, GLINT_NORMALS_INT16, rgb.normals, stride, W, H, &rgb.surface),
                         GLINT_OK);
        assert_int_equal(glint_tables_rect(&b, &light, GLINT_NORMALS_INT16, rgb.normals, stride, W, H, &bgr.surface),
                         GLINT_OK);
        for (unsigned p = 0; p < W * H; p++) {
            rgb.mask[p] = rgb.normals[p].x | rgb.normals[p].y | rgb.normals[p].z ? 255 : 0;
            rgb.source.mask = rgb.mask;
        }
        assert_lines_have_the_same_channels(H, true);
        const struct glint_span span = {below(1u << 30),          below(1 << 24),          below(1 << 18),
                                        (int32_t)below(1u << 30), (int32_t)below(1 << 24), W};
        assert_int_equal(glint_tables_span(&a, &span, &rgb.surface), GLINT_OK);
        assert_int_equal(glint_tables_span(&b, &span, &bgr.surface), GLINT_OK);
        assert_lines_have_the_same_channels(1, false);
    }
}

static void meshes_have_them_exactly_and_by_small_tables(void **state)
{
    (void)state;
    static struct made_mesh mesh;
    static uint8_t of_rgb[3 * MESH_W * MESH_H], of_bgr[4 * MESH_W * MESH_H];
    static uint32_t memory[2][GLINT_TABLES_SMALL_BYTES / 4];
    const unsigned whole = MESH_H;
    mesh_ball(&mesh, 10, 12);
    for (unsigned i = 0; i < 2 * KINDS; i++) {
        const enum glint_format format = blue_first[i % KINDS];
        const unsigned bytes = bytes_of(format, 1);
        struct glint_shader shaders[2] = {random_shader(GLINT_RGB888, GLINT_GAMMA)};
        struct glint_prepared prepared[2];
        struct glint_tables tables[2];
        shaders[0].lobe.model = GLINT_MSH;
        shaders[0].material.ambient_q16[1] = 20000; /* no pixel is black */
        shaders[0].material.albedo[1] = 255;
        shaders[1] = shaders[0];
        shaders[1].format = (uint8_t)format;
        for (unsigned k = 0; k < 2; k++) {
            assert_int_equal(glint_shade_prepare(&prepared[k], &shaders[k]), GLINT_OK);
            assert_int_equal(
                glint_tables_fill(&tables[k], GLINT_TABLES_SMALL, &shaders[k], memory[k], sizeof memory[k]), GLINT_OK);
            const struct glint_paint exact = {&glint_mesh_exact, &prepared[k]},
                                     by_tables = {&glint_mesh_tables, &tables[k]};
            memset(k ? of_bgr : of_rgb, 0, k ? sizeof of_bgr : sizeof of_rgb);
            mesh_picture(&mesh, &shaders[0].light, i < KINDS ? &exact : &by_tables, k ? of_bgr : of_rgb, k ? bytes : 3,
                         &whole, 1, false);
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

static void a_format_named_at_preparation_refuses_the_others(void **state)
{
    (void)state;
    struct glint_prepared prepared;
    for (unsigned format = 0; format <= GLINT_FORMAT_COUNT; format++) {
        struct glint_shader shader = random_shader((enum glint_format)format, GLINT_GAMMA);
        shader.lobe.model = GLINT_MSH;
        const bool is_ours = format >= GLINT_BGR888 && format <= GLINT_ARGB8888;
        assert_int_equal(glint_shade_prepare_for(&prepared, &shader, &glint_shade_msh, &glint_shade_bgr888),
                         is_ours ? GLINT_OK : GLINT_ERR_FORMAT);
        shader.space = GLINT_LINEAR;
        assert_int_equal(glint_shade_prepare_for(&prepared, &shader, &glint_shade_msh, &glint_shade_bgr888),
                         GLINT_ERR_FORMAT);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rectangles_have_the_channels_of_rgb888_and_alpha_is_the_mask),
        cmocka_unit_test(rectangles_under_lamps_have_them_too),
        cmocka_unit_test(prepared_spans_and_spans_by_c_have_them_without_a_mask),
        cmocka_unit_test(small_tables_have_them_in_rectangles_and_spans),
        cmocka_unit_test(meshes_have_them_exactly_and_by_small_tables),
        cmocka_unit_test(a_format_named_at_preparation_refuses_the_others),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
