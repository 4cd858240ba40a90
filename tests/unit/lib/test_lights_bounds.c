/* SPDX-License-Identifier: MIT
 * Several lights: what they may touch, what they report, what they refuse. */
#include <limits.h>

#include "lamps.h"

static void parts_of_a_picture_join(void **state)
{
    (void)state;
    static struct scene a, b;
    for (int i = 0; i < 200; i++) {
        const enum glint_format format = format_number(i % WHOLE_FORMATS); /* not those whose lines start on bytes */
        scene_init(&a, format, (enum glint_space)below(2));
        scene_copy(&b, &a);
        struct glint_light lights[GLINT_LIGHTS_MAX];
        random_lights(lights);
        draw_scene_under(&a, lights, 4, NULL);
        const unsigned left = below(W), top = below(H), pixel = bytes_of(format, 1);
        for (int part = 0; part < 4; part++) {
            const unsigned x = part & 1 ? left : 0, y = part & 2 ? top : 0, at = y * W + x;
            const uint16_t w = (uint16_t)(part & 1 ? W - left : left), h = (uint16_t)(part & 2 ? H - top : top);
            const struct glint_surface surface = {b.out + LINE * (1 + y) + x * pixel, LINE, (uint16_t)(a.surface.x + x),
                                                  (uint16_t)(a.surface.y + y)};
            struct glint_maps maps = a.maps;
            maps.normals = a.normals + at;
            maps.albedo = a.albedo + 3 * at;
            maps.gloss = a.gloss + at;
            maps.coverage = a.coverage + at;
            assert_int_equal(draw_under(&a.look, lights, 4, &maps, w, h, &surface, NULL), GLINT_OK);
        }
        assert_memory_equal(a.out, b.out, sizeof a.out);
    }
}

static void the_highlight_box_is_what_single_pixels_report(void **state)
{
    (void)state;
    static struct scene s;
    int empty = 0;
    for (int i = 0; i < 200; i++) {
        scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
        struct glint_light lights[GLINT_LIGHTS_MAX];
        random_lights(lights);
        const unsigned count = i % 8 == 0 ? 4 : 1;
        for (int p = 0; p < W * H; p++)
            s.gloss[p] = below(40) ? 0 : 255;
        if (i % 3 == 0)
            memset(lights[0].color_q16, 0, sizeof lights[0].color_q16);
        struct glint_box box, one;
        draw_scene_under(&s, lights, count, &box);
        unsigned left = W, right = 0, top = H, bottom = 0;
        for (unsigned p = 0; p < W * H; p++) {
            const unsigned x = p % W, y = p / W;
            const struct glint_maps maps = {.normals = s.normals + p, .gloss = s.gloss + p, .coverage = s.coverage + p};
            const struct glint_surface surface = {s.out, LINE, (uint16_t)(s.surface.x + x),
                                                  (uint16_t)(s.surface.y + y)};
            assert_int_equal(draw_under(&s.look, lights, count, &maps, 1, 1, &surface, &one), GLINT_OK);
            if (!one.w)
                continue;
            left = x < left ? x : left;
            right = x + 1 > right ? x + 1 : right;
            top = y < top ? y : top;
            bottom = y + 1;
        }
        empty += right == 0;
        if (right == 0)
            left = top = 0;
        assert_true(box.x == left && box.y == top && box.w == right - left && box.h == bottom - top);
    }
    assert_in_range(empty, 10, 190);
}

/* Where F is a unit, of 2^-16, the quick sequence may see none: the last normal on a great circle from H that shines, and those about it. */
static void the_highlight_box_ends_with_the_last_pixel_that_shines_by_a_unit(void **state)
{
    (void)state;
    unsigned dim = 0, none = 0;
    for (int i = 0; i < 60; i++) {
        struct look look = random_look(GLINT_RGB565, GLINT_GAMMA);
        const enum glint_model model = (enum glint_model)(i % GLINT_MODEL_COUNT);
        set_model(&look, model == GLINT_PHONG ? GLINT_BLINN : model, (uint16_t)(5 + below(996)), 16);
        assert_int_equal(look_light(&look, in_front, in_front), GLINT_OK);
        const struct glint_light lights[2] = {look.light, look.light};
        const uint32_t last = last_t_of(&look);
        const int32_t middle = (int32_t)sqrt(2. * last * (1 - last / 4294967296.));
        for (int32_t x = middle - 30; x < middle + 30; x++) {
            const double rest = 32767. * 32767 - (double)x * x;
            const struct glint_vec n = {(int16_t)x, 0, (int16_t)sqrt(fmax(rest, 0))};
            uint32_t nl;
            const uint32_t f = lobe_at(&look, n, &nl);
            const struct glint_maps maps = {.normals = &n};
            uint16_t out;
            const struct glint_surface surface = {&out, 2, 0, 0};
            struct glint_box box;
            assert_int_equal(draw_under(&look, lights, 2, &maps, 1, 1, &surface, &box), GLINT_OK);
            assert_int_equal(box.w, f > 0);
            dim += f == 1;
            none += f == 0;
        }
    }
    assert_true(dim > 100 && none > 100);
}

/* What the paint of `count` lights of this colour takes: the most that a sum may be, and the slack of F. */
static void assert_sums(const struct look *look, unsigned count, uint32_t color, uint32_t most, unsigned slack)
{
    struct glint_light lights[GLINT_LIGHTS_MAX];
    struct glint_paint paint;
    assert_int_equal(glint_paint_exact(&paint, &look->material, &look->output), GLINT_OK);
    for (unsigned i = 0; i < count; i++) {
        assert_int_equal(glint_light_directional(&lights[i], in_front), GLINT_OK);
        for (int k = 0; k < 3; k++)
            lights[i].color_q16[k] = color;
    }
    assert_int_equal(glint_paint_light(&paint, lights, count, in_front), GLINT_OK);
    const uint32_t nl = paint.of.exact.most << paint.of.exact.nl_down;
    assert_in_range(nl, most, most + (1u << paint.of.exact.nl_down) - 1);
    assert_int_equal(paint.of.exact.slack, paint.of.exact.f_down ? (slack >> paint.of.exact.f_down) + 2 : slack);
}

/* In units of 2^-16: twice what a white light sends, or all that the lights do where the material is dark enough for it. */
static void sums_reach_what_the_lights_send_and_f_is_low_by_as_much(void **state)
{
    (void)state;
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    set_model(&look, GLINT_MSH, 60, 8);
    for (int k = 0; k < 3; k++) {
        look.material.ambient_q16[k] = 9000;
        look.material.diffuse_q16[k] = look.material.specular_q16[k] = 40000;
    }
    assert_sums(&look, 2, 20000, 65536, 2);
    assert_sums(&look, 2, 49152, 98304, 2);
    assert_sums(&look, 3, 30000, 90000, 3);
    for (int k = 0; k < 3; k++) /* 1 / 16 */
        look.material.diffuse_q16[k] = look.material.specular_q16[k] = 4096;
    assert_sums(&look, 4, 65536, 4 * 65536, 4);
    assert_sums(&look, 4, 4 * 65536, 16 * 65536, 16);
}

static enum glint_err draw(const struct look *look, const struct glint_maps *maps, uint16_t w, uint16_t h,
                           const struct glint_surface *surface)
{
    struct glint_light lights[GLINT_LIGHTS_MAX];
    random_lights(lights);
    return draw_under(look, lights, 4, maps, w, h, surface, NULL);
}

static void nothing_outside_the_rectangle_is_written(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++)
        assert_draws_within(draw, format_number(i), (enum glint_space)(i & 1), (uint16_t)(i / GLINT_FORMAT_COUNT % 4),
                            (uint16_t)below(4), 65535, 65535);
}

static void lights_at_the_limits_are_drawn_without_overflow(void **state)
{
    (void)state;
    static struct scene s;
    scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
    s.surface.x = s.surface.y = 65535;
    for (int i = 0; i < 64; i++) {
        int32_t position[3];
        struct glint_light lights[2];
        for (int k = 0; k < 3; k++)
            position[k] = i >> k & 1 ? GLINT_LIGHT_FAR : -GLINT_LIGHT_FAR;
        const int32_t target[3] = {-position[0], -position[1], -position[2]};
        const uint32_t range = i & 8 ? (uint32_t)GLINT_LIGHT_FAR : 1;
        assert_int_equal(glint_light_point(&lights[0], position, range), GLINT_OK);
        assert_int_equal(glint_light_spot(&lights[1], position, target, range, i & 16 ? ONE_Q30 : -ONE_Q30, -ONE_Q30),
                         GLINT_OK);
        for (int k = 0; k < 3; k++)
            lights[i & 1].color_q16[k] = UINT32_MAX;
        draw_scene_under(&s, lights, 2, NULL);
    }
}

/* ---- What a paint is lit by, and keeps ---- */

/* The scene by the paint, lit. */
static const uint8_t *drawn_by(struct scene *s, const struct glint_paint *paint, struct glint_box *box)
{
    memset(s->out, GUARD, sizeof s->out);
    assert_int_equal(glint_draw_rect(paint, &s->maps, W, H, &s->surface, box), GLINT_OK);
    return s->out;
}

static void after_an_error_a_paint_keeps_its_light(void **state)
{
    (void)state;
    static struct scene s;
    static uint8_t before[sizeof s.out];
    static const int32_t zero[3] = {0, 0, 0}, behind[3] = {0, 0, -1}, up[3] = {0, 0, 100}, aside[3] = {1, 2, 0};
    struct glint_light good, bad[12];
    assert_int_equal(glint_light_spot(&good, up, aside, 1000, ONE_Q30, 0), GLINT_OK);
    for (unsigned i = 0; i < 12; i++)
        bad[i] = good;
    memset(&bad[0], 0, sizeof bad[0]);
    bad[1].range = 0;
    bad[2].range = GLINT_LIGHT_FAR + 1;
    bad[3].position[0] = INT32_MIN;
    bad[4].position[1] = GLINT_LIGHT_FAR + 1;
    bad[5].position[2] = -GLINT_LIGHT_FAR - 1;
    bad[6].cos_outer_q30 = ONE_Q30 + 1;
    bad[7].cos_inner_q30 = -1;
    bad[8].cos_outer_q30 = -ONE_Q30 - 1;
    bad[9].cos_inner_q30 = ONE_Q30 + 1;
    assert_int_equal(glint_light_directional(&bad[10], up), GLINT_OK);
    bad[10].direction_q30[0] = bad[10].direction_q30[1] = ONE_Q30; /* 1.7 long */
    assert_int_equal(glint_light_directional(&bad[11], up), GLINT_OK);
    bad[11].direction_q30[2] = INT32_MIN;
    for (int kind = 0; kind < 3; kind++) { /* lit by one, by none, by several */
        scene_init(&s, format_number(kind), (enum glint_space)(kind & 1));
        struct glint_light lights[GLINT_LIGHTS_MAX], five[5];
        struct glint_box box, after;
        struct glint_paint paint;
        random_lights(lights);
        assert_int_equal(glint_paint_exact(&paint, &s.look.material, &s.look.output), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint,
                                           kind == 1   ? NULL
                                           : kind == 0 ? &s.look.light
                                                       : lights,
                                           kind == 1   ? 0
                                           : kind == 0 ? 1
                                                       : 4,
                                           s.look.to_viewer),
                         GLINT_OK);
        memcpy(before, drawn_by(&s, &paint, &box), sizeof before);
        for (unsigned i = 0; i < 12; i++)
            for (unsigned count = 1; count <= 4; count++) {
                for (unsigned k = 0; k < 5; k++)
                    five[k] = good;
                five[below(count)] = bad[i];
                assert_int_equal(glint_paint_light(&paint, five, count, in_front), GLINT_ERR_ARG);
                assert_memory_equal(drawn_by(&s, &paint, &after), before, sizeof before);
                assert_true(same_box(&box, &after));
            }
        for (unsigned k = 0; k < 5; k++)
            five[k] = good;
        assert_int_equal(glint_paint_light(&paint, five, 5, in_front), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_light(&paint, five, UINT_MAX, in_front), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_light(&paint, NULL, 1, in_front), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_light(&paint, five, 1, NULL), GLINT_ERR_ARG);
        assert_int_equal(glint_paint_light(&paint, five, 1, zero), GLINT_ERR_VECTOR);
        assert_int_equal(glint_paint_light(&paint, NULL, 0, zero), GLINT_ERR_VECTOR);
        assert_int_equal(glint_paint_light(&paint, &s.look.light, 1, zero), GLINT_ERR_VECTOR);
        assert_int_equal(glint_light_directional(&five[0], behind), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, five, 1, in_front), GLINT_ERR_VECTOR);
        assert_int_equal(glint_paint_light(&paint, five, 3, in_front), GLINT_ERR_VECTOR);
        assert_int_equal(glint_light_directional(&five[1], up), GLINT_OK);
        five[2] = five[1]; /* two, and nothing named that sums them */
        assert_int_equal(glint_paint_light_by(&paint, five + 1, 2, in_front, NULL), GLINT_ERR_ARG);
        assert_memory_equal(drawn_by(&s, &paint, &after), before, sizeof before);
        assert_true(same_box(&box, &after));
    }
    struct glint_paint none = {0};
    assert_int_equal(glint_paint_light(&none, &good, 1, in_front), GLINT_ERR_ARG);
    assert_int_equal(glint_paint_light(NULL, &good, 1, in_front), GLINT_ERR_ARG);
}

/* Whatever lit it before: one light, white or not, several, none. */
static void a_paint_that_is_lit_again_draws_what_a_new_one_does(void **state)
{
    (void)state;
    static struct scene a, b;
    static struct glint_light kept[4][GLINT_LIGHTS_MAX];
    for (int i = 0; i < 150; i++) {
        scene_init(&a, format_number(i), (enum glint_space)below(2));
        scene_copy(&b, &a);
        struct glint_paint paint;
        assert_int_equal(glint_paint_exact(&paint, &a.look.material, &a.look.output), GLINT_OK);
        for (int turn = 0; turn < 6; turn++) {
            struct glint_light *const lights = kept[turn % 4];
            struct glint_box box_a, box_b;
            const unsigned count = below(GLINT_LIGHTS_MAX + 1);
            const int32_t to_viewer[3] = {within(9), within(9), 20};
            random_lights(lights);
            if (below(2)) {
                lights[0] = a.look.light;
                for (int k = 0; k < 3; k++)
                    lights[0].color_q16[k] = below(3) ? 65536 : below(1 << 20);
            }
            memcpy(b.look.to_viewer, to_viewer, sizeof to_viewer);
            memset(b.out, GUARD, sizeof b.out);
            assert_int_equal(glint_paint_light(&paint, lights, count, to_viewer), GLINT_OK);
            draw_scene_under(&b, lights, count, &box_b);
            assert_memory_equal(drawn_by(&a, &paint, &box_a), b.out, sizeof b.out);
            assert_true(same_box(&box_a, &box_b));
        }
    }
}

/* The one directional light is copied; the viewer's direction has any length. */
static void one_directional_light_may_go_and_the_viewer_s_distance_does_not_matter(void **state)
{
    (void)state;
    static struct scene a, b;
    static const int32_t lengths[] = {1, 3, 1000, 1 << 28};
    for (int i = 0; i < 100; i++) {
        scene_init(&a, format_number(i), GLINT_GAMMA);
        scene_copy(&b, &a);
        const int32_t times = lengths[below(4)], to_viewer[3] = {0, 0, times};
        struct glint_light light = a.look.light;
        struct glint_paint paint;
        for (int k = 0; k < 3; k++)
            light.color_q16[k] = a.look.light.color_q16[k] = b.look.light.color_q16[k] = below(1 << 18);
        assert_int_equal(glint_paint_exact(&paint, &a.look.material, &a.look.output), GLINT_OK);
        assert_int_equal(glint_paint_light(&paint, &light, 1, to_viewer), GLINT_OK);
        memset(&light, GUARD, sizeof light);
        assert_int_equal(draw_scene(&b, NULL), GLINT_OK);
        assert_memory_equal(drawn_by(&a, &paint, NULL), b.out, sizeof b.out);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_of_a_picture_join),
        cmocka_unit_test(the_highlight_box_is_what_single_pixels_report),
        cmocka_unit_test(the_highlight_box_ends_with_the_last_pixel_that_shines_by_a_unit),
        cmocka_unit_test(sums_reach_what_the_lights_send_and_f_is_low_by_as_much),
        cmocka_unit_test(nothing_outside_the_rectangle_is_written),
        cmocka_unit_test(lights_at_the_limits_are_drawn_without_overflow),
        cmocka_unit_test(after_an_error_a_paint_keeps_its_light),
        cmocka_unit_test(a_paint_that_is_lit_again_draws_what_a_new_one_does),
        cmocka_unit_test(one_directional_light_may_go_and_the_viewer_s_distance_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
