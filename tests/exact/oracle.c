/* SPDX-License-Identifier: MIT */
#include "oracle.h"

#include <stdlib.h>

#define ONE_U ((uint64_t)1 << 30)

/* num / den rounds to f: (2f - 1) den <= 2 num < (2f + 1) den. */
static bool rounds(u128 num, u128 den, uint32_t f)
{
    return 2 * num + den >= 2 * (u128)f * den && 2 * num < (2 * (u128)f + 1) * den;
}

bool oracle_msh_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    /* n - nc + 1.25c = k / (4 * 2^30), so F = 2c / (1.25 (..)^2) = 128 u 2^30 / (5 k^2) */
    const u128 k = 4 * (u128)n * ONE_U - 4 * (u128)n * u + 5 * (u128)u;
    return rounds(((u128)128 * u * ONE_U) << 16, 5 * k * k, f);
}

bool oracle_schlick_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    return rounds((u128)u << 16, (u128)n * ONE_U - (u128)n * u + u, f);
}

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

bool oracle_cayley_rounds_to(uint32_t n, uint32_t u, uint32_t f)
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

static u128 mulhi(u128 a, u128 b)
{
    const uint64_t a0 = (uint64_t)a, a1 = (uint64_t)(a >> 64), b0 = (uint64_t)b, b1 = (uint64_t)(b >> 64);
    const u128 m1 = (u128)a1 * b0 + ((u128)a0 * b0 >> 64);
    const u128 m2 = (u128)a0 * b1 + (uint64_t)m1;
    return (u128)a1 * b1 + (m1 >> 64) + (m2 >> 64);
}

void oracle_chain_blinn(struct oracle_chain *chain, uint32_t u)
{
    chain->base = chain->power = (u128)u << 98;
    chain->n = 1;
    chain->below = 0;
}

void oracle_chain_gauss(struct oracle_chain *chain, uint32_t u)
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

static bool rational_reaches(enum glint_model model, uint32_t n, uint32_t u, unsigned q)
{
    mpq_t c, d, f;
    mpq_inits(c, d, f, NULL);
    mpq_set_ui(c, u, ONE_U);
    mpq_canonicalize(c);
    mpq_set_ui(f, n, 1);
    mpq_mul(d, f, c);
    mpq_sub(d, f, d); /* n - nc */
    if (model == GLINT_SCHLICK) {
        mpq_add(d, d, c);
        mpq_div(f, c, d);
    } else if (model == GLINT_MSH) {
        mpq_set_ui(f, 5, 4);
        mpq_mul(f, f, c);
        mpq_add(d, d, f); /* n - nc + 1.25c */
        mpq_mul(d, d, d);
        mpq_set_ui(f, 5, 4);
        mpq_mul(d, d, f);
        mpq_add(c, c, c);
        mpq_div(f, c, d);
    } else { /* Cayley, n > 4: d = n(1 - c) */
        mpq_set_ui(f, 1, 1);
        mpq_add(c, c, f);
        mpq_set_ui(f, 4, 1);
        mpq_mul(c, c, f); /* 4(1 + c) */
        mpq_sub(f, c, d);
        mpq_add(d, c, d);
        mpq_div(f, f, d);
        if (mpq_sgn(f) < 0)
            mpq_set_ui(f, 0, 1);
        mpq_mul(f, f, f);
        mpq_mul(f, f, f);
    }
    const bool reached = mpq_cmp_ui(f, 1, 1UL << q) >= 0;
    mpq_clears(c, d, f, NULL);
    return reached;
}

static bool power_reaches(uint32_t n, uint32_t u, unsigned q)
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

bool oracle_reaches(enum glint_model model, uint32_t n, uint32_t u, unsigned q)
{
    switch (model) {
    case GLINT_BLINN:
    case GLINT_PHONG:
        return power_reaches(n, u, q);
    case GLINT_GAUSS:
        return gauss_reaches(n, u, q);
    case GLINT_CAYLEY:
        return n <= 4 ? power_reaches(n, u, q) : rational_reaches(model, n, u, q);
    default:
        return rational_reaches(model, n, u, q);
    }
}
