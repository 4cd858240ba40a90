/* SPDX-License-Identifier: MIT
 * Internal. Cayley for n > 4, quickly. */
#ifndef GLINT_LOBE_CAYLEY_H
#define GLINT_LOBE_CAYLEY_H

#include "glint_math_multiply.h"
#include "glint_math_reciprocal.h"

enum { GLINT_CAYLEY_LOW = 21, GLINT_CAYLEY_HIGH = 17 };

/* f with f - HIGH < 2^28 F < f + LOW for 4 < n <= 1000, 0 < t < 1; 0 where F = 0.
 *
 * F = r^4, r = p / s, p = 2^33 - (n + 4) T, s = 2^33 + (n - 4) T, T = 2^30 t; where p > 0, 2^33 <= s < 2^34.
 * Errors, each in units of its value's last place, and what they make of 2^28 F = 2^28 r^4:
 *   p / 2        high by <= 1/2, as v is rounded down: of r by < 1/4            high < 1/8
 *   reciprocal   2^-30 (-16.1 .. 16.4), four times in r^4                       low < 16.1, high < 16.4
 *   r            low by < 3 2^-31, four times                                   low < 3/2
 *   r^2          low by < 2 2^-30, twice                                        low < 1
 *   r^4          low by < 2 2^-28                                               low < 2
 * and the squares of these, less than 2^-20 of them. */
static inline uint32_t glint_cayley_near_t(uint32_t n, uint32_t t)
{
    const uint32_t fall = (n + 4) * (t >> 14), rest = (n + 4) * (t & 0x3fff) >> 1; /* < 2^26, < 2^23 */
    if (fall >> 19)
        return 0;
    const uint32_t v = (fall << 13) + rest; /* (n + 4) T / 2, rounded down */
    if (v < rest)
        return 0;
    const uint32_t m = ((uint32_t)1 << 27) + ((v - (t << 2)) >> 5);  /* s / 2^6, rounded down */
    const uint32_t r = glint_mulhi_near(0 - v, glint_reciprocal(m)); /* Q31 */
    return glint_squarehi_near(glint_squarehi_near(r));              /* Q30, Q28 */
}

#endif
