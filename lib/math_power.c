/* SPDX-License-Identifier: MIT */
#include "glint_math_power.h"

/* The upper half of a 64 x 64 bit product, from 32 x 32 bit ones. */
static uint64_t mulhi(uint64_t a, uint64_t b)
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
