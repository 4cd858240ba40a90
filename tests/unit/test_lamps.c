/* SPDX-License-Identifier: MIT
 * A lamp by itself: how it is set up, and what of it reaches a pixel. */
#include "lamps.h"

#include "lamp.h"

static void a_directional_lamp_has_the_light_of_glint_light_init(void **state)
{
    (void)state;
    for (int i = 0; i < 500; i++) {
        const int32_t to_light[3] = {within(100), within(100), 30}, to_viewer[3] = {within(9), within(9), 20};
        struct glint_light light;
        struct glint_lamp lamp;
        assert_int_equal(glint_light_init(&light, to_light, to_viewer), GLINT_OK);
        assert_int_equal(glint_lamp_directional(&lamp, to_light, to_viewer), GLINT_OK);
        assert_memory_equal(&lamp.light, &light, sizeof light);
    }
}

static void a_spot_looks_from_its_place_to_its_target(void **state)
{
    (void)state;
    const int32_t position[3] = {100, 200, 300}, target[3] = {400, 600, 180};
    struct glint_lamp lamp;
    assert_int_equal(glint_lamp_spot(&lamp, position, target, 1000, ONE_Q30, 0), GLINT_OK);
    assert_near(lamp.axis_q30[0], 300 / 514.1984 * ONE_Q30, 100);  /* |300, 400, 120| */
    assert_near(lamp.axis_q30[1], -400 / 514.1984 * ONE_Q30, 100); /* lines go down, y goes up */
    assert_near(lamp.axis_q30[2], -120 / 514.1984 * ONE_Q30, 100);
}

static const int32_t viewer[3] = {0, 0, ONE_Q30};

static int64_t squared_distance(const struct glint_lamp *lamp, int32_t x, int32_t y)
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
        struct glint_lamp lamp;
        if (glint_lamp_point(&lamp, position, 1 + below((uint32_t)size)) != GLINT_OK)
            continue;
        const u128 d2 = (u128)squared_distance(&lamp, x, y), r2 = (u128)lamp.range * lamp.range;
        const u128 rest = d2 >= r2 ? 0 : 65536 - (2 * 65536 * d2 + r2) / (2 * r2);
        struct glint_light light;
        const uint32_t att = glint_lamp_reach(&lamp, x, y, viewer, &light);
        assert_int_equal(att, (rest * rest + 32768) / 65536);
        dark += att == 0;
        whole += att > 65000;
    }
    assert_true(dark > 1000 && dark < 90000 && whole > 100);
}

static void what_arrives_of_a_spot_is_its_cones_part_of_that(void **state)
{
    (void)state;
    unsigned part = 0;
    for (int i = 0; i < 100000; i++) {
        struct glint_lamp spot = random_lamp();
        if (spot.kind != GLINT_SPOT || spot.cos_inner_q30 - spot.cos_outer_q30 < 1 << 20)
            continue;
        struct glint_lamp point = spot;
        point.kind = GLINT_POINT;
        const int32_t x = (int32_t)below(W), y = (int32_t)below(H);
        struct glint_light light;
        const uint32_t all = glint_lamp_reach(&point, x, y, viewer, &light);
        const double length = sqrt((double)squared_distance(&spot, x, y));
        const double towards = spot.axis_q30[0] * (16. * x + 8 - spot.position[0]) -
                               spot.axis_q30[1] * (16. * y + 8 - spot.position[1]) -
                               spot.axis_q30[2] * (double)spot.position[2];
        const double c = length > 0 ? towards / length : 0;
        const double p = fmin(1, fmax(0, (c - spot.cos_outer_q30) / (spot.cos_inner_q30 - spot.cos_outer_q30)));
        const uint32_t att = glint_lamp_reach(&spot, x, y, viewer, &light);
        assert_near(att, all * p * p * (3 - 2 * p), 4); /* c to 2^-27, p and the step rounded down */
        part += att > 0 && att < all;
    }
    assert_true(part > 1000);
}

static void a_light_goes_with_what_arrives(void **state)
{
    (void)state;
    const int32_t position[3] = {8 + 300, 8 - 400, 1200};
    struct glint_lamp lamp;
    struct glint_light light, wanted;
    assert_int_equal(glint_lamp_point(&lamp, position, 2000), GLINT_OK);
    assert_int_equal(glint_light_init(&wanted, (const int32_t[]){300, 400, 1200}, viewer), GLINT_OK);
    assert_int_not_equal(glint_lamp_reach(&lamp, 0, 0, viewer, &light), 0);
    assert_memory_equal(&light, &wanted, sizeof light);
}

static void a_lamp_that_cannot_be_is_refused_and_not_written(void **state)
{
    (void)state;
    struct glint_lamp lamp, before;
    memset(&lamp, GUARD, sizeof lamp);
    before = lamp;
    const int32_t zero[3] = {0, 0, 0}, up[3] = {0, 0, 1}, down[3] = {0, 0, -1};
    const int32_t far[3] = {0, -GLINT_LAMP_FAR - 1, 0}, min[3] = {INT32_MIN, INT32_MAX, INT32_MIN};
    assert_int_equal(glint_lamp_directional(NULL, up, up), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_directional(&lamp, NULL, up), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_directional(&lamp, up, NULL), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_directional(&lamp, zero, up), GLINT_ERR_VECTOR);
    assert_int_equal(glint_lamp_directional(&lamp, down, up), GLINT_ERR_VECTOR);
    assert_int_equal(glint_lamp_point(NULL, up, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_point(&lamp, NULL, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_point(&lamp, up, 0), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_point(&lamp, up, GLINT_LAMP_FAR + 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_point(&lamp, far, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_point(&lamp, min, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(NULL, up, zero, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(&lamp, NULL, zero, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(&lamp, up, NULL, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(&lamp, up, up, 1, 2, 1), GLINT_ERR_VECTOR);
    assert_int_equal(glint_lamp_spot(&lamp, up, far, 1, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(&lamp, up, zero, 0, 2, 1), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(&lamp, up, zero, 1, 1, 2), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(&lamp, up, zero, 1, ONE_Q30 + 1, 2), GLINT_ERR_ARG);
    assert_int_equal(glint_lamp_spot(&lamp, up, zero, 1, 2, -ONE_Q30 - 1), GLINT_ERR_ARG);
    assert_memory_equal(&lamp, &before, sizeof lamp);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_directional_lamp_has_the_light_of_glint_light_init),
        cmocka_unit_test(a_spot_looks_from_its_place_to_its_target),
        cmocka_unit_test(what_arrives_of_a_point_is_the_falloff_bit_by_bit),
        cmocka_unit_test(what_arrives_of_a_spot_is_its_cones_part_of_that),
        cmocka_unit_test(a_light_goes_with_what_arrives),
        cmocka_unit_test(a_lamp_that_cannot_be_is_refused_and_not_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
