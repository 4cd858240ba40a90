/* SPDX-License-Identifier: MIT */
#include "glint_math.h"

/* The upper half of a 64 x 64 bit product, from 32 x 32 bit ones. Inlined it would take stack and code twice. */
__attribute__((noinline)) static uint64_t mulhi(uint64_t a, uint64_t b)
{
    const uint64_t a0 = (uint32_t)a, a1 = a >> 32, b0 = (uint32_t)b, b1 = b >> 32;
    const uint64_t low = a0 * b1 + (a0 * b0 >> 32); /* <= (2^32-1)^2 + 2^32-2 < 2^64 */
    const uint64_t mid = a1 * b0 + (uint32_t)low;
    return a1 * b1 + (low >> 32) + (mid >> 32);
}

/* Binary powering from the top bit. Each product is truncated, so that it is monotone in x, never above the true value,
 * and err(xy) <= err(x) + err(y) + 2^-64 makes err(x^n) < n 2^-64 (2^-54 in all). At most 18 products. */
uint64_t glint_power(uint64_t x, uint32_t n)
{
    uint64_t power = x;
    uint32_t bit = 512;
    while (bit > n)
        bit >>= 1;
    while (bit >>= 1) {
        power = mulhi(power, power);
        if (n & bit)
            power = mulhi(power, x);
    }
    return power;
}

/* The same in Q0.32. err(x^2k) < 2 err(x^k) + 2, err(x^(k+1)) < err(x^k) + 3, so that err(x^n) <= 3n - 2 by induction. As each
 * product is an integer no larger than the product of what glint_power multiplies, its power is no lower than this. */
uint32_t glint_power_near(uint32_t x, uint32_t n)
{
    uint32_t power = x, bit = 512;
    while (bit > n)
        bit >>= 1;
    while (bit >>= 1) {
        power = glint_squarehi_near(power);
        if (n & bit)
            power = glint_mulhi_near(power, x);
    }
    return power;
}

/* Each Horner step truncates by < 2^-61 and is then multiplied by t <= 1: where |p| <= 1 and the steps are, too, p is good to 2^-57, p^n to
 * 2^-48. */
uint64_t glint_series_power(const int64_t coefficient[GLINT_SERIES_DEGREE + 1], uint32_t n, uint32_t t)
{
    int64_t p = GLINT_FLASH_I64(coefficient[GLINT_SERIES_DEGREE]);
    for (int k = GLINT_SERIES_DEGREE - 1; k >= 0; k--)
        p = GLINT_FLASH_I64(coefficient[k]) + (p >> 32) * (int64_t)t * 4 + (int64_t)((uint64_t)(uint32_t)p * t >> 30);
    return glint_power((uint64_t)p << 2, n);
}

/* 2^-(i / 32) in Q32, the first held to 32 bits; printed by tests/exact/exponential.py. */
/* clang-format off */
const uint32_t glint_exp2_fractions[32] GLINT_FLASH = {
    4294967295, 4202935003, 4112874773, 4024744348, 3938502376, 3854108391, 3771522796, 3690706840,
    3611622603, 3534232978, 3458501653, 3384393094, 3311872529, 3240905930, 3171459999, 3103502151,
    3037000500, 2971923842, 2908241642, 2845924021, 2784941738, 2725266179, 2666869345, 2609723834,
    2553802834, 2499080105, 2445529972, 2393127307, 2341847524, 2291666561, 2242560872, 2194507417,
};
/* clang-format on */
