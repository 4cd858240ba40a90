/* SPDX-License-Identifier: MIT
 * Internal. Unit vectors in Q2.30. */
#ifndef GLINT_MATH_VECTOR_H
#define GLINT_MATH_VECTOR_H

#include "glint.h"

/* v / |v|, good to 2^-28; false where v = 0. */
bool glint_unit_q30(int32_t out[3], const int32_t v[3]);
/* To Q1.15, |v_i| <= 2^30 + 8; false where what is off by up to slack, < 2^14, might be rounded to another. */
bool glint_vec_of_q30(struct glint_vec *out, const int32_t v[3], int32_t slack);

/* low to Q1.15; bits from 15 on in what it returns: low + more goes to another. */
static inline uint32_t glint_vec_round(int16_t *out, int32_t low, int32_t more)
{
    const int32_t rounded = low >> 15;
    *out = (int16_t)(rounded > INT16_MAX ? INT16_MAX : rounded);
    return (uint32_t)(low ^ (low + more));
}

/* The same in place. */
static inline bool glint_vec_near(struct glint_vec *out, const int32_t v[3], int32_t slack)
{
    const int32_t half = (1 << 14) - slack, more = 2 * slack;
    uint32_t open = glint_vec_round(&out->x, v[0] + half, more);
    open |= glint_vec_round(&out->y, v[1] + half, more);
    open |= glint_vec_round(&out->z, v[2] + half, more);
    return !(open >> 15);
}

/* Half of l + v; false where the light is straight behind. half may be l or v. */
bool glint_half_q30(int32_t half[3], const int32_t l_q30[3], const int32_t v_q30[3]);
/* From unit vectors; false where the light is straight behind. */
bool glint_light_between(struct glint_light *light, const int32_t l_q30[3], const int32_t v_q30[3]);

#endif
