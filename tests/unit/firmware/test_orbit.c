/* SPDX-License-Identifier: MIT
 * The light that circles while no host sends one. */
#include <math.h>

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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_orbit_is_a_circle_of_thirty_degrees),
        cmocka_unit_test(the_sine_is_symmetric_about_its_peaks),
        cmocka_unit_test(the_orbit_comes_back_after_its_frames),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
