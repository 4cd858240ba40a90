/* SPDX-License-Identifier: MIT
 * Lyon. */
#include "oracle.h"

static bool lyon_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    const u128 drop = (u128)n * (ORACLE_ONE_U - u), one = (u128)1 << 32;
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
    oracle_fall(f, n, c);
    mpq_set_ui(one, 4, 1);
    mpq_div(f, f, one);
    mpq_set_ui(one, 1, 1);
    mpq_sub(f, one, f);
    oracle_fourth_power(f);
    mpq_clear(one);
}

const struct oracle lyon_oracle = {.rounds_to = lyon_rounds_to, .printed = lyon_printed};
