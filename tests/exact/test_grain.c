/* SPDX-License-Identifier: MIT
 * test_grain [PATTERN]: F of t and m, as grain and maps of shininess have it: what is exact, what reaches 2^-q, and the model's loop from
 * below, beside rationals of GMP. m and t are those that there are, m >= t; many are chosen next to where F rounds to another, or ends. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <gmp.h>

#include "glint_grain.h"

#define ONE GLINT_T_ONE
enum { RUN = 16 };

/* ---- F as a ratio of integers, p / s ---- */

typedef void ratio(mpz_t p, mpz_t s, uint64_t m, uint64_t u);
typedef double nearly(double f, double c); /* the m at which F is f */

static void set(mpz_t z, uint64_t x)
{
    mpz_set_ui(z, x);
}

/* 2 c / (1.25 (m + 1.25 c)^2) = 128 c / (5 (4 m + 5 c)^2) */
static void msh(mpz_t p, mpz_t s, uint64_t m, uint64_t u)
{
    set(s, 4 * (m << 8) + 5 * u);
    mpz_mul(s, s, s);
    mpz_mul_ui(s, s, 5);
    set(p, u);
    mpz_mul_2exp(p, p, 7 + 30);
}

static double msh_m(double f, double c)
{
    return sqrt(1.6 * c / f) - 1.25 * c;
}

static void schlick(mpz_t p, mpz_t s, uint64_t m, uint64_t u)
{
    set(p, u);
    set(s, (m << 8) + u);
}

static double schlick_m(double f, double c)
{
    return c / f - c;
}

/* 4 (1 + c) -+ m, to the fourth power */
static void cayley(mpz_t p, mpz_t s, uint64_t m, uint64_t u)
{
    const uint64_t of = 4 * (ONE + u), fall = m << 8;
    set(p, of > fall ? of - fall : 0);
    set(s, of + fall);
    mpz_pow_ui(p, p, 4);
    mpz_pow_ui(s, s, 4);
}

static double cayley_m(double f, double c)
{
    const double r = sqrt(sqrt(f));
    return 4 * (1 + c) * (1 - r) / (1 + r);
}

static void lyon(mpz_t p, mpz_t s, uint64_t m, uint64_t u)
{
    (void)u;
    set(p, m < 4 * (UINT64_C(1) << 22) ? 4 * (UINT64_C(1) << 22) - m : 0);
    set(s, 4 * (UINT64_C(1) << 22));
    mpz_pow_ui(p, p, 4);
    mpz_pow_ui(s, s, 4);
}

static double lyon_m(double f, double c)
{
    (void)c;
    return 4 * (1 - sqrt(sqrt(f)));
}

static void ggx(mpz_t p, mpz_t s, uint64_t m, uint64_t u)
{
    (void)u;
    set(p, UINT64_C(1) << 22);
    set(s, (UINT64_C(1) << 22) + m);
    mpz_mul(p, p, p);
    mpz_mul(s, s, s);
}

static double ggx_m(double f, double c)
{
    (void)c;
    return sqrt(1 / f) - 1;
}

struct model {
    const char *name;
    const struct glint_use_model *use;
    ratio *ratio;
    nearly *m;
};
static const struct model models[] = {
    {"msh", &glint_use_msh_grain, msh, msh_m},
    {"schlick", &glint_use_schlick_grain, schlick, schlick_m},
    {"cayley", &glint_use_cayley_grain, cayley, cayley_m},
    {"lyon", &glint_use_lyon_grain, lyon, lyon_m},
    {"ggx", &glint_use_ggx_grain, ggx, ggx_m},
};
enum { MODELS = sizeof models / sizeof *models };

struct work {
    mpz_t p, s, twice;
};

/* 2^16 F, to nearest, ties up; is F >= 2^-q? */
static uint32_t rounded(struct work *w)
{
    mpz_mul_2exp(w->twice, w->p, 17);
    mpz_add(w->twice, w->twice, w->s);
    mpz_mul_2exp(w->p, w->s, 1);
    mpz_fdiv_q(w->twice, w->twice, w->p);
    return (uint32_t)mpz_get_ui(w->twice);
}

static bool reaches(struct work *w, unsigned q)
{
    mpz_mul_2exp(w->twice, w->p, q);
    return mpz_cmp(w->twice, w->s) >= 0;
}

/* ---- Arguments ---- */

static uint32_t below(uint64_t *seed, uint32_t limit)
{
    *seed = *seed * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (uint32_t)((*seed >> 32) * limit >> 32);
}

static uint32_t any_t(uint64_t *seed)
{
    switch (below(seed, 8)) {
    case 0:
        return below(seed, ONE + 1);
    case 1:
        return ONE - below(seed, 1u << below(seed, 30));
    case 2:
        return below(seed, 4);
    default:
        return below(seed, 1u << (1 + below(seed, 30)));
    }
}

static uint32_t any_m(uint64_t *seed, const struct model *model, uint32_t t, unsigned q)
{
    const uint32_t least = t >> 8; /* n is at least 1 */
    const double c = (double)(ONE - t) / ONE;
    double m = 0;
    switch (below(seed, 6)) {
    case 0:
        m = below(seed, GLINT_GRAIN_MOST) / 4194304.0;
        break;
    case 1:
        m = below(seed, 1u << below(seed, 32)) / 4194304.0;
        break;
    case 2: /* next to 2^-q */
        m = model->m(1.0 / (1u << q), c) + ((int)below(seed, 5) - 2) / 4194304.0;
        break;
    case 3:
        m = least / 4194304.0 + below(seed, 3) / 4194304.0;
        break;
    default: /* next to where F rounds to another */
        m = model->m((below(seed, 65536 >> below(seed, 12)) + .5) / 65536, c) + ((int)below(seed, 3) - 1) / 4194304.0;
    }
    const double units = m * 4194304;
    const uint32_t all = units < GLINT_GRAIN_MOST ? units > 0 ? (uint32_t)units : 0 : GLINT_GRAIN_MOST;
    return all < least ? least : all;
}

/* ---- Tests ---- */

static bool run_is_right(const struct model *model, uint64_t seed)
{
    const struct glint_use_grain *grain = model->use->grain;
    struct glint_paint paint;
    struct glint_sample samples[RUN];
    uint32_t m[RUN], t[RUN];
    bool right = true;
    const unsigned q = 1 + below(&seed, 16);
    paint.material.q = (uint8_t)q;
    paint.model = model->use;
    paint.of.exact.f_max = UINT32_MAX;
    for (unsigned i = 0; i < RUN; i++) {
        samples[i].t_q30 = t[i] = any_t(&seed);
        samples[i].f_q16 = m[i] = any_m(&seed, model, t[i], q);
        samples[i].nl_q16 = 1;
    }
    grain->run(&paint, samples, RUN);
    struct work w;
    mpz_inits(w.p, w.s, w.twice, NULL);
    for (unsigned i = 0; i < RUN && right; i++) {
        model->ratio(w.p, w.s, m[i], ONE - t[i]);
        const bool lit = reaches(&w, q);
        const uint32_t value = rounded(&w), f = lit ? value : 0, near = samples[i].f_q16;
        right = grain->exact(m[i], t[i]) == value && grain->reaches(m[i], t[i], q) == lit && near <= f &&
                f <= near + model->use->slack && !near == !f && samples[i].t_q30 == (f ? t[i] : UINT32_MAX) &&
                glint_grain_f(&paint, m[i], t[i]) == f && (!lit || m[i] < grain->m_end(q));
        if (!right)
            printf("%s: m = %u, t = %u, q = %u: F = %u, 2^-q %d; found %u, %d, from below %u\n", model->name, m[i],
                   t[i], q, value, lit, grain->exact(m[i], t[i]), grain->reaches(m[i], t[i], q), near);
    }
    mpz_clears(w.p, w.s, w.twice, NULL);
    return right;
}

static void f_of_m_is_right_and_its_loop_is_low_by_no_more_than_stated(void **state)
{
    (void)state;
    const char *const asked = getenv("EXACT_MODEL"), *const thousands = getenv("GLINT_PIXELS");
    const long runs = (thousands ? atol(thousands) : 1000) * 400;
    for (int i = 0; i < MODELS; i++) {
        bool right = true;
        if (asked && *asked && strcmp(asked, models[i].name) != 0)
            continue;
#pragma omp parallel for reduction(&& : right) schedule(dynamic, 256)
        for (long k = 0; k < runs; k++)
            right = right && run_is_right(&models[i], (uint64_t)k * 7919 + 1);
        assert_true(right);
    }
}

int main(int argc, char **argv)
{
    if (argc > 1)
        cmocka_set_test_filter(argv[1]);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(f_of_m_is_right_and_its_loop_is_low_by_no_more_than_stated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
