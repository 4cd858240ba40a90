/* SPDX-License-Identifier: MIT
 * Every cutoff: 1000 n x 17 q for every model, c and t. EXACT_EVERY=K: of every K-th n. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "chosen.h"
#include "oracle.h"

enum { N = 1000, Q = 16 };
#define ONE_T ((uint32_t)1 << 30)

static void the_cutoff_is_the_smallest_cosine_that_reaches_two_to_minus_q(void **state)
{
    (void)state;
    const uint32_t step = exact_every();
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++) {
        if (!chosen(model))
            continue;
        long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
        for (uint32_t n = 1; n <= N; n += step) {
            for (unsigned q = 0; q <= Q; q++) {
                const uint32_t c = glint_cutoff((enum glint_model)model, n, q);
                wrong += c > 65536 || !oracle_reaches((enum glint_model)model, n, c << 14, q) ||
                         (c > 0 && oracle_reaches((enum glint_model)model, n, (c - 1) << 14, q));
            }
        }
        printf("# %s: %ld wrong of %u cutoffs in c\n", model_names[model], wrong, (N + step - 1) / step * (Q + 1));
        assert_int_equal(wrong, 0);
    }
}

static void the_cutoff_in_t_is_the_largest_t_that_reaches_two_to_minus_q(void **state)
{
    (void)state;
    const uint32_t step = exact_every();
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++) {
        if (!chosen(model))
            continue;
        long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
        for (uint32_t n = 1; n <= N; n += step) {
            for (unsigned q = 0; q <= Q; q++) {
                const uint32_t t = glint_cutoff_t((enum glint_model)model, n, q);
                wrong += t > ONE_T || !oracle_reaches((enum glint_model)model, n, ONE_T - t, q) ||
                         (t < ONE_T && oracle_reaches((enum glint_model)model, n, ONE_T - t - 1, q));
            }
        }
        printf("# %s: %ld wrong of %u cutoffs in t\n", model_names[model], wrong, (N + step - 1) / step * (Q + 1));
        assert_int_equal(wrong, 0);
    }
}

static void a_prepared_lobe_is_the_function_above_its_cutoff_and_zero_below(void **state)
{
    (void)state;
    const uint32_t step = exact_every();
    long wrong = 0;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++) {
        if (!chosen(model))
            continue;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
        for (uint32_t n = 1; n <= N; n += 3 * step) {
            for (unsigned q = 0; q <= Q; q++) {
                struct glint_lobe lobe;
                glint_lobe_init(&lobe, (enum glint_model)model, n, q);
                for (int d = -3; d <= 3; d++) {
                    const int32_t c = (int32_t)lobe.c_min_q16 + d;
                    const uint32_t t = lobe.t_max_q30 + (uint32_t)d; /* wraps to back-facing */
                    wrong += glint_lobe_eval(&lobe, c) !=
                             (c < (int32_t)lobe.c_min_q16 ? 0 : glint_eval((enum glint_model)model, n, c));
                    wrong += glint_lobe_eval_t(&lobe, t) !=
                             (t > lobe.t_max_q30 ? 0 : glint_eval_t((enum glint_model)model, n, t));
                }
            }
        }
    }
    assert_int_equal(wrong, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cutoff_is_the_smallest_cosine_that_reaches_two_to_minus_q),
        cmocka_unit_test(the_cutoff_in_t_is_the_largest_t_that_reaches_two_to_minus_q),
        cmocka_unit_test(a_prepared_lobe_is_the_function_above_its_cutoff_and_zero_below),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
