/* SPDX-License-Identifier: MIT
 * Internal. Unit vectors in Q2.30. */
#ifndef GLINT_MATH_VECTOR_H
#define GLINT_MATH_VECTOR_H

#include "glint.h"
#include "glint_port.h"

#define GLINT_VECTOR_INLINE static inline __attribute__((always_inline))

/* v / |v|, good to 2^-28; false where v = 0. */
bool glint_unit_q30(int32_t out[3], const int32_t v[3]);
/* To Q1.15, |v_i| <= 2^30 + 8; false where what is off by up to slack, < 2^14, might be rounded to another. */
bool glint_vec_of_q30(struct glint_vec *out, const int32_t v[3], int32_t slack);

/* Q2.30 and a half of 2^-15 to Q1.15. */
static inline int32_t glint_vec_cut(int32_t v)
{
#if GLINT_THUMB2
    int32_t rounded; /* > -32769 */
    __asm__("ssat %0, #16, %1, asr #15" : "=r"(rounded) : "r"(v) : "cc");
    return rounded;
#else
    const int32_t rounded = v >> 15;
    return rounded > INT16_MAX ? INT16_MAX : rounded;
#endif
}

/* low to Q1.15; bits from 15 on in what it returns: low + more goes to another. */
static inline uint32_t glint_vec_round(int16_t *out, int32_t low, int32_t more)
{
    *out = (int16_t)glint_vec_cut(low);
    return (uint32_t)(low ^ (low + more));
}

/* The same in place. */
GLINT_VECTOR_INLINE bool glint_vec_near(struct glint_vec *out, const int32_t v[3], int32_t slack)
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

#if GLINT_WIDE

/* ---- the same from products of 64 bits, in place ---- */

/* Of each 2^26 of 2^30 <= a < 2^32 the chord of 2^31 / sqrt(a), off by less than 2^-12.3 of it: its start, and 16 times what it falls by. */
extern const uint32_t glint_root_chords[48];

/* sum + a b 2^-32, rounded down, modulo 2^32. */
GLINT_VECTOR_INLINE int32_t glint_wide_add(int32_t sum, int32_t a, int32_t b)
{
#if GLINT_THUMB2 && defined(__ARM_FEATURE_DSP)
    int32_t result;
    __asm__("smmla %0, %1, %2, %3" : "=r"(result) : "r"(a), "r"(b), "r"(sum));
    return result;
#else
    return (int32_t)((uint32_t)sum + (uint32_t)((int64_t)a * b >> 32));
#endif
}

/* r, nearly 2^47 / sqrt(a) - 2^32, for an a whose floor is given, 2^30 <= a < 2^32: -1.5 .. 4.5 from it (tests/exact/test_unit). With
 * y^2 a = 2^94 (1 + e), |e| < 2^-11.3: 2^47 / sqrt(a) = y (1 - e/2 + 3/8 e^2 - ..); 5/16 e^3 < 2^-35 is left out. */
GLINT_VECTOR_INLINE int32_t glint_wide_inverse(uint32_t a)
{
    const uint32_t chord = glint_root_chords[(a >> 26) - 16];
    const uint32_t y = chord - ((chord & 0xffff) * (a >> 10 & 0xffff) >> 4), yy = (uint32_t)((uint64_t)y * y >> 32);
    const int32_t e = (int32_t)((uint64_t)a * yy >> 32) - (1 << 30);  /* Q30 */
    const int32_t s = e >> 4;                                         /* Q26 */
    const int32_t c = (int32_t)(3 * (uint32_t)(s * s) >> 22) - 4 * e; /* Q33 */
    return glint_wide_add((int32_t)y, (int32_t)(y >> 1), c);
}

/* x (r + 2^32) 2^-32 for |x| < 2^31: low by less than 1, and what r is off by arrives at most by half. */
GLINT_VECTOR_INLINE int32_t glint_wide_part(int32_t x, int32_t r)
{
    return glint_wide_add(x, x, r);
}

/* glint_unit_near of sizes below 2^30. The square is shifted by an even number, sizes by half of it. A part is -1.8 .. 2.3 from the true one, or
 * for a v below 0 -3.3 .. 0.8, and that of glint_unit_q30 -0.5 .. 2.5 or -2.5 .. 0.5, as its length is low by < 1 of 2^29. Whole numbers that
 * differ by -4.3 .. 3.3 differ by at most 4. */
GLINT_VECTOR_INLINE bool glint_wide_unit(struct glint_unit *out, const int32_t v[3])
{
    const uint64_t sum =
        (uint64_t)((int64_t)v[0] * v[0]) + (uint64_t)((int64_t)v[1] * v[1]) + (uint64_t)((int64_t)v[2] * v[2]);
    uint32_t upper = (uint32_t)(sum >> 32), lower = (uint32_t)sum;
    unsigned up = 0; /* twice that of sizes */
    if (__builtin_expect(upper == 0, 0)) {
        upper = lower;
        lower = 0;
        up = 32;
        if (upper == 0)
            return false;
    }
    const unsigned zeros = (unsigned)__builtin_clz(upper) & ~1u;
    up += zeros;
    if (up == 0)
        return false;
    out->square = upper << zeros | lower >> 1 >> (31 ^ zeros);
    out->exponent = 32 - (int32_t)up;
    out->up = up < 4 ? 0 : up / 2 - 2; /* |v| 2^up >= 2^29 */
    const int32_t r = glint_wide_inverse(out->square);
    const unsigned by = up / 2 - 1;
    out->unit_q30[0] = glint_wide_part((int32_t)((uint32_t)v[0] << by), r);
    out->unit_q30[1] = glint_wide_part((int32_t)((uint32_t)v[1] << by), r);
    out->unit_q30[2] = glint_wide_part((int32_t)((uint32_t)v[2] << by), r);
    return true;
}

/* glint_unit_front: l and a part of h are off by less than with products of 32 bits. */
GLINT_VECTOR_INLINE void glint_wide_front(int32_t h[3], const int32_t l[3])
{
    const uint32_t z = (uint32_t)l[2] + GLINT_T_ONE, half = z < (uint32_t)INT32_MAX ? z : (uint32_t)INT32_MAX;
    const int32_t r = glint_wide_inverse(2 * half);
    h[0] = glint_wide_part(l[0], r);
    h[1] = glint_wide_part(l[1], r);
    h[2] = glint_wide_part((int32_t)half, r);
}

#else

/* y, nearly 2^15 / sqrt(x) for x = t 2^-16, 2^14 <= t < 2^16: |1 - (y 2^-15)^2 x| < 0.95 2^-12 for every x of that t; y < 2^16. */
static inline uint32_t glint_root_inverse(uint32_t t)
{
    uint32_t y = 70200 - (40150 * t >> 16);            /* within .09 */
    y = y * (49152 - (t * (y * y >> 16) >> 16)) >> 15; /* y (3 - x y^2) / 2: low by up to .012, so .. */
    y += y >> 8;                                       /* .. within .008 */
    return (y * (49152 - (t * (y * y >> 16) >> 16)) >> 15) + 1;
}

#endif

#endif
