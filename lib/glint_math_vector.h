/* SPDX-License-Identifier: MIT
 * Internal. Unit vectors in Q2.30. */
#ifndef GLINT_MATH_VECTOR_H
#define GLINT_MATH_VECTOR_H

#include "glint.h"
#include "glint_port.h"

/* v / |v|, good to 2^-28; false where v = 0. */
bool glint_unit_q30(int32_t out[3], const int32_t v[3]);
/* To Q1.15, |v_i| <= 2^30 + 8; false where what is off by up to slack, < 2^14, might be rounded to another. */
bool glint_vec_of_q30(struct glint_vec *out, const int32_t v[3], int32_t slack);

/* low to Q1.15; bits from 15 on in what it returns: low + more goes to another. */
static inline uint32_t glint_vec_round(int16_t *out, int32_t low, int32_t more)
{
#if GLINT_THUMB2
    int32_t rounded; /* > -32769 */
    __asm__("ssat %0, #16, %1, asr #15" : "=r"(rounded) : "r"(low) : "cc");
    *out = (int16_t)rounded;
#else
    const int32_t rounded = low >> 15;
    *out = (int16_t)(rounded > INT16_MAX ? INT16_MAX : rounded);
#endif
    return (uint32_t)(low ^ (low + more));
}

/* The same in place. */
static inline __attribute__((always_inline)) bool glint_vec_near(struct glint_vec *out, const int32_t v[3],
                                                                 int32_t slack)
{
    const int32_t half = (1 << 14) - slack, more = 2 * slack;
    uint32_t open = glint_vec_round(&out->x, v[0] + half, more);
    open |= glint_vec_round(&out->y, v[1] + half, more);
    open |= glint_vec_round(&out->z, v[2] + half, more);
    return !(open >> 15);
}

/* (l + v) / 2, rounded down; the sum may not fit. */
static inline int32_t glint_half_sum(int32_t l, int32_t v)
{
    return (l & v) + ((l ^ v) >> 1);
}

/* Half of l + v; false where the light is straight behind. half may be l or v. */
bool glint_half_q30(int32_t half[3], const int32_t l_q30[3], const int32_t v_q30[3]);

/* ---- a direction, nearly that of glint_unit_q30, from products of 32 bits ----
 * Sizes come shifted up, the largest to 2^29 .. 2^30. The sum of their squares has a mantissa of 32 bits, whose root is inverted
 * by two steps of Newton in 16 bits and one of the third order in 32. tests/proof shows what is said of
 * directions; tests/exact/test_unit checks each step. */

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
 * no more than GLINT_UNIT_FRONT. math_vector.c has the sum, tests/proof shows it. */
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
