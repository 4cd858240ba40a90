/* SPDX-License-Identifier: MIT
 * Blinn and Phong, eq. (1): F = c^n. */
#include "glint_lobe.h"
#include "glint_math.h"

static uint64_t blinn_power(uint32_t n, uint32_t t)
{
    return glint_power((uint64_t)(GLINT_T_ONE - t) << 34, n);
}

/* The normative sequence: within 2^-37 ulp before rounding, which is enough: no c_q16 but the tie c = 1/2, n = 17, where
 * the power is exact, lies that near to a half. (From t some may: 0.501 ulp is promised.) glint_power_near decides its
 * rounding but for one t in 65536 / (3n - 1). */
uint32_t glint_blinn_t(uint32_t n, uint32_t t)
{
    if (t >= GLINT_T_ONE)
        return 0;
    if (t == 0)
        return (uint32_t)GLINT_C_ONE; /* 1.0 has no place in Q0.64 */
    n = glint_clamp_n(n);
    const uint32_t near = glint_power_near((GLINT_T_ONE - t) << 2, n), low = (near >> 1) + 16384;
    if ((low ^ (low + (GLINT_POWER_LOW(n) + 1) / 2)) >> 15 == 0)
        return low >> 15;
    return glint_power_round(blinn_power(n, t));
}

uint32_t glint_blinn(uint32_t n, int32_t c_q16)
{
    return glint_blinn_t(n, glint_t_of_c(c_q16));
}

/* Powers of two, where F = 2^-q can hold exactly, are exact; elsewhere the margin is tested for every n and q. */
static bool blinn_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return blinn_power(n, t) >> (64 - q) != 0;
}

uint32_t glint_blinn_cutoff_t(uint32_t n, unsigned q)
{
    return q == 0 ? 0 : glint_largest_t(blinn_reaches, n, q); /* F >= 1 only at t = 0 */
}

uint32_t glint_blinn_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_blinn_cutoff_t(n, q));
}

/* ---- from below, over a run of samples ---- */

/* The power is f 2^-32 or up to 3n - 2 < 2^12 more of 2^-32: F is this or 1 more. */
static inline uint32_t blinn_near(const struct glint_paint *paint, uint32_t t)
{
    return t == 0 ? 65536 : ((glint_power_near((GLINT_T_ONE - t) << 2, paint->of.exact.n) >> 15) + 1) >> 1;
}

void glint_blinn_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, blinn_near);
}

const struct glint_use_model glint_use_blinn GLINT_FLASH = {
    GLINT_BLINN, 1, NULL, NULL, glint_blinn_run, glint_blinn_t, glint_blinn_cutoff_t, NULL, NULL};
