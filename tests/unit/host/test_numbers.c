/* SPDX-License-Identifier: MIT
 * Numbers from the command line. */
#include <stdlib.h>

#include "unit.h"

#include "base/parse.h"

static void a_list_holds_its_numbers_and_ranges_in_order(void **state)
{
    (void)state;
    double *values;
    assert_int_equal(parse_list(NULL, "-n", "5,1:3,0:1:0.5", 0, 1000, &values), 7);
    static const double wanted[] = {5, 1, 2, 3, 0, 0.5, 1};
    for (int i = 0; i < 7; i++)
        assert_float_equal(values[i], wanted[i], 0);
    free(values);
}

static void a_range_reaches_its_end_whatever_the_step_rounds_to(void **state)
{
    (void)state;
    double *values;
    assert_int_equal(parse_list(NULL, "C", "0:0.7:0.1", 0, 0.7, &values), 8);
    assert_true(values[7] <= 0.7);
    free(values);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_list_holds_its_numbers_and_ranges_in_order),
        cmocka_unit_test(a_range_reaches_its_end_whatever_the_step_rounds_to),
    };
    return cmocka_run_group_tests_name("numbers", tests, NULL, NULL);
}
