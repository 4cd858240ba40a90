/* SPDX-License-Identifier: MIT
 * What the files of this folder share; not for users. Right shifts of negative numbers are arithmetic, as in every
 * compiler that glint is built with (C99 leaves it to them; the tests would show another). */
#ifndef GLINT_INTERNAL_H
#define GLINT_INTERNAL_H

#include "glint.h"

static inline uint32_t glint_clamp_n(uint32_t n)
{
    return n < 1 ? 1 : n > GLINT_N_MAX ? GLINT_N_MAX : n;
}

static inline unsigned glint_clamp_q(unsigned q)
{
    return q > GLINT_Q_MAX ? GLINT_Q_MAX : q;
}

/* t of a cosine, exactly: Q16 has fewer bits. For c > 1 it is 0, for c < 0 more than 1. */
static inline uint32_t glint_t_of_c(int32_t c_q16)
{
    return c_q16 < 0 ? UINT32_MAX : c_q16 > GLINT_C_ONE ? 0 : (uint32_t)(GLINT_C_ONE - c_q16) << 14;
}

/* The reduction of glint_shade_span_c16: the nearest c of a span's t; negative where the surface faces away. */
static inline int32_t glint_c_of_t(uint32_t t_q30)
{
    return GLINT_C_ONE - (int32_t)((t_q30 + (1 << 13)) >> 14); /* t < 0xf8000000: the sum does not wrap */
}

/* ---- alignment ---- */

/* What a type wants: on 8-bit machines, whose compilers place everything anywhere, 1. */
struct glint_align_16 {
    char before;
    uint16_t at;
};
struct glint_align_32 {
    char before;
    uint32_t at;
};
#define GLINT_MISALIGNED(address_or_stride, bits)                                                                      \
    ((uintptr_t)(address_or_stride) % offsetof(struct glint_align_##bits, at) != 0)

/* ---- power.c: x^n in Q0.64, x < 1 ---- */

/* In (x^n - n 2^-64, x^n]; monotone in x; the exact floor for n <= 4 where x has 30 bits. */
uint64_t glint_power(uint64_t x, uint32_t n);

static inline uint32_t glint_power_round(uint64_t power)
{
    return (uint32_t)(((power >> 47) + 1) >> 1); /* Q0.64 -> Q16.16, nearest, ties up */
}

/* ---- wide.c: integers of 192 bits, for decisions that must be exact ---- */

struct glint_wide {
    uint32_t limb[6]; /* least significant first */
};
void glint_wide_set(struct glint_wide *a, uint64_t value);
void glint_wide_mul(struct glint_wide *a, uint64_t factor); /* modulo 2^192 */
bool glint_wide_ge(const struct glint_wide *a, const struct glint_wide *b);

/* ---- root.c: the square root of x < 2^62, rounded down ---- */

uint32_t glint_root(uint64_t x);

/* ---- vector.c ---- */

/* v / |v| in Q2.30, good to 2^-28; false where v = 0. */
bool glint_unit_q30(int32_t out[3], const int32_t v[3]);
/* From unit vectors in Q2.30; false where the light is straight behind. */
bool glint_light_between(struct glint_light *light, const int32_t l_q30[3], const int32_t v_q30[3]);

/* ---- largest_t.c: the largest t in 0..2^30 for which reaches() holds; it holds at 0 and stops holding once ---- */

uint32_t glint_largest_t(bool (*reaches)(uint32_t n, uint32_t t_q30, unsigned q), uint32_t n, unsigned q);
/* The smallest c whose t = 1 - c is no larger: F falls as t grows. */
static inline uint32_t glint_c_of_cutoff_t(uint32_t t_q30)
{
    return (uint32_t)GLINT_C_ONE - (t_q30 >> 14);
}

#endif
