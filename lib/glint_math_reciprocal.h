/* SPDX-License-Identifier: MIT
 * Internal. 1 / m without a division. */
#ifndef GLINT_MATH_RECIPROCAL_H
#define GLINT_MATH_RECIPROCAL_H

#include "glint_math_flash.h"

/* y, nearly 2^35 / m, for 2^27 <= m < 2^28 by m's upper bits: |y m / 2^35 - 1| < 0.00904. */
extern const uint8_t glint_reciprocals[64]; /* GLINT_FLASH */

/* Y = 2^58 / m (1 + d) for a number m whose floor is given, 2^27 <= m < 2^28; -2^-30 16.1 < d < 2^-30 16.4, and <= 2^31 + 15.
 * With y m = 2^35 (1 + e), |e| < 2^-6.78: 2^35 / m = y (1 - e + e^2 - e^3 + ..); e^4, the first term left out, makes d
 * lower by up to 2^-30 7.2, and the fraction that m lacks makes it higher by up to 2^-30 8. */
static inline uint32_t glint_reciprocal(uint32_t m)
{
    const uint32_t y = GLINT_FLASH_U8(glint_reciprocals[(m >> 21) - 64]);
    const int32_t e = (int32_t)(m * y);                               /* Q35: 2^35 is 0 modulo 2^32 */
    const int32_t r = e >> 14, rr = r * r;                            /* Q21, |r| < 18960; Q42 */
    const int32_t c = (rr >> 13) - (e >> 6) - ((rr >> 14) * r >> 20); /* Q29, |c| < 0.0092: y c < 2^31 */
    return (y << 23) + (uint32_t)((int32_t)y * c >> 6);
}

#endif
