/* SPDX-License-Identifier: MIT */
#include "glint_math_wide.h"

enum { LIMBS = 6 };

void glint_wide_set(struct glint_wide *a, uint64_t value)
{
    a->limb[0] = (uint32_t)value;
    a->limb[1] = (uint32_t)(value >> 32);
    for (int i = 2; i < LIMBS; i++)
        a->limb[i] = 0;
}

void glint_wide_mul(struct glint_wide *a, uint64_t factor)
{
    const uint32_t f[2] = {(uint32_t)factor, (uint32_t)(factor >> 32)};
    uint32_t product[LIMBS] = {0};
    for (int i = 0; i < LIMBS; i++) {
        uint64_t carry = 0;
        for (int j = 0; i + j < LIMBS; j++) {
            carry += (j < 2 ? (uint64_t)a->limb[i] * f[j] : 0) + product[i + j];
            product[i + j] = (uint32_t)carry;
            carry >>= 32;
        }
    }
    for (int i = 0; i < LIMBS; i++)
        a->limb[i] = product[i];
}

bool glint_wide_ge(const struct glint_wide *a, const struct glint_wide *b)
{
    for (int i = LIMBS - 1; i >= 0; i--)
        if (a->limb[i] != b->limb[i])
            return a->limb[i] > b->limb[i];
    return true;
}
