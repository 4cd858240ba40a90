/* SPDX-License-Identifier: MIT */
#include "glint_math_root.h"

uint32_t glint_root(uint64_t x) /* digit by digit */
{
    uint64_t root = 0;
    for (uint64_t bit = (uint64_t)1 << 60; bit; bit >>= 2) {
        if (x >= root + bit) {
            x -= root + bit;
            root += bit << 1;
        }
        root >>= 1;
    }
    return (uint32_t)root;
}
