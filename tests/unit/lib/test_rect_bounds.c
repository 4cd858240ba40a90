/* SPDX-License-Identifier: MIT
 * The exact rectangle and span: what they may touch, what they report, what they refuse. */
#include "shading.h"

static enum glint_err draw(const struct glint_shader *shader, const struct glint_source *source, uint16_t w, uint16_t h,
                           const struct glint_surface *surface)
{
    return glint_shade_rect(shader, source, w, h, surface, NULL);
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
        assert_int_equal(glint_shade_rect(&s.shader, &s.source, W, H, &s.surface, &box), GLINT_OK);
        unsigned left = W, right = 0, top = H, bottom = 0;
        for (unsigned p = 0; p < W * H; p++) {
            uint32_t nl;
            if (!s.mask[p] || !s.gloss[p] || !lobe_at(&s.shader, s.normals[p], &nl))
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
        s.source.mask = NULL;
        struct glint_box box_apart, box;
        for (int p = 0; p < W * H; p++) /* without light it turns to 0, without gloss to something else */
            s.gloss[p] = below(4) ? s.gloss[p] : 0;
        assert_int_equal(glint_shade_rect(&s.shader, &s.source, W, H, &s.surface, &box_apart), GLINT_OK);
        s.surface.pixels = grey ? s.gloss : s.albedo;
        assert_int_equal(glint_shade_rect(&s.shader, &s.source, W, H, &s.surface, &box), GLINT_OK);
        assert_memory_equal(s.surface.pixels, apart, grey ? W * H : 3 * W * H);
        assert_true(box.x == box_apart.x && box.y == box_apart.y && box.w == box_apart.w && box.h == box_apart.h);
    }
}

static void wrong_arguments_are_refused_and_nothing_is_written(void **state)
{
    (void)state;
    static struct scene s, bad;
    scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
    const uint8_t untouched[3] = {GUARD, GUARD, GUARD};
    struct glint_span span = {0, 0, 0, 0, 0, 1};
    assert_int_equal(glint_shade_rect(NULL, &s.source, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_rect(&s.shader, NULL, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_rect(&s.shader, &s.source, W, H, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span(NULL, &span, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span(&s.shader, NULL, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span(&s.shader, &span, NULL, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span_c16(&s.shader, NULL, &s.surface, NULL), GLINT_ERR_ARG);
    bad = s;
    bad.source.normals = NULL;
    assert_int_equal(glint_shade_rect(&s.shader, &bad.source, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    bad = s;
    bad.source.normals_stride = 7;
    assert_int_equal(glint_shade_rect(&s.shader, &bad.source, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    bad.source.normals_stride = 6;
    bad.source.normals = (const struct glint_vec *)((uintptr_t)s.normals + 1);
    assert_int_equal(glint_shade_rect(&s.shader, &bad.source, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    bad = s;
    bad.surface.pixels = NULL;
    assert_int_equal(glint_shade_rect(&s.shader, &s.source, W, H, &bad.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_span(&s.shader, &span, &bad.surface, NULL), GLINT_ERR_ARG);
    bad = s;
    bad.shader.format = GLINT_FORMAT_COUNT;
    assert_int_equal(glint_shade_rect(&bad.shader, &s.source, W, H, &s.surface, NULL), GLINT_ERR_FORMAT);
    assert_int_equal(glint_shade_span(&bad.shader, &span, &s.surface, NULL), GLINT_ERR_FORMAT);
    bad = s;
    bad.shader.space = GLINT_LINEAR + 1;
    assert_int_equal(glint_shade_rect(&bad.shader, &s.source, W, H, &s.surface, NULL), GLINT_ERR_FORMAT);
    assert_memory_equal(s.surface.pixels, untouched, 3);
    struct glint_box box = {9, 9, 9, 9};
    assert_int_equal(glint_shade_rect(&s.shader, &s.source, 0, H, &s.surface, &box), GLINT_OK);
    assert_int_equal(box.w, 0);
    assert_memory_equal(s.surface.pixels, untouched, 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_outside_the_rectangle_is_written),
        cmocka_unit_test(the_highlight_box_is_the_smallest_that_holds_the_highlight),
        cmocka_unit_test(albedo_may_be_the_output_and_gloss_the_grey_output),
        cmocka_unit_test(wrong_arguments_are_refused_and_nothing_is_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
