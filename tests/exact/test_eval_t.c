/* SPDX-License-Identifier: MIT
 * From t the domain (2^30 x 1000 a model) is too large to enumerate. What carries the claim:
 *   - tests/proof: error bounds, and an exact decision where they do not settle the rounding, for every t and n;
 *   - here some 10^9 values against the oracle: every n at random t (uniform and logarithmic), dense runs at the
 *     ends and at the cutoffs, and both sides of 10^6 places where the result steps, found by bisection;
 *   - test_eval.c: all 65,537,000 arguments that are also cosines.
 * EXACT_EVERY=K: every K-th n and every K-th t, as make check has it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>

#include <cmocka.h>

#include "chosen.h"
#include "oracle.h"

enum { N = 1000 };
#define ONE_T ((uint32_t)1 << 30)

static uint64_t mix(uint64_t x) /* splitmix64 */
{
    x += UINT64_C(0x9e3779b97f4a7c15);
    x = (x ^ (x >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    x = (x ^ (x >> 27)) * UINT64_C(0x94d049bb133111eb);
    return x ^ (x >> 31);
}

/* 1 <= t < 2^30: even seeds uniform, odd ones uniform in the logarithm, where large n live. */
static uint32_t random_t(uint64_t seed)
{
    const uint64_t r = mix(seed);
    const uint32_t t = (uint32_t)(r >> 34) >> (seed & 1 ? (r & 31) * 28 / 31 : 0);
    return t ? t : 1;
}

static bool wrong_at(enum glint_model model, uint32_t n, uint32_t t)
{
    return !oracles[model]->rounds_to(n, ONE_T - t, glint_eval_t(model, n, t));
}

/* Values at `per_n` random t for each n. */
static long count_random(enum glint_model model, uint32_t per_n)
{
    const uint32_t every = exact_every();
    long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
    for (uint32_t n = 1; n <= N; n += every)
        for (uint32_t i = 0; i < per_n; i += every)
            wrong += wrong_at(model, n, random_t(((uint64_t)model << 56) + ((uint64_t)n << 40) + i));
    return wrong;
}

/* How many that is of so many t for each n. */
static long of_each(uint32_t per_n)
{
    const uint32_t every = exact_every();
    return (long)((per_n + every - 1) / every) * (long)((N + every - 1) / every);
}

/* Every t of `length` at 0, at the cutoffs q = 8 and 16, and at 1; a value that rises with t is wrong too. */
static long count_dense(enum glint_model model, uint32_t length)
{
    bool (*const rounds_to)(uint32_t n, uint32_t u, uint32_t f) = oracles[model]->rounds_to;
    const uint32_t every = exact_every();
    long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
    for (uint32_t n = 1; n <= N; n += every) {
        const uint32_t middle[4] = {0, glint_cutoff_t(model, n, 8), glint_cutoff_t(model, n, 16), ONE_T};
        for (int i = 0; i < 4; i++) {
            uint32_t from = middle[i] > length / 2 ? middle[i] - length / 2 : 0;
            from = from > ONE_T - length ? ONE_T - length : from;
            uint32_t before = glint_eval_t(model, n, from);
            for (uint32_t t = from; t < from + length; t++) {
                const uint32_t f = glint_eval_t(model, n, t);
                wrong += f > before || (rounds_to && !rounds_to(n, ONE_T - t, f));
                before = f;
            }
        }
    }
    return wrong;
}

/* Where the result falls from f or more to less: the last t with F >= f, and the one after. */
static int wrong_at_step(enum glint_model model, uint32_t n, uint32_t f)
{
    uint32_t t = 0; /* F(0) >= f */
    for (uint32_t bit = ONE_T / 2; bit; bit >>= 1)
        if (glint_eval_t(model, n, t + bit) >= f)
            t += bit;
    return wrong_at(model, n, t) + wrong_at(model, n, t + 1);
}

static long count_steps(enum glint_model model, uint32_t per_n)
{
    const uint32_t every = exact_every();
    long wrong = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : wrong)
    for (uint32_t n = 1; n <= N; n += every)
        for (uint32_t i = 0; i < per_n; i += every)
            wrong += wrong_at_step(model, n, 1 + (uint32_t)(mix(((uint64_t)n << 32) + i) % 65536));
    return wrong;
}

static void check_rational(const char *name, enum glint_model model)
{
    enum { DENSE = 4096, STEPS = 350 };
    const uint32_t per_n = 125000;
    const long random = count_random(model, per_n), dense = count_dense(model, DENSE);
    const long steps = count_steps(model, STEPS);
    printf("# %s from t: %ld wrong of %ld random, %ld of %ld in dense runs, %ld of %ld where it steps\n", name, random,
           of_each(per_n), dense, 4 * DENSE * of_each(1), steps, 2 * of_each(STEPS));
    assert_int_equal(random + dense + steps, 0);
}

static void check_power(const char *name, enum glint_model model)
{
    enum { DENSE = 512 };
    const uint32_t count = 125000, every = exact_every() * exact_every();
    long far = 0, not_nearest = 0;
#pragma omp parallel for schedule(dynamic, 64) reduction(+ : far, not_nearest)
    for (uint32_t i = 0; i < count; i += every) {
        const uint32_t t = random_t(((uint64_t)model << 56) + i);
        struct oracle_chain chain;
        for (oracles[model]->chain(&chain, ONE_T - t);; oracle_chain_next(&chain)) {
            const uint32_t f = glint_eval_t(model, chain.n, t);
            far += !oracle_chain_is_near(&chain, f);
            not_nearest += !oracle_chain_rounds_to(&chain, f);
            if (chain.n == N)
                break;
        }
        mpfr_free_cache();
    }
    const long rising = count_dense(model, DENSE);
    printf(
        "# %s from t: %ld farther than .501 ulp, %ld not the nearest, of %ld random; %ld rise of %ld in dense runs\n",
        name, far, not_nearest, (long)((count + every - 1) / every) * N, rising, 4 * DENSE * of_each(1));
    assert_int_equal(far + rising, 0);
}

/* Each function once: models that share another's are left out. */
#define MODEL_TEST_own(name, number)                                                                                   \
    static void name##_is_what_the_header_promises_from_t(void **state)                                                \
    {                                                                                                                  \
        (void)state;                                                                                                   \
        if (oracles[number]->chain)                                                                                    \
            check_power(#name, number);                                                                                \
        else                                                                                                           \
            check_rational(#name, number);                                                                             \
    }
#define MODEL_TEST_shared(name, number)
#define MODEL_TEST(number, name, function, use, grain) MODEL_TEST_##use(name, number)
GLINT_MODELS(MODEL_TEST)

/* There F changes least from a t to the next, so what is off by little moves most steps. */
static void at_the_least_shininess_values_step_where_they_must(void **state)
{
    (void)state;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (uint32_t f = 1; f <= 65536 && oracles[model]->rounds_to; f += 199)
            assert_int_equal(wrong_at_step((enum glint_model)model, 1, f), 0);
}

/* F(1), rounded. */
static uint32_t peak_of(enum glint_model model, uint32_t n)
{
    uint32_t f = 65536;
    while (oracles[model]->rounds_to && !oracles[model]->rounds_to(n, ONE_T, f))
        f++;
    return f;
}

/* Back-facing, the ends, n out of range, a model that is none. */
static void arguments_out_of_range_are_clamped_or_give_zero(void **state)
{
    (void)state;
    for (unsigned m = 0; m < GLINT_MODEL_COUNT; m++) {
        const enum glint_model model = (enum glint_model)m;
        assert_int_equal(glint_eval_t(model, 60, ONE_T + 1), 0);
        assert_int_equal(glint_eval_t(model, 60, UINT32_MAX), 0);
        assert_int_equal(glint_eval(model, 60, -1), 0);
        assert_int_equal(glint_eval(model, 60, INT32_MIN), 0);
        assert_int_equal(glint_eval(model, 60, INT32_MAX), glint_eval(model, 60, 65536));
        assert_int_equal(glint_eval(model, 60, 65536), peak_of(model, 60));
        assert_int_equal(glint_eval(model, 0, 40000), glint_eval(model, 1, 40000));
        assert_int_equal(glint_eval(model, UINT32_MAX, 65000), glint_eval(model, 1000, 65000));
        assert_int_equal(glint_eval_t(model, 0, 12345678), glint_eval_t(model, 1, 12345678));
        assert_int_equal(glint_eval_t(model, 1001, 1234567), glint_eval_t(model, 1000, 1234567));
        assert_int_equal(glint_cutoff(model, 60, 17), glint_cutoff(model, 60, 16));
        assert_int_equal(glint_cutoff_t(model, 60, UINT32_MAX), glint_cutoff_t(model, 60, 16));
        assert_int_equal(glint_cutoff(model, 5000, 8), glint_cutoff(model, 1000, 8));
        assert_int_equal(glint_cutoff_t(model, 0, 8), glint_cutoff_t(model, 1, 8));
    }
    const enum glint_model none = (enum glint_model)GLINT_MODEL_COUNT;
    struct glint_lobe lobe;
    glint_lobe_init(&lobe, none, 60, 8);
    assert_int_equal(glint_eval(none, 60, 65536) + glint_eval_t(none, 60, 0), 0);
    assert_int_equal(glint_cutoff(none, 60, 8) + glint_cutoff_t(none, 60, 8), 0);
    assert_int_equal(glint_lobe_eval(&lobe, 65536) + glint_lobe_eval_t(&lobe, 0), 0);
    glint_lobe_init(&lobe, (enum glint_model)256, 60, 8); /* whose low byte is MSH's */
    assert_int_equal(glint_lobe_eval(&lobe, 65536) + glint_lobe_eval_t(&lobe, 0), 0);
}

/* test_eval_t [PATTERN]: the tests whose names fit, such as lyon*. */
int main(int argc, char **argv)
{
#define MODEL_ENTRY_own(name) cmocka_unit_test(name##_is_what_the_header_promises_from_t),
#define MODEL_ENTRY_shared(name)
#define MODEL_ENTRY(number, name, function, use, grain) MODEL_ENTRY_##use(name)
    const struct CMUnitTest tests[] = {cmocka_unit_test(arguments_out_of_range_are_clamped_or_give_zero),
                                       cmocka_unit_test(at_the_least_shininess_values_step_where_they_must),
                                       GLINT_MODELS(MODEL_ENTRY)};
    cmocka_set_test_filter(argc > 1 ? argv[1] : chosen_tests(model_functions));
    return cmocka_run_group_tests(tests, NULL, NULL);
}
