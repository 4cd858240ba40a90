/* SPDX-License-Identifier: MIT */
#include "glint_math.h"

/* A digit more, of a number whose next two bits are given: root^2 + rest is what has been taken of it, and rest <= 2 root. */
static inline void root_digit(uint32_t *root, uint32_t *rest, uint32_t two)
{
    *rest = *rest << 2 | two;
    *root <<= 1;
    if (*rest > 2 * *root) {
        *rest -= 2 * *root + 1;
        ++*root;
    }
}

/* Digit by digit, in 32 bits: d digits make root < 2^d, so that 4 rest + 3 < 2^32 up to the 30th. The 31st is 1 where 4 rest and
 * x's last two bits are more than 4 root. */
uint32_t glint_root(uint64_t x)
{
    uint32_t root = 0, rest = 0, bits = (uint32_t)(x >> 30);
    for (int digit = 1; digit <= 30; digit++) {
        root_digit(&root, &rest, bits >> 30);
        bits = digit == 16 ? (uint32_t)x << 2 : bits << 2;
    }
    return 2 * root + (rest >> 30 || (rest << 2 | bits >> 30) > 4 * root);
}

/* Printed by tests/exact/reciprocals.py. */
/* clang-format off */
const uint8_t glint_reciprocals[64] GLINT_FLASH = {
    254, 250, 246, 243, 239, 236, 232, 229, 226, 223, 220, 217, 214, 211, 209, 206,
    204, 201, 199, 196, 194, 192, 189, 187, 185, 183, 181, 179, 177, 175, 173, 172,
    170, 168, 166, 165, 163, 161, 160, 158, 157, 155, 154, 152, 151, 150, 148, 147,
    146, 144, 143, 142, 141, 139, 138, 137, 136, 135, 134, 133, 132, 131, 130, 128,
};
/* clang-format on */
