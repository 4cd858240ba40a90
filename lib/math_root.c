/* SPDX-License-Identifier: MIT */
#include "glint_math.h"
#include "glint_math_vector.h"

#if GLINT_WIDE

/* Printed by tests/exact/root_chords.py. */
/* clang-format off */
const uint32_t glint_root_chords[48] = {
    0xfff57a4c, 0xf8526ff5, 0xf1546700, 0xeae55f2c,
    0xe4f3584b, 0xdf6f5234, 0xda4c4cc8, 0xd58047ee,
    0xd1024392, 0xccc93fa2, 0xc8cf3c11, 0xc50f38d1,
    0xc18235da, 0xbe243323, 0xbaf230a4, 0xb7e82e58,
    0xb5032c39, 0xb2402a41, 0xaf9c286e, 0xad1526bc,
    0xaaa92527, 0xa85723ad, 0xa61c224c, 0xa3f72100,
    0xa1e71fc9, 0x9feb1ea5, 0x9e011d92, 0x9c281c8e,
    0x9a5f1b99, 0x98a51ab2, 0x96fa19d6, 0x955d1906,
    0x93cc1841, 0x92481786, 0x90d016d4, 0x8f63162b,
    0x8e001589, 0x8ca814ef, 0x8b59145d, 0x8a1313d0,
    0x88d6134a, 0x87a112ca, 0x8675124f, 0x855011da,
    0x84321169, 0x831c10fc, 0x820c1095, 0x81031031,
};
/* clang-format on */

/* Up to a unit or two from a (r + 2^32) 2^-31, which the remainder tells. */
uint32_t glint_root(uint64_t x)
{
    if (x == 0)
        return 0;
    const unsigned up = (unsigned)__builtin_clzll(x) & ~1u;
    const uint32_t a = (uint32_t)(x << up >> 32);
    const uint64_t whole = 2 * (uint64_t)a + (uint64_t)((int64_t)(a >> 1) * glint_wide_inverse(a) >> 30);
    uint32_t root = (uint32_t)(whole >> up / 2);
    while ((uint64_t)root * root > x)
        root--;
    while (x - (uint64_t)root * root > 2 * (uint64_t)root)
        root++;
    return root;
}

#else

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

#endif

/* Printed by tests/exact/reciprocals.py. */
/* clang-format off */
const uint8_t glint_reciprocals[64] GLINT_FLASH = {
    254, 250, 246, 243, 239, 236, 232, 229, 226, 223, 220, 217, 214, 211, 209, 206,
    204, 201, 199, 196, 194, 192, 189, 187, 185, 183, 181, 179, 177, 175, 173, 172,
    170, 168, 166, 165, 163, 161, 160, 158, 157, 155, 154, 152, 151, 150, 148, 147,
    146, 144, 143, 142, 141, 139, 138, 137, 136, 135, 134, 133, 132, 131, 130, 128,
};
/* clang-format on */
