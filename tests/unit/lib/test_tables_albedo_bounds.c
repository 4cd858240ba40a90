/* SPDX-License-Identifier: MIT
 * ALBEDO tables: what they may touch, what they refuse. */
#include "albedo.h"

/* ---- What may be touched ---- */

/* The rectangle cut anywhere, at any alignment and in either order, gives the pixels of the whole, and nothing around it is
 * written. */
static void the_rectangle_and_nothing_else_is_written_at_any_alignment(void **state)
{
    (void)state;
    static const uint16_t widths[] = {0, 1, 2, 3, 5, 6, 7, 95, 319};
    enum { WHOLE = 320, LINES = 4 };
    static struct glint_vec normals[WHOLE * LINES];
    static uint32_t words[WHOLE * LINES];
    static uint16_t albedo[WHOLE * LINES], whole[WHOLE * LINES];
    for (int i = 0; i < 200; i++) {
        struct glint_shader shader = grey_shader(1 + below(100), (enum glint_format)below(2));
        struct glint_tables tables;
        struct glint_tables_light light;
        prepare(&tables, &light, &shader);
        const enum glint_normals format = (enum glint_normals)below(3);
        const size_t size = format == GLINT_NORMALS_INT16 ? sizeof *normals : sizeof *words;
        for (int p = 0; p < WHOLE * LINES; p++) {
            normals[p] = random_normal(&shader.light);
            words[p] = glint_normals_pack(format, &normals[p]);
            albedo[p] = (uint16_t)below(65536);
        }
        const char *first = format == GLINT_NORMALS_INT16 ? (const char *)normals : (const char *)words;
        const ptrdiff_t stride = (ptrdiff_t)size * WHOLE;
        memset(whole, GUARD, sizeof whole);
        const struct glint_surface full = {whole, 2 * WHOLE, 0, 0};
        assert_int_equal(
            glint_tables_albedo_rect(&tables, &light, format, first, stride, albedo, 2 * WHOLE, WHOLE, LINES, &full),
            GLINT_OK);
        const uint16_t w = widths[below(9)], h = (uint16_t)below(LINES + 1), x = (uint16_t)below(WHOLE - w);
        const size_t line = 2 * w + below(5), room = (line + 8) * LINES;
        const uint32_t start = below(8);
        uint8_t *out = malloc(room);
        assert_non_null(out);
        memset(out, GUARD, room);
        const struct glint_surface surface = {out + start, (ptrdiff_t)line, 0, 0};
        assert_int_equal(glint_tables_albedo_rect(&tables, &light, format, first + size * x, stride, albedo + x,
                                                  2 * WHOLE, w, h, &surface),
                         GLINT_OK);
        for (size_t b = 0; b < room; b++) {
            const size_t at = b - start;
            if (b >= start && line && at / line < h && at % line < 2u * w)
                assert_int_equal(out[b], ((const uint8_t *)(whole + at / line * WHOLE + x))[at % line]);
            else
                assert_int_equal(out[b], GUARD);
        }
        free(out);
    }
}

static void swapped_pixels_are_the_others_with_their_bytes_swapped_and_may_replace_their_map(void **state)
{
    (void)state;
    enum { COUNT = 50 };
    struct glint_vec normals[COUNT];
    uint32_t words[COUNT];
    uint16_t albedo[COUNT], place[COUNT], out[2][COUNT];
    for (int format = 0; format < 3; format++) {
        for (int p = 0; p < COUNT; p++)
            albedo[p] = (uint16_t)below(65536);
        for (int order = 0; order < 2; order++) {
            const struct glint_shader shader = grey_shader(20, (enum glint_format)order);
            struct glint_tables tables;
            struct glint_tables_light light;
            prepare(&tables, &light, &shader);
            for (int p = 0; p < COUNT && order == 0; p++) {
                do
                    normals[p] = random_normal(&shader.light);
                while (normals[p].z < 500);
                words[p] = glint_normals_pack((enum glint_normals)format, &normals[p]);
            }
            const void *held = format ? (const void *)words : normals;
            memcpy(place, albedo, sizeof place);
            const struct glint_surface to_out = {out[order], 0, 0, 0}, to_place = {place, 0, 0, 0};
            assert_int_equal(glint_tables_albedo_rect(&tables, &light, (enum glint_normals)format, held, 0, albedo, 0,
                                                      COUNT, 1, &to_out),
                             GLINT_OK);
            assert_int_equal(glint_tables_albedo_rect(&tables, &light, (enum glint_normals)format, held, 0, place, 0,
                                                      COUNT, 1, &to_place),
                             GLINT_OK);
            assert_memory_equal(place, out[order], sizeof place);
        }
        for (int p = 0; p < COUNT; p++)
            assert_int_equal(out[1][p], (uint16_t)(out[0][p] << 8 | out[0][p] >> 8));
    }
}

/* For the sanitizers: any words, any light, any normals, any span. */
static void garbage_in_normals_and_spans_reads_nothing_outside_the_tables(void **state)
{
    (void)state;
    uint32_t *tight = malloc(GLINT_TABLES_ALBEDO_BYTES);
    assert_non_null(tight);
    for (int i = 0; i < 200; i++) {
        struct glint_shader shader = grey_shader(1 + below(1000), GLINT_RGB565);
        glint_lobe_init(&shader.lobe, (enum glint_model)below(3), 1 + below(1000), below(17));
        shader.material.specular_q16[0] = below(4) ? 65536 : 0;
        shader.material.specular_q16[1] = shader.material.specular_q16[2] = below(3) ? 65536 : 0;
        int16_t *light_words = (int16_t *)(void *)&shader.light.l;
        for (int k = 0; k < 3 && i % 2; k++)
            light_words[k] = (int16_t)below(65536);
        struct glint_tables tables;
        struct glint_tables_light light;
        assert_int_equal(glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &shader, tight, GLINT_TABLES_ALBEDO_BYTES),
                         GLINT_OK);
        assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
        uint32_t words[300];
        uint16_t albedo[150], out[150];
        for (int k = 0; k < 300; k++)
            words[k] = below(UINT32_MAX);
        memset(albedo, 0xff, sizeof albedo);
        const struct glint_surface surface = {out, 0, 0, 0};
        for (int format = 0; format < 3; format++)
            assert_int_equal(glint_tables_albedo_rect(&tables, &light, (enum glint_normals)format, words, 0, albedo, 0,
                                                      100, 1, &surface),
                             GLINT_OK);
        const struct glint_span span = {words[0], words[1], words[2], (int32_t)words[3], (int32_t)words[4], 150};
        assert_int_equal(glint_tables_albedo_span(&tables, &span, albedo, &surface), GLINT_OK);
    }
    free(tight);
}

static void a_run_without_surface_ends_with_the_line_whatever_it_says(void **state)
{
    (void)state;
    const struct glint_shader shader = grey_shader(60, GLINT_RGB565);
    struct glint_tables tables;
    struct glint_tables_light light;
    prepare(&tables, &light, &shader);
    static const struct glint_vec up = {0, 0, 32767};
    uint32_t words[20];
    uint16_t albedo[20], out[21];
    for (int from = 0; from < 18; from++) {
        for (int i = 0; i < 20; i++) {
            words[i] = glint_normals_pack(GLINT_NORMALS_INT8, &up);
            albedo[i] = 0xffff;
        }
        words[from] = 2;
        words[19] = 60000;
        memset(out, GUARD, sizeof out);
        const uint16_t left = out[0];
        const struct glint_surface surface = {out, 0, 0, 0};
        assert_int_equal(
            glint_tables_albedo_rect(&tables, &light, GLINT_NORMALS_INT8, words, 0, albedo, 0, 20, 1, &surface),
            GLINT_OK);
        for (int i = 0; i < 21; i++)
            assert_int_equal(out[i] == left, i == from || i == from + 1 || i >= 19);
    }
}

/* ---- What is refused ---- */

static void what_the_tables_cannot_do_is_refused_and_nothing_is_written(void **state)
{
    (void)state;
    const enum glint_tables_kind albedo_kind = GLINT_TABLES_ALBEDO;
    struct glint_tables tables;
    uint32_t guard[GLINT_TABLES_ALBEDO_BYTES / 4];
    memset(guard, GUARD, sizeof guard);
    assert_int_equal(glint_tables_bytes(albedo_kind), sizeof guard);
    struct glint_shader shader = grey_shader(60, GLINT_RGB565);
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, guard, sizeof guard - 1), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, (char *)guard + 2, sizeof guard), GLINT_ERR_ARG);
    shader.material.diffuse_q16[2]++;
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, guard, sizeof guard), GLINT_ERR_ARG);
    shader.material.diffuse_q16[2]--;
    shader.material.ambient_q16[1]++;
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, guard, sizeof guard), GLINT_ERR_ARG);
    for (int k = 0; k < 3; k++)
        shader.material.ambient_q16[k] = 65536 - 58000 + 1; /* more than 1 in all */
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, guard, sizeof guard), GLINT_ERR_ARG);
    shader = grey_shader(60, GLINT_RGB888);
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, guard, sizeof guard), GLINT_ERR_FORMAT);
    shader = grey_shader(60, GLINT_RGB565);
    shader.dither = true;
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, guard, sizeof guard), GLINT_ERR_FORMAT);
    shader.dither = false;
    shader.space = GLINT_LINEAR;
    assert_int_equal(glint_tables_fill(&tables, albedo_kind, &shader, guard, sizeof guard), GLINT_ERR_FORMAT);
    for (size_t i = 0; i < sizeof guard / 4; i++)
        assert_int_equal(guard[i], GUARD * 0x01010101u);

    shader = grey_shader(60, GLINT_RGB565);
    static uint32_t colour_memory[GLINT_TABLES_COLOUR_BYTES / 4];
    struct glint_tables colour;
    struct glint_tables_light light, colour_light;
    prepare(&tables, &light, &shader);
    assert_int_equal(glint_tables_fill(&colour, GLINT_TABLES_COLOUR, &shader, colour_memory, sizeof colour_memory), 0);
    assert_int_equal(glint_tables_light_init(&colour_light, &colour, &shader.light), GLINT_OK);
    uint16_t out[4] = {7, 7, 7, 7};
    const struct glint_surface surface = {out, 8, 0, 0};
    const uint32_t words[4] = {1u << 30, 1u << 30, 1u << 30, 1u << 30};
    const uint16_t map[4] = {0, 0, 0, 0};
    const enum glint_normals int8 = GLINT_NORMALS_INT8;
    const struct glint_span span = {0, 0, 0, 1 << 30, 0, 4};
#define RECT(tables, light, format, normals, albedo, stride)                                                           \
    glint_tables_albedo_rect(tables, light, format, normals, 0, albedo, stride, 4, 1, &surface)
    assert_int_equal(RECT(&colour, &colour_light, int8, words, map, 0), GLINT_ERR_ARG);
    assert_int_equal(RECT(&tables, &colour_light, int8, words, map, 0), GLINT_ERR_ARG);
    assert_int_equal(RECT(&tables, &light, int8, words, NULL, 0), GLINT_ERR_ARG);
    assert_int_equal(RECT(&tables, &light, int8, words, (const uint16_t *)(const void *)((const char *)map + 1), 0),
                     GLINT_ERR_ARG);
    assert_int_equal(RECT(&tables, &light, int8, words, map, 1), GLINT_ERR_ARG);
    assert_int_equal(RECT(&tables, &light, int8, (const char *)words + 2, map, 0), GLINT_ERR_ARG);
    assert_int_equal(RECT(&tables, &light, (enum glint_normals)3, words, map, 0), GLINT_ERR_FORMAT);
    assert_int_equal(glint_tables_rect(&tables, &light, int8, words, 0, 4, 1, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_span(&tables, &span, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_albedo_span(&colour, &span, map, &surface), GLINT_ERR_ARG);
    assert_int_equal(glint_tables_albedo_span(&tables, &span, NULL, &surface), GLINT_ERR_ARG);
    static const int32_t to_light[3] = {0, 1, 1}, aside[3] = {1, 0, 4};
    assert_int_equal(glint_light_init(&shader.light, to_light, aside), GLINT_OK);
    assert_int_equal(glint_tables_light_init(&light, &tables, &shader.light), GLINT_OK);
    assert_int_equal(RECT(&tables, &light, int8, words, map, 0), GLINT_ERR_VECTOR);
    for (int i = 0; i < 4; i++)
        assert_int_equal(out[i], 7);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rectangle_and_nothing_else_is_written_at_any_alignment),
        cmocka_unit_test(swapped_pixels_are_the_others_with_their_bytes_swapped_and_may_replace_their_map),
        cmocka_unit_test(garbage_in_normals_and_spans_reads_nothing_outside_the_tables),
        cmocka_unit_test(a_run_without_surface_ends_with_the_line_whatever_it_says),
        cmocka_unit_test(what_the_tables_cannot_do_is_refused_and_nothing_is_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
