/* SPDX-License-Identifier: MIT
 * test_near [PATTERN]: the quick forms of the lobes and their bounds: all mantissas of the reciprocal, a part of the other
 * domains. The whole domains: test_near_whole.c. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "near.h"

static void products_are_low_by_less_than_stated(void **state)
{
    (void)state;
    check_products(251);
}

static void reciprocals_are_within_their_bounds_for_every_mantissa(void **state)
{
    (void)state;
    check_reciprocal(1);
}

static void gauss_is_within_its_bounds_step_by_step(void **state)
{
    (void)state;
    check_gauss_exponent(251);
    check_exp2(13);
    check_gauss(2000);
}

static void powers_and_fractions_are_within_their_bounds(void **state)
{
    (void)state;
    check_power(4000);
    check_cayley(20000);
    check_schlick(20000);
    check_ggx(20000);
    check_sg(20000);
}

static void every_quick_value_is_the_simple_forms(void **state)
{
    (void)state;
    check_values(500);
}

int main(int argc, char **argv)
{
    if (argc > 1)
        cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_are_low_by_less_than_stated),
        cmocka_unit_test(reciprocals_are_within_their_bounds_for_every_mantissa),
        cmocka_unit_test(gauss_is_within_its_bounds_step_by_step),
        cmocka_unit_test(powers_and_fractions_are_within_their_bounds),
        cmocka_unit_test(every_quick_value_is_the_simple_forms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
