/* SPDX-License-Identifier: MIT */
#include "glint_math_root.h"

/* Digit by digit, in 32 bits: d digits make root < 2^d and leave rest <= 2 root, so that 4 rest + 3 < 2^32 up to the 30th. The
 * 31st is 1 where 4 rest and x's last two bits are more than 4 root. */
uint32_t glint_root(uint64_t x)
{
    uint32_t root = 0, rest = 0, bits = (uint32_t)(x >> 30);
    for (int digit = 1; digit <= 30; digit++) {
        rest = rest << 2 | bits >> 30;
        bits = digit == 16 ? (uint32_t)x << 2 : bits << 2;
        root <<= 1;
        if (rest > 2 * root) {
            rest -= 2 * root + 1;
            root++;
        }
    }
    return 2 * root + (rest >> 30 || (rest << 2 | bits >> 30) > 4 * root);
}
