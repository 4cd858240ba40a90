/* SPDX-License-Identifier: MIT
 * Modified Schlick. */
#include "oracle.h"

static bool msh_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    /* n - nc + 1.25c = k / (4 * 2^30), so F = 2c / (1.25 (..)^2) = 128 u 2^30 / (5 k^2) */
    const u128 k = 4 * (u128)n * ORACLE_ONE_U - 4 * (u128)n * u + 5 * (u128)u;
    return oracle_rounds(((u128)128 * u * ORACLE_ONE_U) << 16, 5 * k * k, f);
}

static void msh_printed(mpq_t f, uint32_t n, const mpq_t c)
{
    mpq_t d, k;
    mpq_inits(d, k, NULL);
    oracle_fall(d, n, c);
    mpq_set_ui(k, 5, 4);
    mpq_mul(f, k, c);
    mpq_add(d, d, f); /* n - nc + 1.25c */
    mpq_mul(d, d, d);
    mpq_mul(d, d, k);
    mpq_add(f, c, c);
    mpq_div(f, f, d);
    mpq_clears(d, k, NULL);
}

const struct oracle msh_oracle = {.rounds_to = msh_rounds_to, .printed = msh_printed};
