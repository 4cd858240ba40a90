/* SPDX-License-Identifier: MIT
 * Cayley, an extension, not of the paper: c^n for n <= 4, else r^4, r = (4(1+c) - n(1-c)) / (4(1+c) + n(1-c)), 0 where
 * r < 0. It comes from c = (1 - x) / (1 + x): n such factors are nearly 4 of (1 - nx/4) / (1 + nx/4). */
#include "glint_lobe_domain.h"
#include "glint_lobe_largest_t.h"
#include "glint_math_wide.h"

/* With T = 2^30 t: r = p / s, p = 2^33 - (n + 4) T, s = 2^33 + (n - 4) T. Where p > 0, s < 2 * 2^33. */
static uint64_t cayley_numerator(uint32_t n, uint32_t t)
{
    const uint64_t fall = (uint64_t)(n + 4) * t;
    return fall < (uint64_t)1 << 33 ? ((uint64_t)1 << 33) - fall : 0;
}

static uint64_t cayley_denominator(uint32_t n, uint32_t t)
{
    return ((uint64_t)1 << 33) + (uint64_t)(n - 4) * t;
}

/* r^4 >= m 2^-k, exactly, for p > 0, m < 2^18 and k <= 17: both sides < 2^154. There are no ties: 17 is odd. */
static bool cayley_at_least(uint32_t n, uint32_t t, uint32_t m, unsigned k)
{
    const uint64_t p = cayley_numerator(n, t), s = cayley_denominator(n, t);
    struct glint_wide left, right;
    glint_wide_set(&left, (uint64_t)1 << k);
    glint_wide_set(&right, m);
    for (int i = 0; i < 4; i++) {
        glint_wide_mul(&left, p);
        glint_wide_mul(&right, s);
    }
    return glint_wide_ge(&left, &right);
}

/* One division of 64 bits gives F within 3 * 2^-12 ulp; where that does not settle the rounding (one t in 1300), the
 * exact comparison does. */
uint32_t glint_cayley_t(uint32_t n, uint32_t t)
{
    n = glint_clamp_n(n);
    if (n <= 4)
        return glint_blinn_t(n, t); /* exact: see glint_power */
    if (t == 0)
        return (uint32_t)GLINT_C_ONE;
    if (t >= GLINT_T_ONE)
        return 0;
    const uint64_t p = cayley_numerator(n, t);
    if (p == 0)
        return 0;
    const uint64_t r = (p << 30) / cayley_denominator(n, t); /* Q30, low by < 1; p < 2^33, so r < 2^30 */
    const uint64_t r2 = (r * r) >> 28;                       /* Q32, low by < 2^-30 * 2 + 2^-32 */
    const uint64_t y = (r2 * r2) >> 36;                      /* F 2^16 in Q12, low by < 1 (of r) + 1/8 (of r2) + 1 */
    const uint32_t low = (uint32_t)((y + 2048) >> 12);
    const uint32_t high = (uint32_t)((y + 3 + 2048) >> 12);
    return low == high || !cayley_at_least(n, t, 2 * high - 1, 17) ? low : high;
}

uint32_t glint_cayley(uint32_t n, int32_t c_q16)
{
    return glint_cayley_t(n, glint_t_of_c(c_q16));
}

static bool cayley_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return cayley_numerator(n, t) != 0 && cayley_at_least(n, t, 1, q);
}

uint32_t glint_cayley_cutoff_t(uint32_t n, unsigned q)
{
    return glint_clamp_n(n) <= 4 ? glint_blinn_cutoff_t(n, q) : glint_largest_t(cayley_reaches, n, q);
}

uint32_t glint_cayley_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_cayley_cutoff_t(n, q));
}
