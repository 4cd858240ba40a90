/* SPDX-License-Identifier: MIT
 * lib/helium.c itself, by a stand-in for arm_mve.h (helium/): F of every D, what D is off by, and constants; README.md has the argument. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <stdlib.h>

#include <cmocka.h>

#include "library.h" /* all of lib/ */

/* In units of 2^-16. */
static const double OF_D = .181, F_MAX = 67108.864;

static double shine(int32_t d, uint32_t u)
{
    const struct glint_line_loop loop = {.d = d, .f_max = INT32_MIN};
    struct helium_four four = {.lit = 0xffff};
    four.u = vdupq_n_s32((int32_t)u);
    return -(double)helium_shine(&loop, &four)[0] / 16384;
}

/* t = 0, so that F is 2^46 / D^2: every D from n = 1's least on to 2^26, and every 61st of those above. */
static void f_of_every_d_is_within_its_bound(void **state)
{
    (void)state;
    const int32_t least = (int32_t)(.79 * HELIUM_D), whole = 1 << 26;
    double most = 0;
#pragma omp parallel for reduction(max : most)
    for (int32_t i = least; i < whole + (INT32_MAX - whole) / 61; i++) {
        const int32_t d = i < whole ? i : whole + (i - whole) * 61;
        /* n = 1 alone has D below 2^23 / sqrt(1.024): F there is at most 1.024 with 1 - t = 5 D sqrt(1.024) / 2^23 - 4 */
        const double one = (double)(1 << 23), of_t = 5 * d * sqrt(1.024) / one - 4;
        const double u = d < HELIUM_D ? ceil(2147483648. * (of_t < 0 ? 0 : of_t)) : 2147483648.;
        const double f = u / 2147483648. * one * one / d / d * 65536;
        const double off = fabs(shine(d, (uint32_t)(0 - (int64_t)u)) - f);
        most = off > most ? off : most;
    }
    printf("# F of D is off by at most %.4f of 2^-16\n", most);
    assert_true(most < OF_D);
}

/* What D may be off by: HELIUM_D, k and the rounding; and 2t, which has a bit that t lacks. For every n. */
static void f_of_every_shininess_is_within_five_sixteenths(void **state)
{
    (void)state;
    double most = 0;
    const double true_d = (double)(1 << 23) / sqrt(1.024), by_5 = true_d * 256 / 5;
    assert_true(fabs(true_d - HELIUM_D) < .2 && fabs(by_5 - HELIUM_D_256_BY_5) < .2);
    for (int n = 1; n <= 1000; n++) {
        /* HELIUM_D and the sum's rounding; k's, with slope's floor, times less than 1; slope's constant, relative to what D grows by */
        const double d_is_off = .2 + .5 + 1, d_least = n == 1 ? .79 * true_d : true_d;
        const double of_d = 2 * F_MAX * (d_is_off / d_least + .2 / by_5);
        const double of_t = .5 / 1073741824 * F_MAX *
                            (2 * fabs((n - 1.25) / 1.25) + 1); /* F's slope is steepest at t = 0, n = 1 apart */
        const double floors = 2. / 16384, sum = OF_D + of_d + of_t + floors;
        most = sum > most ? sum : most;
    }
    printf("# F is off by at most %.4f of 2^-16\n", most);
    assert_true(most < 5. / 16);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(f_of_every_d_is_within_its_bound),
        cmocka_unit_test(f_of_every_shininess_is_within_five_sixteenths),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
