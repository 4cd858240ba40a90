/* SPDX-License-Identifier: MIT
 * Modified Schlick, eq. (5): F = 2c / (1.25 (n - nc + 1.25c)^2). */
#include "internal.h"

/* With C = 2^16 c and E = 4n(2^16 - C) + 5C < 2^28:  F 2^16 = C 2^39 / (5 E^2), rounded to nearest by adding half the
 * divisor: C 2^40 + 5 E^2 < 2^60. There are no ties for integer n. */
uint32_t glint_msh(uint32_t n, int32_t c_q16)
{
    if (c_q16 <= 0)
        return 0;
    n = glint_clamp_n(n);
    const uint32_t c = c_q16 < GLINT_C_ONE ? (uint32_t)c_q16 : (uint32_t)GLINT_C_ONE;
    const uint32_t e = 4 * n * ((uint32_t)GLINT_C_ONE - c) + 5 * c;
    const uint64_t d = 5 * (uint64_t)e * e;
    return (uint32_t)((((uint64_t)c << 40) + d) / (2 * d));
}

/* F >= 2^-q  <=>  C 2^(23+q) >= 5 E^2 < 2^59. F rises with C, so the smallest such C is found by bisection; it exists,
 * as F(1) = 1.024. The closed form (12) is exact nowhere and singular at n = 1.25. */
uint32_t glint_msh_cutoff(uint32_t n, unsigned q)
{
    n = glint_clamp_n(n);
    q = glint_clamp_q(q);
    uint32_t below = 0;
    for (uint32_t bit = 32768; bit; bit >>= 1) {
        const uint32_t c = below + bit;
        const uint32_t e = 4 * n * ((uint32_t)GLINT_C_ONE - c) + 5 * c;
        if ((uint64_t)c << (23 + q) < 5 * (uint64_t)e * e)
            below = c;
    }
    return below + 1;
}

/* With U = 2^30 (1 - t) and e = 4n 2^30 t + 5U, 2^32 <= e < 2^42:  F = U 2^37 / (5 e^2). */
static uint64_t denominator(uint32_t n, uint32_t t)
{
    return (uint64_t)(4 * n) * t + 5 * (uint64_t)(GLINT_T_ONE - t);
}

/* F >= m 2^-k, exactly, for m < 2^18 and k <= 17: both sides < 2^105. */
static bool at_least(uint32_t n, uint32_t t, uint32_t m, unsigned k)
{
    const uint64_t e = denominator(n, t);
    struct glint_wide left, right;
    glint_wide_set(&left, GLINT_T_ONE - t);
    glint_wide_mul(&left, (uint64_t)1 << (37 + k));
    glint_wide_set(&right, 5 * e);
    glint_wide_mul(&right, e);
    glint_wide_mul(&right, m);
    return glint_wide_ge(&left, &right);
}

static bool reaches(uint32_t n, uint32_t t, unsigned q)
{
    return at_least(n, t, 1, q);
}

/* One division of 64 bits gives F within 2^-12 ulp; where that does not settle the rounding (one t in 2000), the exact
 * comparison does. */
uint32_t glint_msh_t(uint32_t n, uint32_t t)
{
    if (t >= GLINT_T_ONE)
        return 0;
    n = glint_clamp_n(n);
    const uint64_t e = denominator(n, t);
    unsigned shift = 1;
    while (e >> shift >> 32)
        shift++;
    const uint64_t m = e >> shift;    /* 2^31 <= m < 2^32, low by < 2^-31 of itself */
    const uint64_t d = (m * m) >> 32; /* 2^30 <= d < 2^32, low by < 2^-29 of itself, with both truncations */
    const unsigned bits = 12 + 2 * shift;
    /* F 2^16 in Q.bits: high by < 2^-29 * 67109 < 2^-12 from d, low by < 2^-bits <= 2^-14 from the division */
    const uint64_t y = ((uint64_t)(GLINT_T_ONE - t) << 33) / (5 * d);
    const uint64_t half = (uint64_t)1 << (bits - 1), slack = (uint64_t)1 << (bits - 12);
    const uint32_t low = (uint32_t)((y + half - slack) >> bits);
    const uint32_t high = (uint32_t)((y + half + slack) >> bits);
    return low == high || !at_least(n, t, 2 * high - 1, 17) ? low : high;
}

uint32_t glint_msh_cutoff_t(uint32_t n, unsigned q)
{
    return glint_largest_t(reaches, n, q);
}
