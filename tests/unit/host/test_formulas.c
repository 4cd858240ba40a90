/* SPDX-License-Identifier: MIT
 * The paper's formulas, against each other and against their meaning. */
#include <math.h>

#include "unit.h"

#include "family.h"
#include "models/models.h"

static const double some_n[] = {1, 2, 3.5, 10, 60, 704, 1000};
enum { SOME_N = sizeof some_n / sizeof *some_n };

static void the_models_are_members_of_the_general_family(void **state)
{
    (void)state;
    static const struct family msh = {{1, 2, 1, 1, 1}, {2, 1.25, 1, 1, 1.25}},
                               schlick = {{1, 1, 1, 1, 1}, {1, 1, 1, 1, 1}};
    for (size_t i = 0; i < SOME_N; i++) {
        const double n = some_n[i];
        for (double c = 0; c <= 1; c += 1.0 / 64) {
            assert_near(family_value(&msh, n, c), model_double(GLINT_MSH, n, c), 1e-13);
            assert_near(family_value(&schlick, n, c), model_double(GLINT_SCHLICK, n, c), 1e-13);
        }
    }
}

static void the_derivative_is_the_limit_of_differences(void **state)
{
    (void)state;
    const double h = 1e-6;
    for (size_t i = 0; i < SOME_N; i++) {
        const double n = some_n[i];
        for (double x = 0.01; x < 1.5; x += 0.1) {
            const double difference = model_double(GLINT_MSH, n, cos(x + h)) - model_double(GLINT_MSH, n, cos(x - h));
            assert_near(msh_derivative(n, x), difference / (2 * h), 1e-5);
        }
    }
}

static void each_function_is_2_to_minus_q_at_its_cutoff_angle(void **state)
{
    (void)state;
    for (size_t i = 0; i < SOME_N; i++) {
        const double n = some_n[i];
        for (unsigned q = 1; q <= 16; q++) {
            const double limit = exp2(-(double)q);
            assert_near(model_double(GLINT_MSH, n, cos(msh_cutoff_angle_stable(n, q))), limit, 1e-9);
            assert_near(model_double(GLINT_SCHLICK, n, cos(schlick_cutoff_angle(n, q))), limit, 1e-9);
            assert_near(model_double(GLINT_BLINN, n, cos(blinn_cutoff_angle(n, q))), limit, 1e-9);
        }
    }
}

static void equation_12_agrees_with_its_stable_form_where_it_is_defined(void **state)
{
    (void)state;
    for (size_t i = 0; i < SOME_N; i++)
        assert_near(acos(msh_cutoff_cosine(some_n[i], 8)), msh_cutoff_angle_stable(some_n[i], 8), 1e-9);
    assert_true(!isfinite(msh_cutoff_cosine(1.25, 8)));
    assert_near(model_double(GLINT_MSH, 1.25, cos(msh_cutoff_angle_stable(1.25, 8))), exp2(-8), 1e-12);
}

static void blinn_at_the_epicentre_is_three_tenths(void **state)
{
    (void)state;
    for (size_t i = 0; i < SOME_N; i++) {
        const double n = some_n[i];
        assert_near(model_double(GLINT_BLINN, n, cos(epicentre_angle(n))), exp(-1.2), 1e-9);
        assert_near(model_double(GLINT_BLINN, n, cos(epicentre_angle_exact(n))), 0.3, 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_models_are_members_of_the_general_family),
        cmocka_unit_test(the_derivative_is_the_limit_of_differences),
        cmocka_unit_test(each_function_is_2_to_minus_q_at_its_cutoff_angle),
        cmocka_unit_test(equation_12_agrees_with_its_stable_form_where_it_is_defined),
        cmocka_unit_test(blinn_at_the_epicentre_is_three_tenths),
    };
    return cmocka_run_group_tests_name("formulas", tests, NULL, NULL);
}
