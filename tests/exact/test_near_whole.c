/* SPDX-License-Identifier: MIT
 * The quick forms of the lobes and their bounds over the whole of each domain that can be enumerated, and
 * 10^7 values of each model. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "near.h"

static void products_of_a_billion_words_are_low_by_less_than_stated(void **state)
{
    (void)state;
    check_products(7);
}

static void gausss_exponent_and_the_power_of_two_are_within_their_bounds_for_every_argument(void **state)
{
    (void)state;
    check_gauss_exponent(1);
    check_exp2(1);
}

static void powers_and_models_are_within_their_bounds_at_millions_of_places(void **state)
{
    (void)state;
    check_power(20000);
    check_cayley(50000);
    check_schlick(50000);
    check_gauss(20000);
    check_ggx(50000);
    check_sg(50000);
}

static void every_quick_value_is_the_simple_forms(void **state)
{
    (void)state;
    check_values(10000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products_of_a_billion_words_are_low_by_less_than_stated),
        cmocka_unit_test(gausss_exponent_and_the_power_of_two_are_within_their_bounds_for_every_argument),
        cmocka_unit_test(powers_and_models_are_within_their_bounds_at_millions_of_places),
        cmocka_unit_test(every_quick_value_is_the_simple_forms),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
