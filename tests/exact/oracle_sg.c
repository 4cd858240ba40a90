/* SPDX-License-Identifier: MIT
 * The spherical Gaussian: powers of exp(-t), by MPFR. */
#include "oracle.h"

#include <stdlib.h>

static void sg_chain(struct oracle_chain *chain, uint32_t u)
{
    mpfr_t x;
    mpfr_init2(x, 220);
    mpfr_set_si_2exp(x, (long)u - (long)ORACLE_ONE_U, -30, MPFR_RNDN);
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

static bool sg_reaches(uint32_t n, uint32_t u, unsigned q)
{
    if (q == 0 || u == ORACLE_ONE_U)
        return u == ORACLE_ONE_U;
    mpfr_t x, limit;
    mpfr_inits2(300, x, limit, NULL);
    mpfr_set_ui_2exp(x, ORACLE_ONE_U - u, -30, MPFR_RNDN);
    mpfr_mul_ui(x, x, n, MPFR_RNDN); /* n t <= q ln 2 */
    mpfr_const_log2(limit, MPFR_RNDN);
    mpfr_mul_ui(limit, limit, q, MPFR_RNDN);
    mpfr_sub(x, limit, x, MPFR_RNDN);
    if (mpfr_zero_p(x) || mpfr_get_exp(x) < -200) /* 300 bits do not decide */
        abort();
    const bool reached = mpfr_sgn(x) > 0;
    mpfr_clears(x, limit, NULL);
    return reached;
}

const struct oracle sg_oracle = {.chain = sg_chain, .reaches = sg_reaches};
