/* SPDX-License-Identifier: MIT */
#include "glint_lobe.h"

uint32_t glint_largest_t(bool (*reaches)(uint32_t n, uint32_t t_q30, unsigned q), uint32_t n, unsigned q)
{
    n = glint_clamp_n(n);
    q = glint_clamp_q(q);
    uint32_t t = 0;
    for (uint32_t bit = GLINT_T_ONE; bit; bit >>= 1)
        if (bit <= GLINT_T_ONE - t && reaches(n, t + bit, q))
            t += bit;
    return t;
}
