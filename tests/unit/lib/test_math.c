/* SPDX-License-Identifier: MIT
 * Roots, reciprocals and rotations, within the bounds that stand beside them. */
#include <math.h>
#include <stdlib.h>

#include "glint_math.h"
#include "glint_math_vector.h"
#include "glint_mesh_pose.h"
#include "shading.h"

static void the_inverse_of_a_root_is_within_its_bound_for_every_argument(void **state)
{
    (void)state;
    for (uint32_t t = 1u << 14; t < 1u << 16; t++) {
        const double y = glint_root_inverse(t) / 32768.0;
        assert_true(y < 2);
        assert_true(fabs(1 - y * y * t / 65536) < 0.95 / 4096);
        assert_true(fabs(1 - y * y * (t + 1) / 65536) < 0.95 / 4096);
    }
}

/* All squares whose root is r, the first and the last. */
static void assert_root(uint32_t r)
{
    const uint64_t square = (uint64_t)r * r;
    assert_int_equal(glint_root(square), r);
    assert_int_equal(glint_root(square + 2 * (uint64_t)r), r);
}

static void a_root_is_rounded_down_at_squares_and_below_them(void **state)
{
    (void)state;
    for (uint32_t r = 0; r < 1u << 17; r++) {
        assert_root(r);
        assert_root(INT32_MAX - r);
        assert_root(r << 14 | 0x3fff);
    }
    for (int bit = 0; bit < 31; bit++) {
        assert_root(1u << bit);
        assert_root((1u << bit) - 1);
    }
}

/* How far y m / 2^35 may be from 1, in 2^-35, for the m whose upper bits are 64 + i. */
static uint64_t farthest(unsigned i, uint64_t y)
{
    const uint64_t one = UINT64_C(1) << 35, low = y * (64 + i) << 21, high = y * (65 + i) << 21;
    const uint64_t below_one = one > low ? one - low : 0, above_one = high > one ? high - one : 0;
    return below_one > above_one ? below_one : above_one;
}

static void no_other_table_of_reciprocals_is_nearer(void **state)
{
    (void)state;
    for (unsigned i = 0; i < 64; i++)
        for (uint64_t y = 128; y < 256; y++)
            assert_true(farthest(i, glint_reciprocals[i]) <= farthest(i, y));
}

/* To 2^-9 of its last bit, by which the reciprocal is off. */
static void a_mesh_s_inverse_is_the_nearest(void **state)
{
    (void)state;
    for (uint32_t m = 1u << 27; m < 1u << 28; m += 9999)
        assert_near(glint_mesh_inverse(m), 8796093022208.0 / m, 0.501);
}

static void a_vector_of_30_bits_has_no_unit_nearby(void **state)
{
    (void)state;
    struct glint_unit unit;
    for (int i = 0; i < 3; i++) {
        int32_t v[3] = {0, 0, 0};
        assert_false(glint_unit_near(&unit, v));
        v[i] = 0x3fffffff;
        assert_true(glint_unit_near(&unit, v));
        assert_near(unit.unit_q30[i], 1073741824.0, 8);
        v[i] = -0x3fffffff;
        assert_true(glint_unit_near(&unit, v));
        assert_near(unit.unit_q30[i], -1073741824.0, 8);
        v[i] = 0x40000000;
        assert_false(glint_unit_near(&unit, v));
        v[i] = -0x40000000;
        assert_false(glint_unit_near(&unit, v));
    }
}

static void a_pose_turns_by_the_nearest_matrix_of_14_bits(void **state)
{
    (void)state;
    const struct look look = random_look(GLINT_RGB888, GLINT_GAMMA);
    struct glint_paint paint;
    paint_of(&paint, &look);
    for (int i = 0; i < 1000; i++) {
        struct glint_pose pose = {.scale = 100};
        double q[4], s = 0;
        for (int k = 0; k < 4; k++) {
            pose.turn[k] = (int16_t)(below(65536) - 32768);
            q[k] = pose.turn[k];
            s += q[k] * q[k];
        }
        struct glint_mesh_drawn drawn;
        assert_true(glint_pose_set(&drawn, &pose, &paint));
        assert_near(drawn.turn[0][0], (q[0] * q[0] + q[1] * q[1] - q[2] * q[2] - q[3] * q[3]) / s * 16384, 0.5001);
        assert_near(drawn.turn[0][1], 2 * (q[1] * q[2] - q[0] * q[3]) / s * 16384, 0.5001);
        assert_near(drawn.turn[1][2], 2 * (q[2] * q[3] - q[0] * q[1]) / s * 16384, 0.5001);
        assert_near(drawn.turn[2][0], 2 * (q[1] * q[3] - q[0] * q[2]) / s * 16384, 0.5001);
    }
}

/* Where r^4 is so near to the middle of two results that only all of its digits decide. */
static void cayley_is_rounded_to_nearest_where_only_its_exact_power_decides(void **state)
{
    (void)state;
    static const uint32_t known[][3] = {{811, 3195678, 5406}, {624, 22211, 64696},   {398, 3144877, 20223},
                                        {388, 7559187, 3766}, {738, 1725770, 19820}, {399, 8539239, 2249}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        assert_int_equal(glint_cayley_t(known[i][0], known[i][1]), known[i][2]);
}

/* 5 (2f - 1) e^2 of the F that is next exceeds U 2^54 by less than 2^-34 of it: not in the first of the library's digits. */
static void msh_is_rounded_down_below_a_half_however_near(void **state)
{
    (void)state;
    static const uint32_t near[] = {1065760886, 987702400, 978704478, 903801080, 841438330, 746291280, 500890097};
    for (size_t i = 0; i < sizeof near / sizeof *near; i++) {
        const u128 e = (UINT64_C(5) << 30) - near[i], left = (u128)((1 << 30) - near[i]) << 54; /* n = 1 */
        uint32_t f = 0;
        while (left >= 5 * (2 * (u128)f + 1) * e * e)
            f++;
        assert_int_equal(glint_msh_t(1, near[i]), f);
        assert_true(5 * (2 * (u128)f + 1) * e * e - left < left >> 34);
    }
}

/* The last of 65536 is the ground's. */
static void depths_in_parallel_are_0_to_65534(void **state)
{
    (void)state;
    static const int32_t z[][2] = {{INT32_MAX, 0},  {32768, 0},        {32767, 0},      {32766, 1},
                                   {0, 32767},      {-1, 32768},       {-32766, 65533}, {-32767, 65534},
                                   {-32768, 65534}, {INT32_MIN, 65534}};
    const struct glint_mesh_frame frame = {.distance = 0};
    for (size_t i = 0; i < sizeof z / sizeof *z; i++) {
        const struct glint_mesh_place place = {.x = 5, .y = 6, .z = z[i][0]}, found = glint_mesh_project(&frame, place);
        assert_true(found.x == 5 && found.y == 6);
        assert_int_equal(found.z, z[i][1]);
    }
}

static void a_cosine_beyond_1_counts_as_1_and_a_negative_one_as_none(void **state)
{
    (void)state;
    for (int model = 0; model < GLINT_MODEL_COUNT; model++) {
        const enum glint_model m = (enum glint_model)model;
        assert_int_equal(glint_eval(m, 60, 65537), glint_eval(m, 60, 65536));
        assert_int_equal(glint_eval(m, 60, INT32_MAX), glint_eval(m, 60, 65536));
        assert_int_equal(glint_eval(m, 60, -1), 0);
        assert_int_equal(glint_eval(m, 60, INT32_MIN), 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_inverse_of_a_root_is_within_its_bound_for_every_argument),
        cmocka_unit_test(a_root_is_rounded_down_at_squares_and_below_them),
        cmocka_unit_test(no_other_table_of_reciprocals_is_nearer),
        cmocka_unit_test(a_mesh_s_inverse_is_the_nearest),
        cmocka_unit_test(a_vector_of_30_bits_has_no_unit_nearby),
        cmocka_unit_test(a_pose_turns_by_the_nearest_matrix_of_14_bits),
        cmocka_unit_test(cayley_is_rounded_to_nearest_where_only_its_exact_power_decides),
        cmocka_unit_test(msh_is_rounded_down_below_a_half_however_near),
        cmocka_unit_test(depths_in_parallel_are_0_to_65534),
        cmocka_unit_test(a_cosine_beyond_1_counts_as_1_and_a_negative_one_as_none),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
