/* SPDX-License-Identifier: MIT */
#include "glint_math_root.h"

/* A digit for each two of x: the rest is at most twice the root. */
uint32_t glint_root(uint64_t x)
{
    uint32_t root = 0, upper = (uint32_t)(x >> 30);
    uint64_t rest = 0;
    for (unsigned digit = 0; digit < 31; digit++) {
        if (digit == 16)
            upper = (uint32_t)x << 2;
        rest = rest << 2 | upper >> 30;
        upper <<= 2;
        const uint64_t odd = (uint64_t)root << 2 | 1;
        root <<= 1;
        if (rest >= odd) {
            rest -= odd;
            root++;
        }
    }
    return root;
}
