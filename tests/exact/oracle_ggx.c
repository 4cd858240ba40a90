/* SPDX-License-Identifier: MIT
 * GGX. */
#include "oracle.h"

/* m d^2 <= 2^139, d < 2^70, m < 2^18, in digits of 40 bits. */
static bool fits(u128 d, u128 m)
{
    const u128 high = d >> 40, low = d & (((u128)1 << 40) - 1);
    const u128 middle = m * (2 * high * low), lowest = m * (low * low);
    const u128 rest = ((middle & (((u128)1 << 40) - 1)) << 40) + (lowest & (((u128)1 << 80) - 1)); /* < 2^81 */
    const u128 whole = m * (high * high) + (middle >> 40) + (lowest >> 80) + (rest >> 80), limit = (u128)1 << 59;
    return whole < limit || (whole == limit && rest << 48 == 0);
}

/* sqrt(F) = 2^61 / d, d = 2^61 + n (1 - c^2) 2^60. */
static bool ggx_rounds_to(uint32_t n, uint32_t u, uint32_t f)
{
    const u128 d = ((u128)1 << 61) + (u128)n * (((u128)1 << 60) - (u128)u * u);
    return (f == 0 || fits(d, 2 * f - 1)) && !fits(d, 2 * f + 1);
}

static void ggx_printed(mpq_t f, uint32_t n, const mpq_t c)
{
    mpq_t x;
    mpq_init(x);
    mpq_mul(x, c, c);
    mpq_set_ui(f, 1, 1);
    mpq_sub(x, f, x); /* 1 - c^2 */
    mpq_set_ui(f, n, 2);
    mpq_canonicalize(f);
    mpq_mul(x, x, f);
    mpq_set_ui(f, 1, 1);
    mpq_add(x, x, f);
    mpq_mul(x, x, x);
    mpq_inv(f, x);
    mpq_clear(x);
}

const struct oracle ggx_oracle = {.rounds_to = ggx_rounds_to, .printed = ggx_printed};
