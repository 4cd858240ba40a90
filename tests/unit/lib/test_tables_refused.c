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
        cmocka_unit_test(eight_bit_normals_require_the_viewer_in_front_except_with_small_tables),
        cmocka_unit_test(eight_bit_normals_require_a_light_of_length_1_and_its_own_half_vector),
        cmocka_unit_test(eight_bit_normals_take_every_light_of_glint_light_init),
        cmocka_unit_test(rectangles_by_tables_refuse_what_cannot_be),
        cmocka_unit_test(spans_lights_and_palettes_refuse_what_cannot_be),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
