/* SPDX-License-Identifier: MIT
 * Several lights: what they may touch, what they report, what they refuse. */
#include "lamps.h"

#include "glint_lights.h"

static void parts_of_a_picture_join(void **state)
{
    (void)state;
    static struct scene a, b;
    for (int i = 0; i < 200; i++) {
        scene_init(&a, format_number(i % 4), (enum glint_space)below(2)); /* not mono, whose lines start on bytes */
        b = a;
        struct glint_lamp lamps[GLINT_LAMPS_MAX];
        random_lamps(lamps);
        assert_int_equal(glint_shade_lights(&a.shader, lamps, 4, &a.source, W, H, &a.surface, NULL), GLINT_OK);
        const unsigned left = below(W), top = below(H), pixel = bytes_of(format_number(i % 4), 1);
        for (int part = 0; part < 4; part++) {
            const unsigned x = part & 1 ? left : 0, y = part & 2 ? top : 0, at = y * W + x;
            const uint16_t w = (uint16_t)(part & 1 ? W - left : left), h = (uint16_t)(part & 2 ? H - top : top);
            const struct glint_surface surface = {b.out + LINE * (1 + y) + x * pixel, LINE, (uint16_t)(a.surface.x + x),
                                                  (uint16_t)(a.surface.y + y)};
            const struct glint_source source = {
                a.normals + at, W * sizeof *a.normals, a.albedo + 3 * at, 3 * W, a.gloss + at, W, a.mask + at, W};
            assert_int_equal(glint_shade_lights(&a.shader, lamps, 4, &source, w, h, &surface, NULL), GLINT_OK);
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
        struct glint_lamp lamps[GLINT_LAMPS_MAX];
        random_lamps(lamps);
        const unsigned count = i % 8 == 0 ? 4 : 1;
        for (int p = 0; p < W * H; p++)
            s.gloss[p] = below(40) ? 0 : 255;
        if (i % 3 == 0)
            memset(lamps[0].color_q16, 0, sizeof lamps[0].color_q16);
        struct glint_box box, one;
        assert_int_equal(glint_shade_lights(&s.shader, lamps, count, &s.source, W, H, &s.surface, &box), GLINT_OK);
        unsigned left = W, right = 0, top = H, bottom = 0;
        for (unsigned p = 0; p < W * H; p++) {
            const unsigned x = p % W, y = p / W;
            const struct glint_source source = {s.normals + p, 6, NULL, 0, s.gloss + p, 0, s.mask + p, 0};
            const struct glint_surface surface = {s.out, LINE, (uint16_t)(s.surface.x + x),
                                                  (uint16_t)(s.surface.y + y)};
            assert_int_equal(glint_shade_lights(&s.shader, lamps, count, &source, 1, 1, &surface, &one), GLINT_OK);
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

/* Where F is 2^-16 for it is half of that and a little, which the quick sequence does not see: of lobes made by hand. */
static void the_highlight_box_ends_with_the_last_pixel_that_shines_by_a_unit(void **state)
{
    (void)state;
    static const struct glint_vec l = {0, 0, 32767};
    const int32_t above[3] = {0, 0, 1};
    unsigned dim = 0, none = 0;
    for (int i = 0; i < 60; i++) {
        struct glint_shader shader = random_shader(GLINT_RGB565, GLINT_GAMMA);
        const enum glint_model model = (enum glint_model)(i % GLINT_MODEL_COUNT);
        glint_lobe_init(&shader.lobe, model == GLINT_PHONG ? GLINT_BLINN : model, 5 + below(996), 16);
        struct glint_lamp lamps[2];
        for (int k = 0; k < 2; k++)
            assert_int_equal(glint_lamp_directional(&lamps[k], above, above), GLINT_OK);
        shader.lobe.t_max_q30 = 1 << 30;
        uint32_t last = 0; /* t of the last F that is not 0 */
        for (uint32_t bit = 1 << 29; bit; bit /= 2)
            if (glint_eval_t((enum glint_model)shader.lobe.model, shader.lobe.n, last + bit))
                last += bit;
        const int32_t middle = (int32_t)sqrt(2. * last * (1 - last / 4294967296.));
        for (int32_t x = middle - 30; x < middle + 30; x++) {
            const struct glint_vec n = {(int16_t)x, 0, (int16_t)sqrt(32767. * 32767 - (double)x * x)};
            const int64_t z = n.z - l.z, t = ((int64_t)x * x + z * z) / 2;
            const uint32_t f = glint_eval_t((enum glint_model)shader.lobe.model, shader.lobe.n, (uint32_t)t);
            const struct glint_source source = {.normals = &n};
            uint16_t out;
            const struct glint_surface surface = {&out, 2, 0, 0};
            struct glint_box box;
            assert_int_equal(glint_shade_lights(&shader, lamps, 2, &source, 1, 1, &surface, &box), GLINT_OK);
            assert_int_equal(box.w, f > 0);
            dim += f == 1;
            none += f == 0;
        }
    }
    assert_true(dim > 100 && none > 100);
}

/* `most` and the slack of F of a shader under `count` lamps of this colour. */
static void assert_sums(const struct glint_shader *shader, unsigned count, uint32_t color, uint32_t most,
                        unsigned slack)
{
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    struct glint_lights lights;
    struct glint_prepared prepared;
    const int32_t above[3] = {0, 0, 1};
    for (unsigned i = 0; i < count; i++) {
        assert_int_equal(glint_lamp_directional(&lamps[i], above, above), GLINT_OK);
        for (int k = 0; k < 3; k++)
            lamps[i].color_q16[k] = color;
    }
    assert_int_equal(glint_lights_init(&lights, &prepared, shader, lamps, count), GLINT_OK);
    assert_int_equal(lights.most, most);
    assert_int_equal(prepared.slack, slack);
}

static void sums_reach_what_the_lamps_send_up_to_twice_of_one_and_f_is_low_by_as_much(void **state)
{
    (void)state;
    struct glint_shader shader = random_shader(GLINT_RGB888, GLINT_GAMMA);
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 8);
    for (int k = 0; k < 3; k++)
        shader.material.ambient_q16[k] = shader.material.diffuse_q16[k] = shader.material.specular_q16[k] = 9000;
    assert_sums(&shader, 2, 20000, 65536, 2);
    assert_sums(&shader, 2, 49152, 98304, 2);
    assert_sums(&shader, 3, 30000, 90000, 3);
    assert_sums(&shader, 4, 65536, 131072, 4);
    assert_sums(&shader, 4, 16 * 65536, 131072, 64);
    shader.space = GLINT_LINEAR;
    assert_sums(&shader, 4, 65536, 65536, 4);
}

static enum glint_err draw(const struct glint_shader *shader, const struct glint_source *source, uint16_t w, uint16_t h,
                           const struct glint_surface *surface)
{
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    random_lamps(lamps);
    return glint_shade_lights(shader, lamps, 4, source, w, h, surface, NULL);
}

static void nothing_outside_the_rectangle_is_written(void **state)
{
    (void)state;
    for (int i = 0; i < 400; i++)
        assert_draws_within(draw, format_number(i), (enum glint_space)(i & 1), (uint16_t)(i / GLINT_FORMAT_COUNT % 4),
                            (uint16_t)below(4), 65535, 65535);
}

static void lamps_at_the_limits_are_shaded_without_overflow(void **state)
{
    (void)state;
    static struct scene s;
    scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
    s.surface.x = s.surface.y = 65535;
    for (int i = 0; i < 64; i++) {
        int32_t position[3];
        struct glint_lamp lamps[2];
        for (int k = 0; k < 3; k++)
            position[k] = i >> k & 1 ? GLINT_LAMP_FAR : -GLINT_LAMP_FAR;
        const int32_t target[3] = {-position[0], -position[1], -position[2]};
        const uint32_t range = i & 8 ? (uint32_t)GLINT_LAMP_FAR : 1;
        assert_int_equal(glint_lamp_point(&lamps[0], position, range), GLINT_OK);
        assert_int_equal(glint_lamp_spot(&lamps[1], position, target, range, i & 16 ? ONE_Q30 : -ONE_Q30, -ONE_Q30),
                         GLINT_OK);
        assert_int_equal(glint_shade_lights(&s.shader, lamps, 2, &s.source, W, H, &s.surface, NULL), GLINT_OK);
    }
}

/* Shades with this lamp as the last of four; nothing may be written. */
static enum glint_err refusal(struct scene *s, const struct glint_lamp *lamp)
{
    static uint8_t before[sizeof s->out];
    struct glint_lamp lamps[GLINT_LAMPS_MAX];
    random_lamps(lamps);
    lamps[GLINT_LAMPS_MAX - 1] = *lamp;
    struct glint_box box = {9, 9, 9, 9};
    memcpy(before, s->out, sizeof before);
    const enum glint_err err = glint_shade_lights(&s->shader, lamps, 4, &s->source, W, H, &s->surface, &box);
    assert_memory_equal(s->out, before, sizeof before);
    assert_true(box.x == 9 && box.h == 9);
    return err;
}

static void wrong_lamps_are_refused_and_nothing_is_written(void **state)
{
    (void)state;
    static struct scene s, bad;
    scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
    const int32_t up[3] = {0, 0, 100}, aside[3] = {1, 2, 0};
    struct glint_lamp good, lamp;
    assert_int_equal(glint_lamp_spot(&good, up, aside, 1000, ONE_Q30, 0), GLINT_OK);
    lamp = good;
    lamp.kind = GLINT_SPOT + 1;
    assert_int_equal(refusal(&s, &lamp), GLINT_ERR_ARG);
    lamp = good;
    lamp.range = 0;
    assert_int_equal(refusal(&s, &lamp), GLINT_ERR_ARG);
    lamp = good;
    lamp.position[2] = INT32_MIN;
    assert_int_equal(refusal(&s, &lamp), GLINT_ERR_ARG);
    lamp = good;
    lamp.cos_outer_q30 = ONE_Q30 + 1;
    assert_int_equal(refusal(&s, &lamp), GLINT_ERR_ARG);
    lamp = good;
    lamp.cos_inner_q30 = -1;
    assert_int_equal(refusal(&s, &lamp), GLINT_ERR_ARG);
    bad = s;
    bad.shader.light.v = (struct glint_vec){0, 0, 0};
    assert_int_equal(refusal(&bad, &good), GLINT_ERR_VECTOR);
    bad = s;
    bad.shader.format = GLINT_FORMAT_COUNT;
    assert_int_equal(refusal(&bad, &good), GLINT_ERR_FORMAT);
    bad = s;
    bad.source.normals_stride = 7;
    assert_int_equal(refusal(&bad, &good), GLINT_ERR_ARG);
    const struct glint_lamp five[] = {good, good, good, good, good};
    assert_int_equal(glint_shade_lights(&s.shader, five, 5, &s.source, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_lights(&s.shader, NULL, 1, &s.source, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_lights(NULL, five, 1, &s.source, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_lights(&s.shader, five, 1, NULL, W, H, &s.surface, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_shade_lights(&s.shader, five, 1, &s.source, W, H, NULL, NULL), GLINT_ERR_ARG);
    for (unsigned i = 0; i < sizeof s.out; i++)
        assert_int_equal(s.out[i], GUARD);
}

static void a_viewer_is_wanted_only_where_a_lamp_has_a_place(void **state)
{
    (void)state;
    static struct scene s;
    scene_init(&s, GLINT_RGB888, GLINT_GAMMA);
    const int32_t up[3] = {0, 0, 100};
    struct glint_lamp lamp;
    assert_int_equal(glint_lamp_directional(&lamp, up, up), GLINT_OK);
    s.shader.light.v = (struct glint_vec){0, 0, 0};
    assert_int_equal(glint_shade_lights(&s.shader, &lamp, 1, &s.source, W, H, &s.surface, NULL), GLINT_OK);
    static uint8_t without[sizeof s.out]; /* two directional lamps have viewers of their own */
    const struct glint_lamp two[2] = {lamp, lamp};
    assert_int_equal(glint_shade_lights(&s.shader, two, 2, &s.source, W, H, &s.surface, NULL), GLINT_OK);
    memcpy(without, s.out, sizeof without);
    s.shader.light.v = (struct glint_vec){0, 23170, 23170};
    assert_int_equal(glint_shade_lights(&s.shader, two, 2, &s.source, W, H, &s.surface, NULL), GLINT_OK);
    assert_memory_equal(s.out, without, sizeof without);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_of_a_picture_join),
        cmocka_unit_test(the_highlight_box_is_what_single_pixels_report),
        cmocka_unit_test(the_highlight_box_ends_with_the_last_pixel_that_shines_by_a_unit),
        cmocka_unit_test(sums_reach_what_the_lamps_send_up_to_twice_of_one_and_f_is_low_by_as_much),
        cmocka_unit_test(nothing_outside_the_rectangle_is_written),
        cmocka_unit_test(lamps_at_the_limits_are_shaded_without_overflow),
        cmocka_unit_test(wrong_lamps_are_refused_and_nothing_is_written),
        cmocka_unit_test(a_viewer_is_wanted_only_where_a_lamp_has_a_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
