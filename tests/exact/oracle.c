/* SPDX-License-Identifier: MIT */
#include "oracle.h"

#include <stdlib.h>

#define ONE_U ((uint64_t)1 << 30)

/* num / den rounds to f: (2f - 1) den <= 2 num < (2f + 1) den. */
static bool rounds(u128 num, u128 den, uint32_t f)
{
    return 2 * num + den >= 2 * (u128)f * den && 2 * num < (2 * (u128)f + 1) * den;
}

/* ---- MSH ---- */

static bool msh_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    /* n - nc + 1.25c = k / (4 * 2^30), so F = 2c / (1.25 (..)^2) = 128 u 2^30 / (5 k^2) */
    const u128 k = 4 * (u128)n * ONE_U - 4 * (u128)n * u + 5 * (u128)u;
    return rounds(((u128)128 * u * ONE_U) << 16, 5 * k * k, f);
}

/* n (1 - c) */
static void fall(mpq_t f, uint32_t n, const mpq_t c)
{
    mpq_t one;
    mpq_init(one);
    mpq_set_ui(one, 1, 1);
    mpq_sub(one, one, c);
    mpq_set_ui(f, n, 1);
    mpq_mul(f, f, one);
    mpq_clear(one);
}

static void msh_printed(mpq_t f, uint32_t n, const mpq_t c)
{
    mpq_t d, k;
    mpq_inits(d, k, NULL);
    fall(d, n, c);
    mpq_set_ui(k, 5, 4);
    mpq_mul(f, k, c);
    mpq_add(d, d, f); /* n - nc + 1.25c */
    mpq_mul(d, d, d);
    mpq_mul(d, d, k);
    mpq_add(f, c, c);
    mpq_div(f, f, d);
    mpq_clears(d, k, NULL);
}

static const struct oracle msh_oracle = {.rounds_to = msh_rounds_to, .printed = msh_printed};

/* ---- Schlick ---- */

static bool schlick_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    return rounds((u128)u << 16, (u128)n * ONE_U - (u128)n * u + u, f);
}

static void schlick_printed(mpq_t f, uint32_t n, const mpq_t c)
{
    fall(f, n, c);
    mpq_add(f, f, c);
    mpq_div(f, c, f);
}

static const struct oracle schlick_oracle = {.rounds_to = schlick_rounds_to, .printed = schlick_printed};

/* ---- Cayley ---- */

static bool cayley_rounds_exactly(uint64_t p, uint64_t s, uint32_t f)
{
    mpz_t left, right, factor;
    mpz_inits(left, right, factor, NULL);
    mpz_ui_pow_ui(left, p, 4);
    mpz_mul_2exp(left, left, 17); /* 2 * 2^16 p^4 */
    mpz_ui_pow_ui(right, s, 4);
    mpz_mul_ui(factor, right, 2 * (unsigned long)f + 1);
    bool good = mpz_cmp(left, factor) < 0;
    mpz_submul_ui(factor, right, 2); /* 2f - 1 */
    good = good && mpz_cmp(left, factor) >= 0;
    mpz_clears(left, right, factor, NULL);
    return good;
}

static bool cayley_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    if (n <= 4) {
        u128 power = (u128)1 << (30 * (4 - n)); /* c^n 2^120 <= 2^120 */
        for (uint32_t i = 0; i < n; i++)
            power *= u;
        const u128 up = power + ((u128)1 << 103);
        return (uint32_t)(up >> 104) == f;
    }
    const uint64_t a = 4 * (ONE_U + u), b = n * (ONE_U - u);
    if (b >= a)
        return f == 0;
    const uint64_t p = a - b, s = a + b;
    if (p == s)
        return f == 65536;
    /* r in Q63 and r^2, r^4 in Q64: low by less than 2^-59, 2^-40 ulp and more; GMP where that does not decide */
    const uint64_t r = (uint64_t)(((u128)p << 63) / s);
    const uint64_t r2 = (uint64_t)((u128)r * r >> 62);
    const uint64_t r4 = (uint64_t)((u128)r2 * r2 >> 64);
    const uint64_t fraction = (r4 + ((uint64_t)1 << 47)) & (((uint64_t)1 << 48) - 1);
    if (fraction < 1 << 8 || fraction > ((uint64_t)1 << 48) - (1 << 8))
        return cayley_rounds_exactly(p, s, f);
    return (uint32_t)(((r4 >> 47) + 1) >> 1) == f;
}

static void fourth_power_from_0(mpq_t f) /* max(0, f)^4 */
{
    if (mpq_sgn(f) < 0)
        mpq_set_ui(f, 0, 1);
    mpq_mul(f, f, f);
    mpq_mul(f, f, f);
}

static void cayley_printed(mpq_t f, uint32_t n, const mpq_t c)
{
    if (n <= 4) {
        mpq_set(f, c);
        for (uint32_t i = 1; i < n; i++)
            mpq_mul(f, f, c);
        return;
    }
    mpq_t d, k;
    mpq_inits(d, k, NULL);
    mpq_set_ui(k, 1, 1);
    mpq_add(k, k, c);
    mpq_set_ui(d, 4, 1);
    mpq_mul(k, k, d); /* 4(1 + c) */
    fall(d, n, c);
    mpq_sub(f, k, d);
    mpq_add(d, k, d);
    mpq_div(f, f, d);
    fourth_power_from_0(f);
    mpq_clears(d, k, NULL);
}

static const struct oracle cayley_oracle = {.rounds_to = cayley_rounds_to, .printed = cayley_printed};

/* ---- Lyon ---- */

static bool lyon_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    const u128 drop = (u128)n * (ONE_U - u), one = (u128)1 << 32;
    if (drop >= one)
        return f == 0;
    const u128 square = (one - drop) * (one - drop); /* <= 2^64 */
    if (square >> 64)
        return f == 65536;
    return (uint32_t)(((square * square >> 111) + 1) >> 1) == f;
}

static void lyon_printed(mpq_t f, uint32_t n, const mpq_t c)
{
    mpq_t one;
    mpq_init(one);
    fall(f, n, c);
    mpq_set_ui(one, 4, 1);
    mpq_div(f, f, one);
    mpq_set_ui(one, 1, 1);
    mpq_sub(f, one, f);
    fourth_power_from_0(f);
    mpq_clear(one);
}

static const struct oracle lyon_oracle = {.rounds_to = lyon_rounds_to, .printed = lyon_printed};

/* ---- chains ---- */

static u128 mulhi(u128 a, u128 b)
{
    const uint64_t a0 = (uint64_t)a, a1 = (uint64_t)(a >> 64), b0 = (uint64_t)b, b1 = (uint64_t)(b >> 64);
    const u128 m1 = (u128)a1 * b0 + ((u128)a0 * b0 >> 64);
    const u128 m2 = (u128)a0 * b1 + (uint64_t)m1;
    return (u128)a1 * b1 + (m1 >> 64) + (m2 >> 64);
}

void oracle_chain_next(struct oracle_chain *chain)
{
    chain->power = mulhi(chain->power, chain->base);
    chain->n++;
    chain->below += 4; /* err(xy) <= err(x) + err(y) + 1 */
}

bool oracle_chain_rounds_to(const struct oracle_chain *chain, uint32_t f)
{
    const u128 half = (u128)1 << 111;
    const uint32_t low = (uint32_t)(((chain->power >> 111) + 1) >> 1);
    const u128 fraction = (chain->power + half) & (2 * half - 1);
    return low == f && fraction < 2 * half - chain->below;
}

bool oracle_chain_is_near(const struct oracle_chain *chain, uint32_t f)
{
    const u128 limit = (((u128)1 << 112) / 1000) * 501;
    if (f == 65536)
        return -chain->power <= limit; /* 1 - power, modulo 1 */
    const u128 value = (u128)f << 112, power = chain->power;
    return (value > power ? value - power : power - value) <= limit - chain->below;
}

/* ---- Blinn, Phong ---- */

static void blinn_chain(struct oracle_chain *chain, uint32_t u)
{
    chain->base = chain->power = (u128)u << 98;
    chain->n = 1;
    chain->below = 0;
}

static bool blinn_reaches(uint32_t n, uint32_t u, unsigned q)
{
    mpz_t power, one;
    mpz_inits(power, one, NULL);
    mpz_ui_pow_ui(power, u, n);
    mpz_mul_2exp(power, power, q);
    mpz_setbit(one, 30UL * n);
    const bool reached = mpz_cmp(power, one) >= 0;
    mpz_clears(power, one, NULL);
    return reached;
}

static const struct oracle blinn_oracle = {.chain = blinn_chain, .reaches = blinn_reaches};

/* ---- Gauss ---- */

static void gauss_chain(struct oracle_chain *chain, uint32_t u)
{
    mpfr_t x;
    mpfr_init2(x, 220);
    mpfr_set_ui_2exp(x, u, -30, MPFR_RNDN);
    mpfr_acos(x, x, MPFR_RNDN);
    mpfr_sqr(x, x, MPFR_RNDN);
    mpfr_div_2ui(x, x, 1, MPFR_RNDN);
    mpfr_neg(x, x, MPFR_RNDN);
    mpfr_exp(x, x, MPFR_RNDN);
    mpfr_mul_2ui(x, x, 64, MPFR_RNDN);
    const uint64_t high = mpfr_get_ui(x, MPFR_RNDD);
    mpfr_sub_ui(x, x, high, MPFR_RNDN);
    mpfr_mul_2ui(x, x, 64, MPFR_RNDN);
    chain->base = chain->power = ((u128)high << 64) + mpfr_get_ui(x, MPFR_RNDD);
    chain->n = 1;
    chain->below = 2;
    mpfr_clear(x);
}

static bool gauss_reaches(uint32_t n, uint32_t u, unsigned q)
{
    if (q == 0 || u == ONE_U)
        return u == ONE_U;
    mpfr_t x, limit;
    mpfr_inits2(300, x, limit, NULL);
    mpfr_set_ui_2exp(x, u, -30, MPFR_RNDN);
    mpfr_acos(x, x, MPFR_RNDN);
    mpfr_sqr(x, x, MPFR_RNDN);
    mpfr_mul_ui(x, x, n, MPFR_RNDN); /* n x^2 <= 2 q ln 2 */
    mpfr_const_log2(limit, MPFR_RNDN);
    mpfr_mul_ui(limit, limit, 2UL * q, MPFR_RNDN);
    mpfr_sub(x, limit, x, MPFR_RNDN);
    if (mpfr_zero_p(x) || mpfr_get_exp(x) < -200) /* 300 bits do not decide */
        abort();
    const bool reached = mpfr_sgn(x) > 0;
    mpfr_clears(x, limit, NULL);
    return reached;
}

static const struct oracle gauss_oracle = {.chain = gauss_chain, .reaches = gauss_reaches};

/* ---- any ---- */

#define ORACLE(number, name, function, use) &function##_oracle,
const struct oracle *const oracles[GLINT_MODEL_COUNT] = {GLINT_MODELS(ORACLE)};

void oracle_printed(mpq_t f, enum glint_model model, uint32_t n, uint32_t u)
{
    mpq_t c;
    mpq_init(c);
    mpq_set_ui(c, u, ONE_U);
    mpq_canonicalize(c);
    oracles[model]->printed(f, n, c);
    mpq_clear(c);
}

bool oracle_reaches(enum glint_model model, uint32_t n, uint32_t u, unsigned q)
{
    if (oracles[model]->reaches)
        return oracles[model]->reaches(n, u, q);
    mpq_t f;
    mpq_init(f);
    oracle_printed(f, model, n, u);
    const bool reached = mpq_cmp_ui(f, 1, 1UL << q) >= 0;
    mpq_clear(f);
    return reached;
}
