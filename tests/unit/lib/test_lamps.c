/* SPDX-License-Identifier: MIT
 * A lamp by itself: how it is set up, and what of it reaches a pixel. */
#include "lamps.h"

#include "glint_lamp.h"
#include "glint_math_multiply.h"
#include "glint_math_vector.h"

static uint32_t reach_of(const struct glint_lamp *lamp, int32_t x, int32_t y, const int32_t v_q30[3],
                         struct glint_light *light)
{
    struct glint_reach reach;
    glint_reach_init(&reach, lamp);
    (void)glint_vec_of_q30(&light->v, v_q30, 0);
    const struct glint_sight sight = {
        {v_q30[0], v_q30[1], v_q30[2]},
        {lamp->position[0] - (16 * x + 8), 16 * y + 8 - lamp->position[1], lamp->position[2]}};
    const uint32_t att = glint_reach_near(&reach, lamp, &sight, light);
    return att != GLINT_REACH_OPEN ? att : glint_reach_exact(&reach, lamp, &sight, light);
}

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
        for (int k = 0; k < 3; k++) /* what it has no use for is 0 */
            assert_true(lamp.position[k] == 0 && lamp.axis_q30[k] == 0);
        assert_true(lamp.range == 0 && lamp.cos_inner_q30 == 0 && lamp.cos_outer_q30 == 0);
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
        const uint32_t att = reach_of(&lamp, x, y, viewer, &light);
        assert_int_equal(att, (rest * rest + 32768) / 65536);
        dark += att == 0;
        whole += att > 65000;
    }
    assert_true(dark > 1000 && dark < 90000 && whole > 100);
}

/* A direction in Q2.30, as lib/sequence.md has it; false for one of length 0. */
static bool unit_of(const int64_t v[3], int64_t out[3])
{
    int64_t size[3], largest = 0;
    for (int k = 0; k < 3; k++) {
        size[k] = llabs(v[k]);
        largest = size[k] > largest ? size[k] : largest;
    }
    if (largest == 0)
        return false;
    uint64_t squares = 0;
    for (; largest >= 1 << 30; largest /= 2)
        for (int k = 0; k < 3; k++)
            size[k] /= 2;
    for (; largest < 1 << 29; largest *= 2)
        for (int k = 0; k < 3; k++)
            size[k] *= 2;
    for (int k = 0; k < 3; k++)
        squares += (uint64_t)(size[k] * size[k]);
    const int64_t root = (int64_t)root_of(squares);
    for (int k = 0; k < 3; k++)
        out[k] = (v[k] < 0 ? -1 : 1) * (((size[k] << 30) + root / 2) / root);
    return true;
}

static struct glint_vec q15_of(const int64_t v[3])
{
    int16_t c[3];
    for (int k = 0; k < 3; k++)
        c[k] = (int16_t)fmin(floor((double)v[k] / 32768 + .5), 32767);
    return (struct glint_vec){c[0], c[1], c[2]};
}

static void a_light_is_what_its_sequence_says(void **state)
{
    (void)state;
    static const int32_t sizes[] = {1, 5, 100, 32767, 1 << 29, INT32_MAX};
    unsigned behind = 0;
    for (int i = 0; i < 30000; i++) {
        const int32_t size = sizes[below(6)];
        int32_t to_light[3], to_viewer[3];
        int64_t l[3], v[3], wide_l[3], wide_v[3], h[3], half[3];
        for (int k = 0; k < 3; k++) {
            wide_l[k] = to_light[k] =
                size < INT32_MAX / 2 ? within(size) : (int32_t)(below(65536) << 16 | below(65536));
            wide_v[k] = to_viewer[k] = below(9) ? within(size / 2 + 1) : -to_light[k] / 2;
        }
        struct glint_light light;
        const enum glint_err err = glint_light_init(&light, to_light, to_viewer);
        if (!unit_of(wide_l, l) || !unit_of(wide_v, v)) {
            assert_int_equal(err, GLINT_ERR_VECTOR);
            continue;
        }
        bool is_behind = true;
        for (int k = 0; k < 3; k++) {
            is_behind = is_behind && llabs(l[k] + v[k]) <= 8;
            half[k] = (int64_t)floor((double)(l[k] + v[k]) / 2);
        }
        assert_int_equal(err, is_behind ? GLINT_ERR_VECTOR : GLINT_OK);
        behind += is_behind;
        if (is_behind)
            continue;
        assert_true(unit_of(half, h));
        const struct glint_light wanted = {q15_of(l), q15_of(v), q15_of(h)};
        assert_memory_equal(&light, &wanted, sizeof light);
    }
    assert_true(behind > 10);
}

/* Of 65536, by steps 1a and 1b. */
static uint32_t cone_of(const struct glint_lamp *spot, int32_t x, int32_t y)
{
    const int64_t e[3] = {spot->position[0] - 16 * x - 8, 16 * y + 8 - spot->position[1], spot->position[2]};
    int64_t l[3], sum = 0;
    if (!unit_of(e, l))
        return 0;
    for (int k = 0; k < 3; k++)
        sum -= l[k] * spot->axis_q30[k];
    const int64_t c = (sum + (1 << 29)) >> 30, inner = spot->cos_inner_q30, outer = spot->cos_outer_q30;
    const u128 p = c >= inner ? 65536 : c <= outer ? 0 : (u128)((c - outer) * 65536 / (inner - outer));
    return (uint32_t)(p * p * (196608 - 2 * p) >> 32);
}

static void what_arrives_of_a_spot_is_its_cones_part_of_that_bit_by_bit(void **state)
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
        const uint32_t all = reach_of(&point, x, y, viewer, &light);
        const double length = sqrt((double)squared_distance(&spot, x, y));
        const double towards = spot.axis_q30[0] * (16. * x + 8 - spot.position[0]) -
                               spot.axis_q30[1] * (16. * y + 8 - spot.position[1]) -
                               spot.axis_q30[2] * (double)spot.position[2];
        const double c = length > 0 ? towards / length : 0;
        const double p = fmin(1, fmax(0, (c - spot.cos_outer_q30) / (spot.cos_inner_q30 - spot.cos_outer_q30)));
        const uint32_t att = reach_of(&spot, x, y, viewer, &light);
        assert_int_equal(att, ((uint64_t)all * cone_of(&spot, x, y) + 32768) >> 16);
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
    assert_int_not_equal(reach_of(&lamp, 0, 0, viewer, &light), 0);
    assert_memory_equal(&light, &wanted, sizeof light);
}

/* part = 2^31 (c - outer) / (inner - outer), as lamp_cone finds it from a c that may be 20 units higher. */
static void a_spot_s_blur_covers_its_cosine_s_error_and_its_quotient_s(void **state)
{
    (void)state;
    for (int i = 0; i < 200000; i++) {
        const uint32_t width = 21 + below(UINT32_C(1) << (6 + below(25)));
        struct glint_lamp lamp = {.kind = GLINT_SPOT, .range = 1000, .axis_q30 = {0, 0, -ONE_Q30}};
        lamp.cos_outer_q30 = -ONE_Q30;
        lamp.cos_inner_q30 = (int32_t)((int64_t)width - ONE_Q30);
        struct glint_reach reach;
        glint_reach_init(&reach, &lamp);
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
        struct glint_lamp lamp;
        struct glint_light light;
        struct glint_reach reach;
        assert_int_equal(glint_lamp_spot(&lamp, above, target, 8000, cosine(10), cosine(50)), GLINT_OK);
        glint_reach_init(&reach, &lamp);
        const struct glint_sight sight = {{0, 0, ONE_Q30}, {within(500), within(500), 1000}};
        const uint32_t att = glint_reach_near(&reach, &lamp, &sight, &light);
        open += att == GLINT_REACH_OPEN;
        lit += att != 0;
        for (int k = 0; k < 3; k++)
            lamp.axis_q30[k] = k == i % 3 ? ONE_Q30 + 65 : 0;
        glint_reach_init(&reach, &lamp);
        assert_int_equal(reach.blur, 0);
        for (int k = 0; k < 3; k++) /* 1.75 in all, and a unit */
            lamp.axis_q30[k] = k == i % 3 ? (1 << 29) + 1 + (1 << 28) : 1 << 29;
        glint_reach_init(&reach, &lamp);
        assert_int_equal(reach.blur, 0);
    }
    print_message("%u of %u are open\n", open, lit);
    assert_true(lit > 3000 && open < lit / 50);
}

static void a_lamp_that_cannot_be_is_refused_and_not_written(void **state)
{
    (void)state;
    struct glint_lamp lamp, before;
    memset(&lamp, GUARD, sizeof lamp);
    before = lamp;
    const int32_t zero[3] = {0, 0, 0}, up[3] = {0, 0, 1}, down[3] = {0, 0, -1};
    const int32_t far[3] = {0, -GLINT_LAMP_FAR - 1, 0}, right[3] = {GLINT_LAMP_FAR + 1, 0, 0},
                  min[3] = {INT32_MIN, INT32_MAX, INT32_MIN};
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
    assert_int_equal(glint_lamp_point(&lamp, right, 1), GLINT_ERR_ARG);
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
        cmocka_unit_test(a_light_is_what_its_sequence_says),
        cmocka_unit_test(what_arrives_of_a_spot_is_its_cones_part_of_that_bit_by_bit),
        cmocka_unit_test(a_light_goes_with_what_arrives),
        cmocka_unit_test(a_spot_s_blur_covers_its_cosine_s_error_and_its_quotient_s),
        cmocka_unit_test(thirty_two_bits_decide_nearly_every_spot_of_an_axis_of_length_1),
        cmocka_unit_test(a_lamp_that_cannot_be_is_refused_and_not_written),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
