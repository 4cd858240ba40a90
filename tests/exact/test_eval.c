/* SPDX-License-Identifier: MIT
 * Exhaustive: every c_q16 and every n, six models, from c and from the t that is the same number. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "oracle.h"

enum { ONE = 65536, N = 1000 };

static void report(const char *model, long wrong, long unlike)
{
    printf("# %s: %ld wrong of 65537000 from c; %ld of 65537000 differ from t\n", model, wrong, unlike);
    assert_int_equal(wrong, 0);
    assert_int_equal(unlike, 0);
}

typedef bool rounds_to(uint32_t n, uint32_t u, uint32_t f);

static void check_rational(const char *name, enum glint_model model, rounds_to *oracle)
{
    long wrong = 0, unlike = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong, unlike)
    for (uint32_t n = 1; n <= N; n++) {
        for (uint32_t c = 0; c <= ONE; c++) {
            const uint32_t f = glint_eval(model, n, (int32_t)c);
            wrong += !oracle(n, c << 14, f);
            unlike += f != glint_eval_t(model, n, (ONE - c) << 14);
        }
    }
    report(name, wrong, unlike);
}

static void check_power(const char *name, enum glint_model model, void (*start)(struct oracle_chain *, uint32_t))
{
    long wrong = 0, unlike = 0;
    for (uint32_t n = 1; n <= N; n++) { /* c = 0, 1 */
        wrong += glint_eval(model, n, ONE) != ONE;
        if (model != GLINT_GAUSS)
            wrong += glint_eval(model, n, 0) != 0;
    }
    const uint32_t first = model == GLINT_GAUSS ? 0 : 1;
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : wrong, unlike)
    for (uint32_t c = first; c < ONE; c++) {
        struct oracle_chain chain;
        for (start(&chain, c << 14);; oracle_chain_next(&chain)) {
            const uint32_t f = glint_eval(model, chain.n, (int32_t)c);
            wrong += !oracle_chain_rounds_to(&chain, f);
            unlike += f != glint_eval_t(model, chain.n, (ONE - c) << 14);
            if (chain.n == N)
                break;
        }
        mpfr_free_cache();
    }
    report(name, wrong, unlike);
}

static void msh_is_correctly_rounded_for_every_cosine_and_shininess(void **state)
{
    (void)state;
    check_rational("msh", GLINT_MSH, oracle_msh_rounds_to);
}

static void schlick_is_correctly_rounded_for_every_cosine_and_shininess(void **state)
{
    (void)state;
    check_rational("schlick", GLINT_SCHLICK, oracle_schlick_rounds_to);
}

static void cayley_is_correctly_rounded_for_every_cosine_and_shininess(void **state)
{
    (void)state;
    check_rational("cayley", GLINT_CAYLEY, oracle_cayley_rounds_to);
}

static void blinn_is_correctly_rounded_for_every_cosine_and_shininess(void **state)
{
    (void)state;
    check_power("blinn", GLINT_BLINN, oracle_chain_blinn);
}

static void phong_is_correctly_rounded_for_every_cosine_and_shininess(void **state)
{
    (void)state;
    check_power("phong", GLINT_PHONG, oracle_chain_blinn);
}

static void gauss_is_correctly_rounded_for_every_cosine_and_shininess(void **state)
{
    (void)state;
    check_power("gauss", GLINT_GAUSS, oracle_chain_gauss);
}

/* The integer oracles themselves, against the formulas as the paper prints them, in 200 bits of MPFR. */
static void the_oracles_agree_with_the_printed_formulas(void **state)
{
    (void)state;
    mpfr_t c, d, f, n;
    mpfr_inits2(200, c, d, f, n, NULL);
    for (uint32_t i = 0; i < 60000; i++) {
        const uint32_t k = 1 + i * 7 % N, u = (uint32_t)((i * UINT64_C(0x9e3779b97f4a7c15)) >> 34);
        mpfr_set_ui_2exp(c, u, -30, MPFR_RNDN);
        mpfr_set_ui(n, k, MPFR_RNDN);
        mpfr_mul(d, n, c, MPFR_RNDN);
        mpfr_sub(d, n, d, MPFR_RNDN);
        mpfr_add(f, d, c, MPFR_RNDN); /* n - nc + c */
        mpfr_div(f, c, f, MPFR_RNDN);
        mpfr_mul_2ui(f, f, 16, MPFR_RNDN);
        assert_true(oracle_schlick_rounds_to(k, u, (uint32_t)mpfr_get_ui(f, MPFR_RNDN)));
        mpfr_mul_d(f, c, 1.25, MPFR_RNDN);
        mpfr_add(d, d, f, MPFR_RNDN); /* n - nc + 1.25c */
        mpfr_sqr(d, d, MPFR_RNDN);
        mpfr_mul_d(d, d, 1.25, MPFR_RNDN);
        mpfr_mul_ui(f, c, 2, MPFR_RNDN);
        mpfr_div(f, f, d, MPFR_RNDN);
        mpfr_mul_2ui(f, f, 16, MPFR_RNDN);
        assert_true(oracle_msh_rounds_to(k, u, (uint32_t)mpfr_get_ui(f, MPFR_RNDN)));
        assert_false(oracle_msh_rounds_to(k, u, (uint32_t)mpfr_get_ui(f, MPFR_RNDN) + 1)); /* it can fail */
        if (k > 4) {
            mpfr_ui_sub(d, 1, c, MPFR_RNDN);
            mpfr_mul(d, d, n, MPFR_RNDN); /* n(1 - c) */
            mpfr_add_ui(c, c, 1, MPFR_RNDN);
            mpfr_mul_ui(c, c, 4, MPFR_RNDN); /* 4(1 + c) */
            mpfr_sub(f, c, d, MPFR_RNDN);
            mpfr_add(d, c, d, MPFR_RNDN);
            mpfr_div(f, f, d, MPFR_RNDN);
            if (mpfr_sgn(f) < 0)
                mpfr_set_zero(f, 1);
            mpfr_pow_ui(f, f, 4, MPFR_RNDN);
            mpfr_mul_2ui(f, f, 16, MPFR_RNDN);
            assert_true(oracle_cayley_rounds_to(k, u, (uint32_t)mpfr_get_ui(f, MPFR_RNDN)));
        }
    }
    mpfr_clears(c, d, f, n, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_oracles_agree_with_the_printed_formulas),
        cmocka_unit_test(msh_is_correctly_rounded_for_every_cosine_and_shininess),
        cmocka_unit_test(schlick_is_correctly_rounded_for_every_cosine_and_shininess),
        cmocka_unit_test(blinn_is_correctly_rounded_for_every_cosine_and_shininess),
        cmocka_unit_test(phong_is_correctly_rounded_for_every_cosine_and_shininess),
        cmocka_unit_test(gauss_is_correctly_rounded_for_every_cosine_and_shininess),
        cmocka_unit_test(cayley_is_correctly_rounded_for_every_cosine_and_shininess),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
