/* SPDX-License-Identifier: MIT
 * Internal. x^n in Q0.64, x < 1. */
#ifndef GLINT_MATH_POWER_H
#define GLINT_MATH_POWER_H

#include <stdint.h>

/* In (x^n - n 2^-64, x^n]; monotone in x; the exact floor for n <= 4 where x has 30 bits. */
uint64_t glint_power(uint64_t x, uint32_t n);

/* f with f <= 2^-32 glint_power(2^32 x, n) <= f + GLINT_POWER_LOW(n), and the same of 2^32 (2^-32 x)^n. */
uint32_t glint_power_near(uint32_t x, uint32_t n);
#define GLINT_POWER_LOW(n) (3 * (n)-2)

static inline uint32_t glint_power_round(uint64_t power)
{
    return (uint32_t)(((power >> 47) + 1) >> 1); /* Q0.64 -> Q16.16, nearest, ties up */
}

#endif
