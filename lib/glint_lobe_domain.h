/* SPDX-License-Identifier: MIT
 * Internal. The arguments of a lobe: clamped, and one from another. */
#ifndef GLINT_LOBE_DOMAIN_H
#define GLINT_LOBE_DOMAIN_H

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

/* The smallest c whose t = 1 - c is no larger: F falls as t grows. */
static inline uint32_t glint_c_of_cutoff_t(uint32_t t_q30)
{
    return (uint32_t)GLINT_C_ONE - (t_q30 >> 14);
}

#endif
