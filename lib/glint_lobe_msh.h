/* SPDX-License-Identifier: MIT
 * MSH's approximate quotient; not for users. */
#ifndef GLINT_LOBE_MSH_H
#define GLINT_LOBE_MSH_H

#include "glint_math_reciprocal.h"

/* 2^71 C / (5 m^2) for C = u / 2^8 <= 2^16, within 2400; less than 0.4 * 2^32. With y m = 2^35 (1 + r),
 * 1 / m^2 = y^2 2^-70 (1 + p), p = -2r + 3r^2 - 4r^3 + .. Products of 32 bits only, and all that fits is kept. */
static inline uint32_t glint_msh_quotient(uint32_t u_q24, uint32_t m)
{
    const uint32_t y = GLINT_FLASH_U8(glint_reciprocals[(m >> 21) - 64]);
    const int32_t r = (int32_t)(m * y) >> 14;                  /* Q21, |r| < 18960: 2^35 is 0 modulo 2^32. Low by < 1 */
    const int32_t p = (r * (3 * r - (r * r >> 19)) >> 22) - r; /* Q20, |p| < 19300, within 1.1: r and >> err apart */
    const uint32_t b = (u_q24 * y >> 8) * y;                   /* y^2 C < 254^2 2^16 < 2^32. Low by < 254 */
    /* 2^70 C / m^2, off by 1.1 * 2^12 of p + 19300 / 2^4 of b >> 16 + 254 of b + 1 < 5970; less than 2^32: m is near
     * 1.25 * 2^27 where C is near 2^16, elsewhere the whole steps of C missing leave 2^16 each */
    const uint32_t x = b + (uint32_t)((int32_t)(b >> 16) * p >> 4);
    uint32_t q = (x >> 2) + (x >> 3); /* 2/5 x = 3/8 x (1 + 1/16) (1 + 1/256) (1 + 1/65536). Low by < 6 */
    q += q >> 4;
    q += q >> 8;
    return q + (q >> 16);
}

#endif
