/* SPDX-License-Identifier: MIT
 * The light that circles while no host sends one. */
#include <math.h>

#include "demo.h"
#include "orbit.h"
#include "unit.h"

static void the_orbit_is_a_circle_of_thirty_degrees(void **state)
{
    (void)state;
    for (uint32_t frame = 0; frame < 1000; frame++) {
        int32_t l[3];
        orbit_light(l, frame, 1000);
        const double angle = 2 * 3.14159265358979323846 * frame / 1000;
        const double radius = sqrt((double)l[0] * l[0] + (double)l[1] * l[1]);
        assert_near(radius, 16384, 8);
        assert_near(atan2(l[1], l[0]), remainder(angle, 2 * 3.14159265358979323846), 3e-4);
        assert_int_equal(l[2], 28378);
    }
}

static void the_sine_is_symmetric_about_its_peaks(void **state)
{
    (void)state;
    for (uint32_t at = 0; at <= 0x4000; at++) {
        assert_int_equal(orbit_sine_q15(0x4000 + at), orbit_sine_q15(0x4000 - at));
        assert_int_equal(orbit_sine_q15(0x8000 + at), -orbit_sine_q15(at));
    }
    assert_int_equal(orbit_sine_q15(0x4000), 32768);
}

static void the_orbit_comes_back_after_its_frames(void **state)
{
    (void)state;
    int32_t first[3], again[3];
    orbit_light(first, 7, ORBIT_FRAMES);
    orbit_light(again, 7 + ORBIT_FRAMES, ORBIT_FRAMES);
    assert_memory_equal(first, again, sizeof first);
}

/* x is a / 32768 without its fraction. */
static void assert_is_whole_part(int16_t x, int32_t a)
{
    assert_true(a < 0 ? x * 32768 >= a && (x - 1) * 32768 < a : x * 32768 <= a && (x + 1) * 32768 > a);
}

/* Half angles: 10 degrees of tilt, and half of the turn. */
static void the_demo_s_pose_is_its_turn_and_then_its_tilt(void **state)
{
    (void)state;
    for (uint32_t frame = 0; frame < ORBIT_FRAMES; frame++) {
        struct glint_pose pose;
        demo_pose(&pose, frame, 240);
        const uint32_t half = (frame << 15) / ORBIT_FRAMES;
        const int32_t c = orbit_sine_q15(half + 0x4000), s = orbit_sine_q15(half);
        const int32_t tilt_c = (int32_t)(32768 * cos(3.14159265358979323846 / 18)), /* 32270.2 */
            tilt_s = (int32_t)(32768 * sin(3.14159265358979323846 / 18));           /* 5690.1 */
        assert_is_whole_part(pose.turn[0], tilt_c * c);
        assert_is_whole_part(pose.turn[1], tilt_s * c);
        assert_is_whole_part(pose.turn[2], tilt_c * s);
        assert_is_whole_part(pose.turn[3], tilt_s * s);
        assert_int_equal(pose.scale, 8 * 240);
    }
}

/* So a pixel's hue is the metal's: of gold red, then green, then blue. */
static void the_demo_s_light_is_white_and_its_coin_of_gold(void **state)
{
    (void)state;
    const struct glint_material *m = &demo_gold;
    for (int k = 1; k < 3; k++) {
        assert_int_equal(m->ambient_q16[k], m->ambient_q16[0]);
        assert_int_equal(m->diffuse_q16[k], m->diffuse_q16[0]);
        assert_true(m->albedo[k] < m->albedo[k - 1] && m->specular_q16[k] < m->specular_q16[k - 1]);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_orbit_is_a_circle_of_thirty_degrees),
        cmocka_unit_test(the_sine_is_symmetric_about_its_peaks),
        cmocka_unit_test(the_orbit_comes_back_after_its_frames),
        cmocka_unit_test(the_demo_s_pose_is_its_turn_and_then_its_tilt),
        cmocka_unit_test(the_demo_s_light_is_white_and_its_coin_of_gold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
