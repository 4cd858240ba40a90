/* SPDX-License-Identifier: MIT
 * Schlick, eq. (2): F = c / (n - nc + c). */
#include "glint_lobe_domain.h"
#include "glint_lobe_schlick.h"

/* With C = 2^16 c: F 2^16 = C 2^16 / D, D = n(2^16 - C) + C <= 2^26; C 2^16 + D/2 < 2^32 for C < 2^16.
 * One tie: C = 32896, n = 513. */
uint32_t glint_schlick(uint32_t n, int32_t c_q16)
{
    if (c_q16 <= 0)
        return 0;
    if (c_q16 >= GLINT_C_ONE)
        return (uint32_t)GLINT_C_ONE;
    const uint32_t c = (uint32_t)c_q16;
    const uint32_t d = glint_clamp_n(n) * ((uint32_t)GLINT_C_ONE - c) + c;
    return ((c << 16) + (d >> 1)) / d;
}

/* With T = 2^30 t: F 2^16 = (2^30 - T) 2^16 / d, d = 2^30 + (n - 1) T < 2^40. The approximation decides the rounding but
 * for one t in 370. */
uint32_t glint_schlick_t(uint32_t n, uint32_t t)
{
    if (t >= GLINT_T_ONE)
        return 0;
    if (t == 0)
        return (uint32_t)GLINT_C_ONE;
    n = glint_clamp_n(n);
    const uint32_t f = glint_schlick_near_t(n, t) + 2048;
    const uint32_t low = (f - GLINT_SCHLICK_HIGH) >> 12;
    if (low == (f + GLINT_SCHLICK_LOW) >> 12)
        return low;
    const uint64_t d = GLINT_T_ONE + (uint64_t)(n - 1) * t;
    return (uint32_t)((((uint64_t)(GLINT_T_ONE - t) << 17) + d) / (2 * d));
}

/* Exactly eq. (10): F >= 2^-q  <=>  t <= (2^q - 1) / (n + 2^q - 1). */
uint32_t glint_schlick_cutoff_t(uint32_t n, unsigned q)
{
    const uint32_t k = ((uint32_t)1 << glint_clamp_q(q)) - 1;
    return (uint32_t)(((uint64_t)k << 30) / (glint_clamp_n(n) + k));
}

uint32_t glint_schlick_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_schlick_cutoff_t(n, q));
}
