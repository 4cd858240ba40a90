/* SPDX-License-Identifier: MIT
 * Rectangles by the exact paint: what they may touch, what they report, what they refuse. */
#include "shading.h"

static enum glint_err draw(const struct look *look, const struct glint_maps *maps, uint16_t w, uint16_t h,
                           const struct glint_surface *surface)
{
    return draw_rect(look, maps, w, h, surface, NULL);
}

static void nothing_outside_the_rectangle_is_written(void **state)
{
    (void)state;
    static const uint16_t widths[] = {0, 1, 2, 3, 319};
    for (int i = 0; i < 400; i++)
        assert_draws_within(draw, format_number(i), (enum glint_space)(i & 1), widths[i / GLINT_FORMAT_COUNT % 5],
                            (uint16_t)below(4), 3, 1);
}

static void the_highlight_box_is_the_smallest_that_holds_the_highlight(void **state)
{
    (void)state;
    static struct scene s;
    int empty = 0;
    for (int i = 0; i < 400; i++) {
        scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
        if (i & 1) /* sparse */
            for (int p = 0; p < W * H; p++)
                s.gloss[p] = below(60) ? 0 : 255;
        struct glint_box box;
        assert_int_equal(draw_scene(&s, &box), GLINT_OK);
        unsigned left = W, right = 0, top = H, bottom = 0;
        for (unsigned p = 0; p < W * H; p++) {
            uint32_t nl;
            if (!s.coverage[p] || !s.gloss[p] || !lobe_at(&s.look, s.normals[p], &nl))
                continue;
            left = p % W < left ? p % W : left;
            right = p % W + 1 > right ? p % W + 1 : right;
            top = p / W < top ? p / W : top;
            bottom = p / W + 1;
        }
        if (right == 0) {
            empty++;
            assert_true(box.x == 0 && box.y == 0 && box.w == 0 && box.h == 0);
        } else {
            assert_true(box.x == left && box.y == top && box.w == right - left && box.h == bottom - top);
        }
    }
    assert_true(empty > 0);
}

static void albedo_may_be_the_output_and_gloss_the_grey_output(void **state)
{
    (void)state;
    static struct scene s;
    static uint8_t apart[3 * W * H];
    for (int i = 0; i < 100; i++) {
        const bool grey = i & 1;
        scene_init(&s, grey ? GLINT_GREY8 : GLINT_RGB888, GLINT_GAMMA);
        s.surface = (struct glint_surface){apart, grey ? W : 3 * W, 0, 0};
        s.maps.coverage = NULL;
        struct glint_box box_apart, box;
        for (int p = 0; p < W * H; p++) /* without light it turns to 0, without gloss to something else */
            s.gloss[p] = below(4) ? s.gloss[p] : 0;
        assert_int_equal(draw_scene(&s, &box_apart), GLINT_OK);
        s.surface.pixels = grey ? s.gloss : s.albedo;
        assert_int_equal(draw_scene(&s, &box), GLINT_OK);
        assert_memory_equal(s.surface.pixels, apart, grey ? W * H : 3 * W * H);
        assert_true(same_box(&box, &box_apart));
    }
}

/* Of one line a stride says nothing, and nothing is drawn of none. */
static void a_stride_is_looked_at_where_there_are_two_lines(void **state)
{
    (void)state;
    static struct scene s, bad;
    struct glint_paint paint;
    struct glint_box box = {9, 9, 9, 9};
    scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
    paint_of(&paint, &s.look);
    for (int which = 0; which < 5; which++)
        for (int sign = -1; sign <= 1; sign += 2)
            for (int less = 0; less < 3; less++) {
                bad = s;
                ptrdiff_t *const stride = which == 0   ? &bad.surface.stride
                                          : which == 1 ? &bad.maps.normals_stride
                                          : which == 2 ? &bad.maps.albedo_stride
                                          : which == 3 ? &bad.maps.gloss_stride
                                                       : &bad.maps.coverage_stride;
                const ptrdiff_t line = which == 1 ? 6 * W : which == 0 || which == 2 ? 3 * W : W;
                *stride = less == 2 ? 0 : sign * (line - less * (which == 1 ? 2 : 1));
                if (sign < 0 && less == 0) { /* from the bottom, or the maps' last line */
                    bad.surface.pixels = which == 0 ? s.out + LINE + 3 * W : s.out + LINE;
                    bad.maps.normals = which == 1 ? s.normals + W : s.normals;
                    bad.maps.albedo = which == 2 ? s.albedo + 3 * W : s.albedo;
                    bad.maps.gloss = which == 3 ? s.gloss + W : s.gloss;
                    bad.maps.coverage = which == 4 ? s.coverage + W : s.coverage;
                }
                memset(s.out, GUARD, sizeof s.out);
                assert_int_equal(glint_draw_rect(&paint, &bad.maps, W, 2, &bad.surface, &box),
                                 less ? GLINT_ERR_ARG : GLINT_OK);
                for (size_t i = 0; less && i < sizeof s.out; i++)
                    assert_int_equal(s.out[i], GUARD);
                *stride = 0;
                assert_int_equal(glint_draw_rect(&paint, &bad.maps, W, 1, &bad.surface, NULL), GLINT_OK);
            }
}

static void wrong_arguments_are_refused_and_nothing_is_written(void **state)
{
    (void)state;
    static struct scene s, bad;
    struct glint_paint paint, none = {0};
    scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
    paint_of(&paint, &s.look);
    struct glint_box box = {9, 9, 9, 9};
#define DRAW(paint, maps, surface) glint_draw_rect(paint, maps, W, H, surface, &box)
    assert_int_equal(DRAW(NULL, &s.maps, &s.surface), GLINT_ERR_ARG);
    assert_int_equal(DRAW(&paint, NULL, &s.surface), GLINT_ERR_ARG);
    assert_int_equal(DRAW(&paint, &s.maps, NULL), GLINT_ERR_ARG);
    assert_int_equal(DRAW(&none, &s.maps, &s.surface), GLINT_ERR_ARG);
    bad = s;
    bad.maps.normals = NULL;
    assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_ARG);
    bad = s;
    bad.maps.normals_stride = 6 * W + 1;
    assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_ARG);
    bad = s;
    bad.maps.normals = (const struct glint_vec *)((uintptr_t)s.normals + 1);
    assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_ARG);
    bad.maps.normals = (const struct glint_vec *)((uintptr_t)s.normals + 2);
    bad.maps.normals_format = GLINT_NORMALS_INT8;
    assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_ARG);
    bad.maps.normals = s.normals;
    bad.maps.normals_stride = 4 * W + 2;
    assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_ARG);
    bad = s;
    bad.surface.pixels = NULL;
    assert_int_equal(DRAW(&paint, &s.maps, &bad.surface), GLINT_ERR_ARG);
    bad = s;
    bad.maps.grain = s.gloss;
    bad.maps.grain_stride = W - 1;
    assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_ARG);
    bad = s;
    bad.maps.normals_format = GLINT_NORMALS_INT8 + 1;
    assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_FORMAT);
    for (unsigned format = 0; format <= GLINT_FORMAT_COUNT; format++) {
        bad = s;
        bad.maps.albedo_format = (uint8_t)format; /* 0, as it is where nobody sets it, too */
        if (format != GLINT_RGB888)
            assert_int_equal(DRAW(&paint, &bad.maps, &s.surface), GLINT_ERR_FORMAT);
        bad.maps.albedo = NULL; /* of a map that is not there it is not looked at */
        assert_int_equal(glint_draw_rect(&paint, &bad.maps, 0, H, &s.surface, NULL), GLINT_OK);
    }
#undef DRAW
    assert_true(box.x == 9 && box.y == 9 && box.w == 9 && box.h == 9);
    for (size_t i = 0; i < sizeof s.out; i++)
        assert_int_equal(s.out[i], GUARD);
    assert_int_equal(glint_draw_rect(&paint, &s.maps, 0, H, &s.surface, &box), GLINT_OK);
    assert_int_equal(box.w, 0);
    box.w = 9;
    assert_int_equal(glint_draw_rect(&paint, &s.maps, W, 0, &s.surface, &box), GLINT_OK);
    assert_int_equal(box.w, 0);
    for (size_t i = 0; i < sizeof s.out; i++)
        assert_int_equal(s.out[i], GUARD);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_outside_the_rectangle_is_written),
        cmocka_unit_test(the_highlight_box_is_the_smallest_that_holds_the_highlight),
        cmocka_unit_test(albedo_may_be_the_output_and_gloss_the_grey_output),
        cmocka_unit_test(a_stride_is_looked_at_where_there_are_two_lines),
        cmocka_unit_test(wrong_arguments_are_refused_and_nothing_is_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
