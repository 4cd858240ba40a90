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
    enum { WHOLE = 320, HIGH = 4 };
    static struct glint_vec normals[WHOLE * HIGH];
    static uint32_t words[WHOLE * HIGH];
    static uint16_t albedo[WHOLE * HIGH], whole[WHOLE * HIGH];
    for (int i = 0; i < 200; i++) {
        const struct look look = grey_look((uint16_t)(1 + below(100)), (enum glint_format)below(2));
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
        const enum glint_normals format = (enum glint_normals)below(2);
        for (int p = 0; p < WHOLE * HIGH; p++) {
            normals[p] = random_normal(&look);
            words[p] = glint_normals_pack(format, &normals[p]);
            albedo[p] = (uint16_t)below(65536);
        }
        const void *first = format == GLINT_NORMALS_INT8 ? (const void *)words : normals;
        struct glint_maps maps = maps_over(format, first, albedo, WHOLE);
        memset(whole, GUARD, sizeof whole);
        const struct glint_surface full = {whole, 2 * WHOLE, 0, 0};
        assert_int_equal(glint_draw_rect(&paint, &maps, WHOLE, HIGH, &full, NULL), GLINT_OK);
        const uint16_t w = widths[below(9)], h = (uint16_t)below(HIGH + 1), x = (uint16_t)below(WHOLE - w);
        const size_t line = 2 * w + below(5), room = (line + 8) * HIGH;
        const uint32_t start = below(8);
        uint8_t *out = malloc(room);
        assert_non_null(out);
        memset(out, GUARD, room);
        const struct glint_surface surface = {out + start, (ptrdiff_t)line, 0, 0};
        maps.normals = glint_normals_window(format, first, maps.normals_stride, x, 0);
        maps.albedo = (const uint8_t *)(albedo + x);
        assert_int_equal(glint_draw_rect(&paint, &maps, w, h, &surface, NULL), GLINT_OK);
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
    for (int format = 0; format < 2; format++) {
        for (int p = 0; p < COUNT; p++)
            albedo[p] = (uint16_t)below(65536);
        for (int order = 0; order < 2; order++) {
            const struct look look = grey_look(20, (enum glint_format)order);
            struct glint_paint paint;
            paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
            for (int p = 0; p < COUNT && order == 0; p++) {
                do
                    normals[p] = random_normal(&look);
                while (normals[p].z < 500);
                words[p] = glint_normals_pack((enum glint_normals)format, &normals[p]);
            }
            const void *held = format == GLINT_NORMALS_INT8 ? (const void *)words : normals;
            memcpy(place, albedo, sizeof place);
            const struct glint_surface to_out = {out[order], 0, 0, 0}, to_place = {place, 0, 0, 0};
            const struct glint_maps apart = maps_over((enum glint_normals)format, held, albedo, COUNT),
                                    same = maps_over((enum glint_normals)format, held, place, COUNT);
            struct glint_box box, box_same; /* by a second look at the normals, not at the map */
            assert_int_equal(glint_draw_rect(&paint, &apart, COUNT, 1, &to_out, &box), GLINT_OK);
            assert_int_equal(glint_draw_rect(&paint, &same, COUNT, 1, &to_place, &box_same), GLINT_OK);
            assert_memory_equal(place, out[order], sizeof place);
            assert_true(same_box(&box, &box_same));
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
        struct look look = tables_look(GLINT_RGB565);
        make_grey(&look, 6000, 58000);
        look.material.specular_q16[0] = below(4) ? 65536 : 0;
        look.material.specular_q16[1] = look.material.specular_q16[2] = below(3) ? 65536 : 0;
        if (i % 3) /* as near to straight behind as it may be */
            (void)look_light(&look, (const int32_t[]){(int32_t)below(9), (int32_t)below(9), -(1 << below(29))},
                             in_front);
        struct glint_paint paint;
        paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, tight);
        uint32_t words[300];
        uint16_t albedo[150], out[150];
        for (int k = 0; k < 300; k++)
            words[k] = below(UINT32_MAX);
        memset(albedo, 0xff, sizeof albedo);
        const struct glint_surface surface = {out, 0, 0, 0};
        for (int format = 0; format < 2; format++) {
            const struct glint_maps maps = maps_over((enum glint_normals)format, words, albedo, 100);
            assert_int_equal(glint_draw_rect(&paint, &maps, 100, 1, &surface, NULL), GLINT_OK);
        }
        const struct glint_span span = {words[0],          words[1], words[2],        (int32_t)words[3],
                                        (int32_t)words[4], 150,      {{0, 0}, {0, 0}}};
        const struct glint_maps maps = {.albedo = (const uint8_t *)albedo, .albedo_format = GLINT_RGB565};
        assert_int_equal(glint_draw_span(&paint, &span, &maps, &surface, NULL), GLINT_OK);
    }
    free(tight);
}

static void a_run_without_surface_ends_with_the_line_whatever_it_says(void **state)
{
    (void)state;
    const struct look look = grey_look(60, GLINT_RGB565);
    struct glint_paint paint;
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    static const struct glint_vec up = {0, 0, 32767};
    uint32_t words[20];
    uint16_t albedo[20], out[21];
    for (int from = 0; from < 18; from++) {
        for (int i = 0; i < 20; i++) {
            words[i] = glint_normals_pack(GLINT_NORMALS_INT8, &up);
            albedo[i] = 0xffff;
        }
        words[from] = 2;
        words[from + 1] = 1;
        words[19] = 60000;
        memset(out, GUARD, sizeof out);
        const uint16_t left = out[0];
        const struct glint_surface surface = {out, 0, 0, 0};
        const struct glint_maps maps = maps_over(GLINT_NORMALS_INT8, words, albedo, 20);
        assert_int_equal(glint_draw_rect(&paint, &maps, 20, 1, &surface, NULL), GLINT_OK);
        for (int i = 0; i < 21; i++)
            assert_int_equal(out[i] == left, i == from || i == from + 1 || i >= 19);
    }
}

/* ---- What is refused ---- */

static void what_the_tables_cannot_be_filled_for_is_refused_and_nothing_is_written(void **state)
{
    (void)state;
    struct glint_paint paint, before;
    uint32_t guard[GLINT_TABLES_ALBEDO_BYTES / 4];
    memset(guard, GUARD, sizeof guard);
    memset(&paint, GUARD, sizeof paint);
    before = paint;
    assert_int_equal(glint_tables_bytes(GLINT_TABLES_ALBEDO, false), sizeof guard);
    assert_int_equal(glint_tables_bytes(GLINT_TABLES_ALBEDO, true), 0);
#define FILL(look, memory, bytes)                                                                                      \
    glint_paint_tables(&paint, GLINT_TABLES_ALBEDO, &(look).material, &(look).output, memory, bytes)
    struct look look = grey_look(60, GLINT_RGB565);
    assert_int_equal(FILL(look, guard, sizeof guard - 1), GLINT_ERR_ARG);
    assert_int_equal(FILL(look, (char *)guard + 2, sizeof guard), GLINT_ERR_ARG);
    look.material.diffuse_q16[2]++;
    assert_int_equal(FILL(look, guard, sizeof guard), GLINT_ERR_ARG);
    look.material.diffuse_q16[2]--;
    look.material.ambient_q16[1]++;
    assert_int_equal(FILL(look, guard, sizeof guard), GLINT_ERR_ARG);
    make_grey(&look, 65536 - 58000 + 1, 58000); /* more than 1 in all */
    assert_int_equal(FILL(look, guard, sizeof guard), GLINT_ERR_ARG);
    look = grey_look(60, GLINT_RGB888);
    assert_int_equal(FILL(look, guard, sizeof guard), GLINT_ERR_FORMAT);
    look = grey_look(60, GLINT_RGB565);
    look.output.dither = true;
    assert_int_equal(FILL(look, guard, sizeof guard), GLINT_ERR_FORMAT);
    look.output.dither = false;
    look.output.space = GLINT_LINEAR;
    assert_int_equal(FILL(look, guard, sizeof guard), GLINT_ERR_FORMAT);
#undef FILL
    for (size_t i = 0; i < sizeof guard / 4; i++)
        assert_int_equal(guard[i], GUARD * 0x01010101u);
    assert_memory_equal(&paint, &before, sizeof paint);
}

static void what_the_tables_cannot_draw_is_refused_and_nothing_is_written(void **state)
{
    (void)state;
    struct look look = grey_look(60, GLINT_RGB565);
    struct glint_paint paint;
    uint16_t out[4] = {7, 7, 7, 7};
    const struct glint_surface surface = {out, 8, 0, 0};
    static const uint32_t words[4] = {1u << 30, 1u << 30, 1u << 30, 1u << 30};
    static const uint16_t map[4] = {0, 0, 0, 0};
    const struct glint_span span = {0, 0, 0, 1 << 30, 0, 2, {{0, 0}, {0, 0}}};
    const struct glint_maps good = maps_over(GLINT_NORMALS_INT8, words, map, 2);
    paint_of_tables(&paint, GLINT_TABLES_ALBEDO, &look, memory);
    paint.of.tables.filled.use = &glint_use_albedo;
    for (int i = 0; i < 8; i++) {
        static const enum glint_err wanted[8] = {GLINT_ERR_ARG, GLINT_ERR_ARG,    GLINT_ERR_ARG, GLINT_ERR_ARG,
                                                 GLINT_ERR_ARG, GLINT_ERR_FORMAT, GLINT_ERR_ARG, GLINT_ERR_ARG};
        struct glint_maps maps = good;
        if (i == 0)
            maps.albedo = NULL;
        else if (i == 1)
            maps.albedo = (const uint8_t *)map + 1;
        else if (i == 2)
            maps.albedo_stride = 3;
        else if (i == 3)
            maps.albedo_stride = 5;
        else if (i == 4)
            maps.normals = (const char *)words + 2;
        else if (i == 5)
            maps.albedo_format = GLINT_RGB888, maps.albedo_stride = 6;
        else if (i == 6)
            maps.gloss = (const uint8_t *)map, maps.gloss_stride = 2;
        else
            maps.grain = (const uint8_t *)map, maps.grain_stride = 2;
        assert_int_equal(glint_draw_rect(&paint, &maps, 2, 2, &surface, NULL), wanted[i]);
        if (i != 2 && i != 3 && i != 4) /* of one line */
            assert_int_equal(glint_draw_span(&paint, &span, &maps, &surface, NULL), wanted[i]);
    }
    assert_int_equal(glint_draw_span(&paint, &span, NULL, &surface, NULL), GLINT_ERR_ARG); /* albedo is needed */
    static const int32_t to_light[3] = {0, 1, 1}, aside[3] = {1, 0, 4};
    assert_int_equal(look_light(&look, to_light, aside), GLINT_OK);
    assert_int_equal(glint_paint_light(&paint, &look.light, 1, aside), GLINT_OK);
    assert_int_equal(glint_draw_rect(&paint, &good, 2, 2, &surface, NULL), GLINT_ERR_VECTOR);
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
        cmocka_unit_test(what_the_tables_cannot_be_filled_for_is_refused_and_nothing_is_written),
        cmocka_unit_test(what_the_tables_cannot_draw_is_refused_and_nothing_is_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
