/* SPDX-License-Identifier: MIT
 * The light that follows the hand: how soon, how still, and what a knock does. Samples are those of a sensor with its data sheet's noise. */
#include <math.h>
#include <stdlib.h>

#include "tilt.h"
#include "unit.h"

enum { RATE = 250 };
static const double pi = 3.14159265358979;

/* ---- a sensor ---- */

static double normal(void)
{
    const double a = (rand() + 1.0) / (RAND_MAX + 2.0), b = (rand() + 1.0) / (RAND_MAX + 2.0);
    return sqrt(-2 * log(a)) * cos(2 * pi * b);
}

/* 200 ug/sqrt(Hz) up to half of the rate, in a sensor that is turned about the upward axis of its picture, then about the right one. */
static void feel(int16_t sample[3], double right_degrees, double up_degrees, bool noisy)
{
    const double a = right_degrees * pi / 180, b = up_degrees * pi / 180;
    const double g[3] = {sin(a) * cos(b), sin(b), cos(a) * cos(b)};
    for (unsigned i = 0; i < 3; i++)
        sample[i] = (int16_t)lrint(TILT_ONE_G * (g[i] + (noisy ? 200e-6 * sqrt(RATE / 2) * normal() : 0)));
}

static bool add(struct tilt *tilt, double right_degrees, double up_degrees)
{
    int16_t sample[3];
    feel(sample, right_degrees, up_degrees, true);
    return tilt_add(tilt, sample);
}

static double angle_between(const int32_t a[3], double right_degrees, double up_degrees)
{
    int16_t b[3];
    double dot = 0, aa = 0, bb = 0;
    feel(b, right_degrees, up_degrees, false);
    for (unsigned i = 0; i < 3; i++) {
        dot += (double)a[i] * b[i];
        aa += (double)a[i] * a[i];
        bb += (double)b[i] * b[i];
    }
    return acos(fmin(1, dot / sqrt(aa * bb))) * 180 / pi;
}

/* ---- tests ---- */

static void a_still_hand_has_a_still_light_for_ten_seconds_at_any_tilt(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed <= 40; seed++) {
        struct tilt tilt = {0};
        int32_t to_light[3], looked[3];
        const double right = (double)(seed * 37 % 140) - 70, up = (double)(seed * 53 % 140) - 70;
        srand(seed);
        for (unsigned i = 0; i < RATE; i++) { /* it comes from elsewhere */
            assert_false(add(&tilt, right * i / RATE, up * i / RATE));
            tilt_light(&tilt, to_light);
        }
        for (unsigned i = 0; i < RATE / 2; i++)
            assert_false(add(&tilt, right, up));
        tilt_light(&tilt, to_light);
        for (unsigned i = 0; i < 10 * RATE; i++) {
            assert_false(add(&tilt, right, up));
            assert_false(tilt_light(&tilt, to_light));
            tilt_look(&tilt, looked);
            assert_memory_equal(looked, to_light, sizeof looked);
        }
        if (to_light[2] > TILT_ONE_G)
            assert_true(angle_between(to_light, right, up) < .75);
    }
}

/* Two samples: 8 ms, of the 35 ms that a step may take to the first pixel. */
static void a_step_of_five_degrees_moves_the_light_with_the_second_sample(void **state)
{
    (void)state;
    for (unsigned seed = 1; seed <= 100; seed++) {
        struct tilt tilt = {0};
        int32_t to_light[3];
        srand(seed);
        for (unsigned i = 0; i < RATE; i++)
            add(&tilt, seed % 60, 0);
        tilt_light(&tilt, to_light);
        unsigned samples = 0;
        do {
            add(&tilt, seed % 60 + 5, 0);
            samples++;
        } while (!tilt_light(&tilt, to_light));
        assert_true(samples <= 2);
    }
}

/* 28 ms behind a steady turn, nine tenths of a step after 69 ms, as tilt.h says. */
static void the_light_is_as_late_as_it_is_said_to_be(void **state)
{
    (void)state;
    struct tilt tilt = {0};
    int32_t to_light[3];
    srand(1);
    for (unsigned i = 0; i < 2 * RATE; i++) {
        add(&tilt, -45 + 90.0 * i / (2 * RATE), 0); /* 45 degrees a second */
        tilt_light(&tilt, to_light);
    }
    assert_true(fabs(angle_between(to_light, 45, 0) - 45 * .028 - 45.0 / RATE) < .3);
    tilt = (struct tilt){0};
    for (unsigned i = 0; i < RATE; i++)
        add(&tilt, 0, 0);
    for (unsigned i = 0; i < 17; i++)
        add(&tilt, 10, 0);
    tilt_light(&tilt, to_light);
    assert_true(fabs(angle_between(to_light, 10, 0) - 1) < .4);
}

static void the_panel_is_lit_at_any_tilt(void **state)
{
    (void)state;
    for (int tilted = -180; tilted <= 180; tilted += 5) {
        struct tilt tilt = {0};
        int32_t to_light[3];
        add(&tilt, tilted, 0);
        assert_true(tilt_light(&tilt, to_light));
        assert_true(to_light[2] >= TILT_ONE_G && to_light[2] < 34000 && abs(to_light[0]) < 34000);
    }
}

static void a_knock_counts_once_and_hardly_moves_the_light(void **state)
{
    (void)state;
    struct tilt tilt = {0};
    int32_t to_light[3];
    const int16_t knock[3] = {3000, -2000, 20000};
    unsigned knocks = 0;
    srand(5);
    for (unsigned i = 0; i < RATE; i++)
        knocks += add(&tilt, 20, 0);
    for (unsigned i = 0; i < 3; i++)
        knocks += tilt_add(&tilt, knock);
    assert_int_equal(knocks, 1);
    tilt_light(&tilt, to_light);
    assert_true(angle_between(to_light, 20, 0) < 15);
    for (unsigned i = 0; i < RATE; i++)
        knocks += add(&tilt, 20, 0);
    tilt_light(&tilt, to_light);
    assert_true(knocks == 1 && angle_between(to_light, 20, 0) < .75);
    knocks += tilt_add(&tilt, knock);
    assert_int_equal(knocks, 2);
}

static void samples_far_away_count_for_a_step_each(void **state)
{
    (void)state;
    static const int16_t flat[3] = {0, 0, TILT_ONE_G}, knock[3] = {INT16_MAX, 0, TILT_ONE_G};
    struct tilt knocked = {0};
    tilt_add(&knocked, flat);
    for (int k = 1; k <= 20; k++) {
        const int16_t place[3] = {(int16_t)(k * TILT_STEP / 8), 0, TILT_ONE_G};
        struct tilt there = {0};
        int32_t of_knocked[3], of_there[3];
        tilt_add(&knocked, knock);
        tilt_add(&there, place);
        tilt_look(&knocked, of_knocked);
        tilt_look(&there, of_there);
        assert_memory_equal(of_knocked, of_there, sizeof of_there);
    }
}

/* Half a turn in half a second, and back: more than a wrist does. */
static void turning_is_no_knock(void **state)
{
    (void)state;
    struct tilt tilt = {0};
    srand(6);
    for (unsigned i = 0; i < RATE; i++)
        assert_false(add(&tilt, 0, 0));
    for (unsigned i = 0; i < RATE / 2; i++)
        assert_false(add(&tilt, 360.0 * i / RATE, 0));
}

static void samples_at_the_ends_of_their_range_do_no_harm(void **state)
{
    (void)state;
    struct tilt tilt = {0};
    int32_t to_light[3];
    srand(7);
    for (unsigned i = 0; i < 100000; i++) {
        const int16_t any[3] = {(int16_t)(rand() % 3 ? -32768 : 32767), (int16_t)(rand() >> 8), (int16_t)-32768};
        (void)tilt_add(&tilt, any);
        (void)tilt_light(&tilt, to_light);
        assert_true(to_light[2] >= TILT_ONE_G && abs(to_light[0]) <= 131072 && abs(to_light[1]) <= 131072);
    }
}

static void axes_and_turns_keep_up_up(void **state)
{
    (void)state;
    const int16_t sample[3] = {100, -32768, 300};
    const int8_t plain[3] = {1, 2, 3}, turned[3] = {-2, 1, -3};
    int16_t seen[3];
    tilt_turn(seen, sample, plain, 0);
    assert_true(seen[0] == 100 && seen[1] == -32768 && seen[2] == 300);
    tilt_turn(seen, sample, turned, 0);
    assert_true(seen[0] == 32767 && seen[1] == 100 && seen[2] == -300);
    /* Of a picture that is turned clockwise by a quarter the upper edge is at the right. */
    const int16_t to_the_right[3] = {8192, 0, 0};
    tilt_turn(seen, to_the_right, plain, 1);
    assert_true(seen[0] == 0 && seen[1] == 8192);
    tilt_turn(seen, to_the_right, plain, 2);
    assert_true(seen[0] == -8192 && seen[1] == 0);
    tilt_turn(seen, to_the_right, plain, 3);
    assert_true(seen[0] == 0 && seen[1] == -8192);
    tilt_turn(seen, sample, plain, 1);
    assert_true(seen[0] == 32767 && seen[1] == 100);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_still_hand_has_a_still_light_for_ten_seconds_at_any_tilt),
        cmocka_unit_test(a_step_of_five_degrees_moves_the_light_with_the_second_sample),
        cmocka_unit_test(the_light_is_as_late_as_it_is_said_to_be),
        cmocka_unit_test(the_panel_is_lit_at_any_tilt),
        cmocka_unit_test(a_knock_counts_once_and_hardly_moves_the_light),
        cmocka_unit_test(samples_far_away_count_for_a_step_each),
        cmocka_unit_test(turning_is_no_knock),
        cmocka_unit_test(samples_at_the_ends_of_their_range_do_no_harm),
        cmocka_unit_test(axes_and_turns_keep_up_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
