/* SPDX-License-Identifier: MIT
 * Blinn and Phong: powers of c. */
#include "oracle.h"

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

const struct oracle blinn_oracle = {.chain = blinn_chain, .reaches = blinn_reaches};
