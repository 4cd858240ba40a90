/* SPDX-License-Identifier: MIT
 * Schlick. */
#include "oracle.h"

static bool schlick_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    return oracle_rounds((u128)u << 16, (u128)n * ORACLE_ONE_U - (u128)n * u + u, f);
}

static void schlick_printed(mpq_t f, uint32_t n, const mpq_t c)
{
    oracle_fall(f, n, c);
    mpq_add(f, f, c);
    mpq_div(f, c, f);
}

const struct oracle schlick_oracle = {.rounds_to = schlick_rounds_to, .printed = schlick_printed};
