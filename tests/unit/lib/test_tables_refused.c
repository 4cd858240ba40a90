/* SPDX-License-Identifier: MIT
 * Table loops: what they refuse. */
#include "tables_model.h"

static uint32_t memory[GLINT_TABLES_COLOUR_BYTES / 4], small_memory[GLINT_TABLES_SMALL_BYTES / 4];

static struct glint_shader shader_for(enum glint_format format)
{
    struct glint_shader s = tables_shader(format);
    glint_lobe_init(&s.lobe, GLINT_MSH, 60, 8);
    return s;
}

static void what_tables_cannot_be_filled_for_is_refused_and_nothing_is_written(void **state)
{
    (void)state;
    struct glint_shader shader = shader_for(GLINT_RGB565);
    struct glint_tables tables;
    uint32_t guard[GLINT_TABLES_COLOUR_BYTES / 4];
    memset(guard, GUARD, sizeof guard);
    const enum glint_tables_kind colour = GLINT_TABLES_COLOUR, small = GLINT_TABLES_SMALL;
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, guard, sizeof guard - 1), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_fill(&tables, small, &shader, guard, GLINT_TABLES_SMALL_BYTES - 1), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, (char *)guard + 2, sizeof guard), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_fill(&tables, (enum glint_tables_kind)3, &shader, guard, sizeof guard),
                     GLINT_ERR_ARG);
    assert_int_equal(glint_tables_fill(&tables, colour, NULL, guard, sizeof guard), GLINT_ERR_ARG);
    shader.lobe.model = GLINT_PHONG;
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, guard, sizeof guard), GLINT_ERR_ARG);
    shader.lobe.model = 77;
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, guard, sizeof guard), GLINT_ERR_ARG);
    shader.lobe.model = GLINT_MSH;
    shader.dither = true; /* takes more bytes */
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, guard, sizeof guard), GLINT_ERR_ARG);
    shader.dither = false;
    shader.format = GLINT_RGB888;
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, guard, sizeof guard), GLINT_ERR_FORMAT);
    shader.space = GLINT_LINEAR;
    assert_int_equal(glint_tables_fill(&tables, small, &shader, guard, sizeof guard), GLINT_ERR_FORMAT);
    for (size_t i = 0; i < sizeof guard / 4; i++)
        assert_int_equal(guard[i], GUARD * 0x01010101u);
    static uint32_t more[GLINT_TABLES_DITHER_BYTES / 4];
    shader.format = GLINT_RGB565;
    shader.dither = true; /* in linear space */
    assert_int_equal(glint_tables_fill(&tables, colour, &shader, more, sizeof more), GLINT_ERR_FORMAT);
    shader = shader_for(GLINT_RGB565);
    for (int k = 0; k < 3; k++) {
        shader.material.ambient_q16[k] = 65537; /* an albedo is scaled by 1 at most */
        shader.material.diffuse_q16[k] = 0;
    }
    assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &shader, more, sizeof more), GLINT_ERR_ARG);
    assert_int_equal(more[0], 0);
}

/* A light by hand whose half vector has next to no length. */
static void a_light_straight_behind_leaves_the_dark(void **state)
{
    (void)state;
    static uint32_t albedo_memory[GLINT_TABLES_ALBEDO_BYTES / 4];
    static const uint16_t albedo[4] = {0x1234, 0xffff, 0, 0x8410};
    struct glint_shader shader = shader_for(GLINT_RGB565);
    struct glint_tables of_albedo, of_colours;
    uint16_t dark[4], unlit[4];
    for (int k = 0; k < 3; k++)
        shader.material.ambient_q16[k] = shader.material.diffuse_q16[k] = 20000;
    assert_int_equal(glint_tables_fill(&of_colours, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
    assert_int_equal(glint_tables_fill(&of_albedo, GLINT_TABLES_ALBEDO, &shader, albedo_memory, sizeof albedo_memory),
                     GLINT_OK);
    for (int16_t x = 0; x < 4; x++) {
        const struct glint_light behind = {{x, 0, -32768}, {0, 0, 32767}, {32767, 0, 0}};
        struct glint_tables_light light;
        uint16_t out[4] = {7, 7, 7, 7};
        const struct glint_surface surface = {out, 4, 0, 0};
        static const uint32_t normals[4] = {0x7fff0000, 0x7fff0000, 0x7fff0000, 0x7fff0000}; /* to the viewer */
        assert_int_equal(glint_tables_light_init(&light, &of_colours, &behind), GLINT_OK);
        assert_int_equal(glint_tables_rect(&of_colours, &light, GLINT_NORMALS_INT8, normals, 8, 2, 2, &surface),
                         GLINT_OK);
        if (x == 0)
            memcpy(unlit, out, sizeof unlit);
        assert_memory_equal(out, unlit, sizeof out);
        assert_int_equal(glint_tables_light_init(&light, &of_albedo, &behind), GLINT_OK);
        assert_int_equal(
            glint_tables_albedo_rect(&of_albedo, &light, GLINT_NORMALS_INT8, normals, 8, albedo, 4, 2, 2, &surface),
            GLINT_OK);
        assert_in_range(out[1] >> 11, 9, 10); /* 31 times the ambient, 0.305 */
        if (x == 0)
            memcpy(dark, out, sizeof dark);
        assert_memory_equal(out, dark, sizeof out);
    }
}

/* The peak: t is 0, and of a row of nl the table has the middle. */
static void colour_tables_of_linear_space_hold_its_pixels(void **state)
{
    (void)state;
    struct glint_shader shader = shader_for(GLINT_RGB565);
    shader.space = GLINT_LINEAR;
    shader.light = (struct glint_light){{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    const struct glint_vec normal = {0, 0, 32767};
    for (int i = 0; i < 20; i++) {
        struct glint_tables tables;
        struct glint_tables_light light;
        uint16_t found, exact;
        const struct glint_source source = {.normals = &normal};
        const struct glint_surface to_found = {&found, 2, 0, 0}, to_exact = {&exact, 2, 0, 0};
        for (int k = 0; k < 3; k++) {
            shader.material.albedo[k] = (uint8_t)below(256);
            shader.material.specular_q16[k] = below(20000);
        }
        assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, memory, sizeof memory), GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        assert_int_equal(glint_tables_rect(&tables, &light, GLINT_NORMALS_INT16, &normal, 6, 1, 1, &to_found),
                         GLINT_OK);
        assert_int_equal(glint_shade_rect(&shader, &source, 1, 1, &to_exact, NULL), GLINT_OK);
        assert_in_range(1 + (found >> 11) - (exact >> 11), 0, 2);
        assert_in_range(1 + (found >> 5 & 63) - (exact >> 5 & 63), 0, 2);
        assert_in_range(1 + (found & 31) - (exact & 31), 0, 2);
    }
}

/* COLOUR tables, a light for a viewer, and what is drawn on. */
struct loop {
    struct glint_tables tables;
    struct glint_tables_light light;
    uint16_t out[8]; /* two lines */
    struct glint_surface surface;
};

static void loop_init(struct loop *loop, enum glint_tables_kind kind, const int32_t to_viewer[3])
{
    static const int32_t to_light[3] = {0, 1, 1};
    struct glint_shader shader = shader_for(GLINT_RGB565);
    const bool is_small = kind == GLINT_TABLES_SMALL;
    assert_int_equal(glint_light_init(&shader.light, to_light, to_viewer), GLINT_OK);
    assert_int_equal(
        glint_tables_fill(&loop->tables, kind, &shader, is_small ? small_memory : memory, glint_tables_bytes(kind)),
        GLINT_OK);
    assert_int_equal(glint_tables_light_init(&loop->light, &loop->tables, &shader.light), GLINT_OK);
    memset(loop->out, GUARD, sizeof loop->out);
    loop->surface = (struct glint_surface){loop->out, 8, 0, 0};
}

static void assert_untouched(const struct loop *loop)
{
    for (int i = 0; i < 8; i++)
        assert_int_equal(loop->out[i], GUARD << 8 | GUARD);
}

static const int32_t front[3] = {0, 0, 1};
static const uint32_t words[4] = {1u << 30 | 1, 1u << 30 | 1, 1u << 30 | 1, 1u << 30 | 1};
enum { INT16 = GLINT_NORMALS_INT16, INT10 = GLINT_NORMALS_INT10, INT8 = GLINT_NORMALS_INT8 };

static void refuses(const struct loop *loop, enum glint_err err, int format, const void *normals, ptrdiff_t stride)
{
    assert_int_equal(glint_tables_rect(&loop->tables, &loop->light, (enum glint_normals)format, normals, stride, 2, 2,
                                       &loop->surface),
                     err);
    assert_untouched(loop);
}

static void eight_bit_normals_require_the_viewer_in_front_except_with_small_tables(void **state)
{
    (void)state;
    static const int32_t aside[][3] = {{1, 0, 4}, {0, 0, -1}, {1, 0, 200}, {0, -1, 200}}; /* two with z = 32767 */
    for (int i = 0; i < 4; i++) {
        struct loop loop;
        loop_init(&loop, GLINT_TABLES_COLOUR, aside[i]);
        refuses(&loop, GLINT_ERR_VECTOR, INT8, words, 8);
        loop_init(&loop, GLINT_TABLES_SMALL, aside[i]);
        assert_int_equal(
            glint_tables_rect(&loop.tables, &loop.light, GLINT_NORMALS_INT8, words, 8, 2, 2, &loop.surface), GLINT_OK);
    }
}

static void eight_bit_normals_require_a_light_of_length_1_and_its_own_half_vector(void **state)
{
    (void)state;
    static const struct glint_light wrong[] = {
        {{32767, 32767, 32767}, {0, 0, 32767}, {15000, 15000, 25000}}, /* 1.7 long */
        {{0, 0, 32767}, {0, 0, 32767}, {0, 0, -32767}},
        {{0, 0, 32767}, {0, 0, 32767}, {32767, 0, 0}},
        {{0, 0, 32767}, {0, 0, 32767}, {32767, 32767, 32767}},
    };
    for (int i = 0; i < 4; i++) {
        struct loop loop;
        loop_init(&loop, GLINT_TABLES_COLOUR, front);
        assert_int_equal(glint_tables_light_init(&loop.light, &loop.tables, &wrong[i]), GLINT_OK);
        refuses(&loop, GLINT_ERR_VECTOR, INT8, words, 8);
        loop_init(&loop, GLINT_TABLES_SMALL, front);
        assert_int_equal(glint_tables_light_init(&loop.light, &loop.tables, &wrong[i]), GLINT_OK);
        assert_int_equal(
            glint_tables_rect(&loop.tables, &loop.light, GLINT_NORMALS_INT8, words, 8, 2, 2, &loop.surface), GLINT_OK);
    }
}

/* The light's own rounding, and what programs round it to, is no reason to refuse it. */
static void eight_bit_normals_take_every_light_of_glint_light_init(void **state)
{
    (void)state;
    struct loop loop;
    loop_init(&loop, GLINT_TABLES_COLOUR, front);
    for (int i = 0; i < 100000; i++) {
        const int32_t near = 1 << below(31), viewer[3] = {0, 0, 1};
        int32_t to_light[3] = {(int32_t)below(2001) - 1000, (int32_t)below(2001) - 1000, (int32_t)below(2001) - 1000};
        if (i % 2)
            to_light[2] = -near; /* also almost straight behind */
        struct glint_light light;
        if (glint_light_init(&light, to_light, viewer) != GLINT_OK)
            continue;
        light.l.x = (int16_t)(light.l.x & ~255); /* as one held in bytes */
        assert_int_equal(glint_tables_light_init(&loop.light, &loop.tables, &light), GLINT_OK);
        assert_int_equal(
            glint_tables_rect(&loop.tables, &loop.light, GLINT_NORMALS_INT8, words, 8, 2, 2, &loop.surface), GLINT_OK);
    }
}

static void rectangles_by_tables_refuse_what_cannot_be(void **state)
{
    (void)state;
    struct loop loop, of_small;
    loop_init(&loop, GLINT_TABLES_COLOUR, front);
    loop_init(&of_small, GLINT_TABLES_SMALL, front);
    refuses(&loop, GLINT_ERR_FORMAT, 3, words, 8);
    refuses(&loop, GLINT_ERR_ARG, INT10, NULL, 8);
    refuses(&loop, GLINT_ERR_ARG, INT10, (const char *)words + 2, 8);
    refuses(&loop, GLINT_ERR_ARG, INT8, words, 6);
    refuses(&loop, GLINT_ERR_ARG, INT16, (const char *)words + 1, 6);
    refuses(&loop, GLINT_ERR_ARG, INT16, words, -7);
    struct loop bad = loop;
    bad.light = of_small.light; /* a light for other tables */
    refuses(&bad, GLINT_ERR_ARG, INT10, words, 8);
    bad = of_small;
    bad.light = loop.light;
    refuses(&bad, GLINT_ERR_ARG, INT10, words, 8);
    bad = loop;
    bad.surface.pixels = NULL;
    refuses(&bad, GLINT_ERR_ARG, INT10, words, 8);
    assert_int_equal(glint_tables_rect(&loop.tables, NULL, GLINT_NORMALS_INT10, words, 8, 2, 2, &loop.surface),
                     GLINT_ERR_ARG);
    assert_int_equal(glint_tables_rect(NULL, &loop.light, GLINT_NORMALS_INT10, words, 8, 2, 2, &loop.surface),
                     GLINT_ERR_ARG);
    assert_int_equal(glint_tables_rect(&loop.tables, &loop.light, GLINT_NORMALS_INT10, words, 8, 2, 2, NULL),
                     GLINT_ERR_ARG);
    assert_untouched(&loop);
}

static void spans_lights_and_palettes_refuse_what_cannot_be(void **state)
{
    (void)state;
    struct loop loop;
    loop_init(&loop, GLINT_TABLES_COLOUR, front);
    const struct glint_span span = {0, 0, 0, 1 << 29, 0, 4};
    const struct glint_light light = {{0, 0, 32767}, {0, 0, 32767}, {0, 0, 32767}};
    const struct glint_surface none = {NULL, 8, 0, 0}, odd = {(char *)loop.out + 1, 8, 0, 0};
    const struct glint_surface odd_stride = {loop.out, 7, 0, 0}, *to = &loop.surface;
    assert_int_equal(glint_tables_span(&loop.tables, NULL, to), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_span(NULL, &span, to), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_span(&loop.tables, &span, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_span(&loop.tables, &span, &none), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_light_init(NULL, &loop.tables, &light), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_light_init(&loop.light, NULL, &light), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_light_init(&loop.light, &loop.tables, NULL), GLINT_ERR_ARG);
    static const uint16_t colours[3] = {1, 2, 3}, offsets[4] = {0, 2, 0, 2};
    const uint16_t *odd_colours = (const uint16_t *)(const void *)((const char *)colours + 1);
    const uint16_t *odd_offsets = (const uint16_t *)(const void *)((const char *)offsets + 1);
    assert_int_equal(glint_palette_rect(NULL, offsets, 4, 1, 1, to), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(colours, NULL, 4, 1, 1, to), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(odd_colours, offsets, 4, 1, 1, to), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(colours, odd_offsets, 4, 1, 1, to), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(colours, offsets, 3, 1, 1, to), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(colours, offsets, 4, 1, 1, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(colours, offsets, 4, 1, 1, &none), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(colours, offsets, 4, 1, 1, &odd), GLINT_ERR_ARG);
    assert_int_equal(glint_palette_rect(colours, offsets, 4, 1, 1, &odd_stride), GLINT_ERR_ARG);
    assert_untouched(&loop);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_tables_cannot_be_filled_for_is_refused_and_nothing_is_written),
        cmocka_unit_test(a_light_straight_behind_leaves_the_dark),
        cmocka_unit_test(colour_tables_of_linear_space_hold_its_pixels),
        cmocka_unit_test(eight_bit_normals_require_the_viewer_in_front_except_with_small_tables),
        cmocka_unit_test(eight_bit_normals_require_a_light_of_length_1_and_its_own_half_vector),
        cmocka_unit_test(eight_bit_normals_take_every_light_of_glint_light_init),
        cmocka_unit_test(rectangles_by_tables_refuse_what_cannot_be),
        cmocka_unit_test(spans_lights_and_palettes_refuse_what_cannot_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
