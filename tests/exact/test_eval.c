/* SPDX-License-Identifier: MIT
 * Exhaustive: every c_q16 and every n, every model, from c and from the t that is the same number. EXACT_EVERY=K in the
 * environment takes every K-th n of the rational functions and every K-th c of the powers: make check does. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "chosen.h"
#include "oracle.h"

enum { ONE = 65536, N = 1000 };

static void report(const char *model, long values, long wrong, long unlike)
{
    printf("# %s: %ld wrong of %ld from c; %ld differ from t\n", model, wrong, values, unlike);
    assert_int_equal(wrong, 0);
    assert_int_equal(unlike, 0);
}

static void check_rational(const char *name, enum glint_model model)
{
    const uint32_t step = exact_every();
    long values = 0, wrong = 0, unlike = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : values, wrong, unlike)
    for (uint32_t n = 1; n <= N; n += step) {
        for (uint32_t c = 0; c <= ONE; c++) {
            values++;
            const uint32_t f = glint_eval(model, n, (int32_t)c);
            wrong += !oracles[model]->rounds_to(n, c << 14, f);
            unlike += f != glint_eval_t(model, n, (ONE - c) << 14);
        }
    }
    report(name, values, wrong, unlike);
}

static void check_power(const char *name, enum glint_model model)
{
    const uint32_t step = exact_every();
    long values = N, wrong = 0, unlike = 0;
    for (uint32_t n = 1; n <= N; n++) /* 1.0 has no place in a chain */
        wrong += glint_eval(model, n, ONE) != ONE;
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : values, wrong, unlike)
    for (uint32_t c = 0; c < ONE; c += step) {
        struct oracle_chain chain;
        for (oracles[model]->chain(&chain, c << 14);; oracle_chain_next(&chain)) {
            const uint32_t f = glint_eval(model, chain.n, (int32_t)c);
            values++;
            wrong += !oracle_chain_rounds_to(&chain, f);
            unlike += f != glint_eval_t(model, chain.n, (ONE - c) << 14);
            if (chain.n == N)
                break;
        }
        mpfr_free_cache();
    }
    report(name, values, wrong, unlike);
}

static void check(const char *name, enum glint_model model)
{
    if (oracles[model]->chain)
        check_power(name, model);
    else
        check_rational(name, model);
}

#define MODEL_TEST(number, name, function, use, grain)                                                                 \
    static void name##_is_correctly_rounded_from_the_cosine(void **state)                                              \
    {                                                                                                                  \
        (void)state;                                                                                                   \
        check(#name, number);                                                                                          \
    }
GLINT_MODELS(MODEL_TEST)

/* The integer oracles themselves, against the formulas as printed, in rational numbers. */
static void the_oracles_agree_with_the_printed_formulas(void **state)
{
    (void)state;
    mpq_t f, half;
    mpz_t rounded;
    mpq_inits(f, half, NULL);
    mpz_init(rounded);
    mpq_set_ui(half, 1, 2);
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++) {
        if (!oracles[model]->rounds_to)
            continue;
        for (uint32_t i = 0; i < 60000; i++) {
            const uint32_t n = 1 + i * 7 % N, u = (uint32_t)((i * UINT64_C(0x9e3779b97f4a7c15)) >> 34);
            oracle_printed(f, (enum glint_model)model, n, u);
            mpq_mul_2exp(f, f, 16);
            mpq_add(f, f, half);
            mpz_fdiv_q(rounded, mpq_numref(f), mpq_denref(f));
            const uint32_t value = (uint32_t)mpz_get_ui(rounded);
            assert_true(oracles[model]->rounds_to(n, u, value));
            assert_false(oracles[model]->rounds_to(n, u, value + 1)); /* it can fail */
        }
    }
    mpq_clears(f, half, NULL);
    mpz_clear(rounded);
}

/* test_eval [PATTERN]: the tests whose names fit, such as lyon*. */
int main(int argc, char **argv)
{
#define MODEL_ENTRY(number, name, function, use, grain) cmocka_unit_test(name##_is_correctly_rounded_from_the_cosine),
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_oracles_agree_with_the_printed_formulas),
                                       GLINT_MODELS(MODEL_ENTRY)};
    cmocka_set_test_filter(argc > 1 ? argv[1] : chosen_tests(model_names));
    return cmocka_run_group_tests(tests, NULL, NULL);
}
