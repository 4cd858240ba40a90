/* SPDX-License-Identifier: MIT
 * Internal. A vector's direction, nearly that of glint_unit_q30, from products of 32 bits.
 *
 * Sizes come shifted up, the largest to 2^29 .. 2^30. The sum of their squares has a mantissa of 32 bits, whose root is inverted
 * by two steps of Newton in 16 bits and one of the third order in 32. tests/proof shows what is said of
 * directions; tests/exact/test_unit checks each step. */
#ifndef GLINT_MATH_UNIT_H
#define GLINT_MATH_UNIT_H

#include "glint.h"

/* unit_q30 is off glint_unit_q30 by no more; nor by more than it and GLINT_UNIT_GROWS 2^up where v is off by up to 1 in each
 * component: by sqrt(3) of a length of 2^29 or more, in units of 2^-30. (Where that makes a size 2^30, which glint_unit_q30 halves
 * and rounds, it is sqrt(3) more, but of a length of 2^30.) */
enum { GLINT_UNIT_SLACK = 4, GLINT_UNIT_GROWS = 4 };

struct glint_unit {
    int32_t unit_q30[3];
    unsigned up;     /* by how much sizes were shifted */
    uint32_t square; /* |v|^2 = (square + d) 2^exponent, 0 <= d < 1; >= 2^30 */
    int32_t exponent;
};

/* False where v = 0, and where a size is 2^30 or more. */
bool glint_unit_near(struct glint_unit *unit, const int32_t v[3]);

/* h, the direction of half of l + (0, 0, 1), for an l of glint_unit_near with l_z >= 0: off that of glint_unit_q30 from its own l by
 * no more than GLINT_UNIT_FRONT. math_unit.c has the sum, tests/proof shows it. */
enum { GLINT_UNIT_FRONT = 20 };
void glint_unit_front(int32_t h_q30[3], const int32_t l_q30[3]);

/* y, nearly 2^15 / sqrt(x) for x = t 2^-16, 2^14 <= t < 2^16: |1 - (y 2^-15)^2 x| < 0.95 2^-12 for every x of that t; y < 2^16. */
static inline uint32_t glint_root_inverse(uint32_t t)
{
    uint32_t y = 70200 - (40150 * t >> 16);            /* within .09 */
    y = y * (49152 - (t * (y * y >> 16) >> 16)) >> 15; /* y (3 - x y^2) / 2: low by up to .012, so .. */
    y += y >> 8;                                       /* .. within .008 */
    return (y * (49152 - (t * (y * y >> 16) >> 16)) >> 15) + 1;
}

#endif
