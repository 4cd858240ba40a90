/* SPDX-License-Identifier: MIT
 * Cayley. */
#include "oracle.h"

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
    const uint64_t a = 4 * (ORACLE_ONE_U + u), b = n * (ORACLE_ONE_U - u);
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
    oracle_fall(d, n, c);
    mpq_sub(f, k, d);
    mpq_add(d, k, d);
    mpq_div(f, f, d);
    oracle_fourth_power(f);
    mpq_clears(d, k, NULL);
}

const struct oracle cayley_oracle = {.rounds_to = cayley_rounds_to, .printed = cayley_printed};
