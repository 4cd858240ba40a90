/* SPDX-License-Identifier: MIT
 * Internal. Schlick, quickly. */
#ifndef GLINT_LOBE_SCHLICK_H
#define GLINT_LOBE_SCHLICK_H

#include "glint_math_multiply.h"
#include "glint_math_reciprocal.h"

enum { GLINT_SCHLICK_LOW = 6, GLINT_SCHLICK_HIGH = 5 };

/* f with f - HIGH < 2^28 F < f + LOW for 0 < n <= 1000, 0 < t < 1.
 *
 * F = u / d, u = 2^30 - T, d = 2^30 + (n - 1) T = 2^(14 - up) m, T = 2^30 t, 2^27 <= m < 2^28.
 * Errors of 2^28 F <= 2^28:
 *   reciprocal   2^-30 (-16.1 .. 16.4) of F        low < 4.1, high < 4.1
 *   product      low by < 3 2^-(42 - up) of F, up <= 11        low < 3/8
 *   shift        low by < 1 */
static inline uint32_t glint_schlick_near_t(uint32_t n, uint32_t t)
{
    const uint32_t rest = (n - 1) * (t & 0x3fff);                                 /* < 2^24 */
    uint32_t m = (((uint32_t)1 << 16) + (n - 1) * (t >> 14) + (rest >> 14)) << 2; /* 2^18 .. 2^28: up = 2 */
    unsigned down = 12;                                                           /* 14 - up */
    if (m >> 23 == 0) {
        m <<= 5;
        down -= 5;
    }
    if (m >> 25 == 0) {
        m <<= 2;
        down -= 2;
    }
    if (m >> 26 == 0) {
        m <<= 1;
        down--;
    }
    if (m >> 27 == 0) {
        m <<= 1;
        down--;
    }
    m |= (rest & 0x3fff) >> down;
    return glint_mulhi_near((((uint32_t)1 << 30) - t) << 2, glint_reciprocal(m)) >> down;
}

#endif
