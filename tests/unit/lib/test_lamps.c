/* SPDX-License-Identifier: MIT
 * A light by itself: how it is set up, what it and a viewer come to, and what of one that has a place reaches a pixel. */
#include "lamps.h"

#include "glint_lights.h"
#include "glint_math.h"
#include "glint_math_vector.h"

static uint32_t reach_of(const struct glint_light *light, int32_t x, int32_t y, const int32_t v_q30[3],
                         struct glint_view *view)
{
    struct glint_reach reach;
    light->kind->begin(&reach, light);
    (void)glint_vec_of_q30(&view->v, v_q30, 0);
    const struct glint_sight sight = {
        {v_q30[0], v_q30[1], v_q30[2]},
        {light->position[0] - (16 * x + 8), 16 * y + 8 - light->position[1], light->position[2]}};
    const uint32_t att = light->kind->near(&reach, light, &sight, view);
    return att != GLINT_REACH_OPEN ? att : light->kind->exact(light, &sight, view);
}

static void a_directional_light_is_white_and_of_length_1(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        const int32_t to_light[3] = {within(100), within(100), 30};
        const int64_t wide[3] = {to_light[0], to_light[1], to_light[2]};
        struct glint_light light;
        int64_t unit[3];
        assert_int_equal(glint_light_directional(&light, to_light), GLINT_OK);
        assert_true(unit_of(wide, unit));
        for (int k = 0; k < 3; k++) {
            assert_int_equal(light.direction_q30[k], unit[k]);
            assert_int_equal(light.color_q16[k], 65536);
        }
    }
}

static void a_spot_looks_from_its_place_to_its_target(void **state)
{
    (void)state;
    const int32_t position[3] = {100, 200, 300}, target[3] = {400, 600, 180};
    struct glint_light spot;
    assert_int_equal(glint_light_spot(&spot, position, target, 1000, ONE_Q30, 0), GLINT_OK);
    assert_near(spot.direction_q30[0], 300 / 514.1984 * ONE_Q30, 100);  /* |300, 400, 120| */
    assert_near(spot.direction_q30[1], -400 / 514.1984 * ONE_Q30, 100); /* lines go down, y goes up */
    assert_near(spot.direction_q30[2], -120 / 514.1984 * ONE_Q30, 100);
    for (int k = 0; k < 3; k++)
        assert_int_equal(spot.color_q16[k], 65536);
}

static const int32_t viewer[3] = {0, 0, ONE_Q30};

static int64_t squared_distance(const struct glint_light *lamp, int32_t x, int32_t y)
{
    const int64_t dx = lamp->position[0] - 16 * x - 8, dy = lamp->position[1] - 16 * y - 8, dz = lamp->position[2];
    return dx * dx + dy * dy + dz * dz;
}

static void what_arrives_of_a_point_is_the_falloff_bit_by_bit(void **state)
{
    (void)state;
    unsigned dark = 0, whole = 0;
    for (int i = 0; i < 100000; i++) {
        const int32_t size = 1 << below(24), x = (int32_t)below(131071), y = (int32_t)below(131071);
        const int32_t near = 1 + size / (1 + (int32_t)below(20));
        const int32_t e[3] = {within(near), within(near), (int32_t)below((uint32_t)near) + 1};
        const int32_t position[3] = {16 * x + 8 + e[0], 16 * y + 8 + e[1], e[2]};
        struct glint_light lamp;
        if (glint_light_point(&lamp, position, 1 + below((uint32_t)size)) != GLINT_OK)
            continue;
        const u128 d2 = (u128)squared_distance(&lamp, x, y), r2 = (u128)lamp.range * lamp.range;
        const u128 rest = d2 >= r2 ? 0 : 65536 - (2 * 65536 * d2 + r2) / (2 * r2);
        struct glint_view view;
        const uint32_t att = reach_of(&lamp, x, y, viewer, &view);
        assert_int_equal(att, (rest * rest + 32768) / 65536);
        dark += att == 0;
        whole += att > 65000;
    }
    assert_true(dark > 1000 && dark < 90000 && whole > 100);
}

/* L, V and H of one directional light. */
static void a_lit_paint_has_the_directions_of_the_sequence(void **state)
{
    (void)state;
    static const int32_t sizes[] = {1, 5, 100, 32767, 1 << 29, INT32_MAX};
    unsigned behind = 0, none = 0;
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    paint_of(&paint, &look);
    for (int i = 0; i < 30000; i++) {
        const int32_t size = sizes[below(6)];
        int32_t to_light[3], to_viewer[3];
        for (int k = 0; k < 3; k++) {
            to_light[k] = size < INT32_MAX / 2 ? within(size) : (int32_t)(below(65536) << 16 | below(65536));
            to_viewer[k] = below(9) ? within(size / 2 + 1) : -to_light[k] / 2;
        }
        struct glint_light light;
        const bool is_light = to_light[0] || to_light[1] || to_light[2];
        assert_int_equal(glint_light_directional(&light, to_light), is_light ? GLINT_OK : GLINT_ERR_VECTOR);
        if (!is_light) {
            none++;
            continue;
        }
        const enum glint_err err = look_light(&look, to_light, to_viewer);
        assert_int_equal(glint_paint_light(&paint, &light, 1, to_viewer), err);
        behind += err == GLINT_ERR_VECTOR && (to_viewer[0] || to_viewer[1] || to_viewer[2]);
        /* after an error the paint keeps its light, and look does, too */
        assert_memory_equal(&paint.l, &look.l, sizeof look.l);
        assert_memory_equal(&paint.v, &look.v, sizeof look.v);
        assert_memory_equal(&paint.h, &look.h, sizeof look.h);
    }
    assert_true(behind > 10 && none > 10);
}

/* Of 65536, by steps 1a and 1b. */
static uint32_t cone_of(const struct glint_light *spot, int32_t x, int32_t y)
{
    const int64_t e[3] = {spot->position[0] - 16 * x - 8, 16 * y + 8 - spot->position[1], spot->position[2]};
    int64_t l[3], sum = 0;
    if (!unit_of(e, l))
        return 0;
    for (int k = 0; k < 3; k++)
        sum -= l[k] * spot->direction_q30[k];
    const int64_t c = (sum + (1 << 29)) >> 30, inner = spot->cos_inner_q30, outer = spot->cos_outer_q30;
    const u128 p = c >= inner ? 65536 : c <= outer ? 0 : (u128)((c - outer) * 65536 / (inner - outer));
    return (uint32_t)(p * p * (196608 - 2 * p) >> 32);
}

static void what_arrives_of_a_spot_is_its_cones_part_of_that_bit_by_bit(void **state)
{
    (void)state;
    unsigned part = 0;
    for (int i = 0; i < 100000; i++) {
        struct glint_light spot = random_light();
        if (kind_of(&spot) != SPOT || spot.cos_inner_q30 - spot.cos_outer_q30 < 1 << 20)
            continue;
        struct glint_light point;
        assert_int_equal(glint_light_point(&point, spot.position, spot.range), GLINT_OK);
        const int32_t x = (int32_t)below(W), y = (int32_t)below(H);
        struct glint_view view;
        const uint32_t all = reach_of(&point, x, y, viewer, &view);
        const double length = sqrt((double)squared_distance(&spot, x, y));
        const double towards = spot.direction_q30[0] * (16. * x + 8 - spot.position[0]) -
                               spot.direction_q30[1] * (16. * y + 8 - spot.position[1]) -
                               spot.direction_q30[2] * (double)spot.position[2];
        const double c = length > 0 ? towards / length : 0;
        const double p = fmin(1, fmax(0, (c - spot.cos_outer_q30) / (spot.cos_inner_q30 - spot.cos_outer_q30)));
        const uint32_t att = reach_of(&spot, x, y, viewer, &view);
        assert_int_equal(att, ((uint64_t)all * cone_of(&spot, x, y) + 32768) >> 16);
        assert_near(att, all * p * p * (3 - 2 * p), 4); /* c to 2^-27, p and the step rounded down */
        part += att > 0 && att < all;
    }
    assert_true(part > 1000);
}

static void directions_go_with_what_arrives(void **state)
{
    (void)state;
    const int32_t position[3] = {8 + 300, 8 - 400, 1200};
    struct glint_light point;
    struct glint_view view;
    struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    assert_int_equal(glint_light_point(&point, position, 2000), GLINT_OK);
    assert_int_equal(look_light(&look, (const int32_t[]){300, 400, 1200}, viewer), GLINT_OK);
    assert_int_not_equal(reach_of(&point, 0, 0, viewer, &view), 0);
    assert_memory_equal(&view.l, &look.l, sizeof look.l);
    assert_memory_equal(&view.v, &look.v, sizeof look.v);
    assert_memory_equal(&view.h, &look.h, sizeof look.h);
}

/* part = 2^31 (c - outer) / (inner - outer), as place_cone finds it from a c that may be 20 units higher. */
static void a_spot_s_blur_covers_its_cosine_s_error_and_its_quotient_s(void **state)
{
    (void)state;
    for (int i = 0; i < 200000; i++) {
        const uint32_t width = 21 + below(UINT32_C(1) << (6 + below(25)));
        const int32_t place[3] = {0, 0, 10};
        struct glint_light lamp;
        assert_int_equal(glint_light_spot(&lamp, place, (const int32_t[]){0, 0, 0}, 1000, 0, 0), GLINT_OK);
        lamp.cos_outer_q30 = -ONE_Q30;
        lamp.cos_inner_q30 = (int32_t)((int64_t)width - ONE_Q30);
        struct glint_reach reach;
        lamp.kind->begin(&reach, &lamp);
        const uint32_t above = below(width - 20), scaled = above << -reach.width_exponent;
        const uint32_t part = glint_mulhi_near(scaled, reach.width_inverse);
        assert_true((u128)part * width <= (u128)above << 31);
        assert_true(((u128)part + reach.blur + 1) * width > (u128)(above + 20) << 31);
    }
}

/* And where its axis is longer than 1 to none: the sums of its cosine might not fit. */
static void thirty_two_bits_decide_nearly_every_spot_of_an_axis_of_length_1(void **state)
{
    (void)state;
    const int32_t above[3] = {1000, 1000, 1000};
    unsigned open = 0, lit = 0;
    for (int i = 0; i < 20000; i++) {
        const int32_t target[3] = {within(3000), within(3000), 0};
        struct glint_light lamp;
        struct glint_view view;
        struct glint_reach reach;
        assert_int_equal(glint_light_spot(&lamp, above, target, 8000, cosine(10), cosine(50)), GLINT_OK);
        lamp.kind->begin(&reach, &lamp);
        const struct glint_sight sight = {{0, 0, ONE_Q30}, {within(500), within(500), 1000}};
        const uint32_t att = lamp.kind->near(&reach, &lamp, &sight, &view);
        open += att == GLINT_REACH_OPEN;
        lit += att != 0;
        for (int k = 0; k < 3; k++)
            lamp.direction_q30[k] = k == i % 3 ? ONE_Q30 + 65 : 0;
        lamp.kind->begin(&reach, &lamp);
        assert_int_equal(reach.blur, 0);
        for (int k = 0; k < 3; k++) /* 1.75 in all, and a unit */
            lamp.direction_q30[k] = k == i % 3 ? (1 << 29) + 1 + (1 << 28) : 1 << 29;
        lamp.kind->begin(&reach, &lamp);
        assert_int_equal(reach.blur, 0);
    }
    print_message("%u of %u are open\n", open, lit);
    assert_true(lit > 3000 && open < lit / 50);
}

static void a_light_that_cannot_be_is_refused_and_not_written(void **state)
{
    (void)state;
    struct glint_light light, before;
    memset(&light, GUARD, sizeof light);
    before = light;
    const int32_t zero[3] = {0, 0, 0}, up[3] = {0, 0, 1};
    const int32_t far[3] = {0, -GLINT_LIGHT_FAR - 1, 0}, right[3] = {GLINT_LIGHT_FAR + 1, 0, 0},
                  min[3] = {INT32_MIN, INT32_MAX, INT32_MIN};
    assert_int_equal(glint_light_directional(NULL, up), GLINT_ERR_ARG);
    assert_int_equal(glint_light_directional(&light, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_light_directional(&light, zero), GLINT_ERR_VECTOR);
    assert_int_equal(glint_light_point(NULL, up, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_point(&light, NULL, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_point(&light, up, 0), GLINT_ERR_ARG);
    assert_int_equal(glint_light_point(&light, up, GLINT_LIGHT_FAR + 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_point(&light, far, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_point(&light, right, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_point(&light, min, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(NULL, up, zero, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(&light, NULL, zero, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(&light, up, NULL, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(&light, up, up, 1, 2, 1), GLINT_ERR_VECTOR);
    assert_int_equal(glint_light_spot(&light, up, far, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(&light, up, zero, 0, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(&light, up, zero, 1, 1, 2), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(&light, up, zero, 1, ONE_Q30 + 1, 2), GLINT_ERR_ARG);
    assert_int_equal(glint_light_spot(&light, up, zero, 1, 2, -ONE_Q30 - 1), GLINT_ERR_ARG);
    assert_memory_equal(&light, &before, sizeof light);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_directional_light_is_white_and_of_length_1),
        cmocka_unit_test(a_spot_looks_from_its_place_to_its_target),
        cmocka_unit_test(what_arrives_of_a_point_is_the_falloff_bit_by_bit),
        cmocka_unit_test(a_lit_paint_has_the_directions_of_the_sequence),
        cmocka_unit_test(what_arrives_of_a_spot_is_its_cones_part_of_that_bit_by_bit),
        cmocka_unit_test(directions_go_with_what_arrives),
        cmocka_unit_test(a_spot_s_blur_covers_its_cosine_s_error_and_its_quotient_s),
        cmocka_unit_test(thirty_two_bits_decide_nearly_every_spot_of_an_axis_of_length_1),
        cmocka_unit_test(a_light_that_cannot_be_is_refused_and_not_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
