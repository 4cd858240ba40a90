/* SPDX-License-Identifier: MIT
 * Internal. Products of 32 x 32 bits from products of 32 bits: small cores have no others. */
#ifndef GLINT_MATH_MULTIPLY_H
#define GLINT_MATH_MULTIPLY_H

#include <stdint.h>

/* a b / 2^32, low by less than 3: each shift cuts less than 1, and the product of the lower halves is left out. */
static inline uint32_t glint_mulhi_near(uint32_t a, uint32_t b)
{
    const uint32_t a1 = a >> 16, a0 = a & 0xffff, b1 = b >> 16, b0 = b & 0xffff;
    return a1 * b1 + (a1 * b0 >> 16) + (a0 * b1 >> 16);
}

/* a a / 2^32, low by less than 2. */
static inline uint32_t glint_squarehi_near(uint32_t a)
{
    const uint32_t a1 = a >> 16;
    return a1 * a1 + (a1 * (a & 0xffff) >> 15);
}

/* All 64 bits. Each partial sum is at most (2^16 - 1)^2 + 2^16 - 1 < 2^32. */
static inline uint64_t glint_multiply(uint32_t a, uint32_t b)
{
    const uint32_t a1 = a >> 16, a0 = a & 0xffff, b1 = b >> 16, b0 = b & 0xffff;
    const uint32_t middle = a1 * b0 + (a0 * b0 >> 16);
    const uint32_t other = a0 * b1 + (middle & 0xffff);
    return (uint64_t)(a1 * b1 + (middle >> 16) + (other >> 16)) << 32 | a * b;
}

#endif
