/* SPDX-License-Identifier: MIT
 * Schlick, eq. (2): F = c / (n - nc + c). */
#include "glint_grain.h"
#include "glint_math.h"

enum { SCHLICK_LOW = 6, SCHLICK_HIGH = 5 };

/* f with f - HIGH < 2^28 F < f + LOW for 0 < n <= 1000, 0 < t < 1.
 *
 * F = u / d, u = 2^30 - T, d = 2^30 + (n - 1) T = 2^(14 - up) m, T = 2^30 t, 2^27 <= m < 2^28.
 * Errors of 2^28 F <= 2^28:
 *   reciprocal   2^-30 (-16.1 .. 16.4) of F        low < 4.1, high < 4.1
 *   product      low by < 3 2^-(42 - up) of F, up <= 11        low < 3/8
 *   shift        low by < 1 */
static inline uint32_t schlick_near_t(uint32_t n, uint32_t t)
{
    const uint32_t rest = (n - 1) * (t & 0x3fff);                                 /* < 2^24 */
    uint32_t m = (((uint32_t)1 << 16) + (n - 1) * (t >> 14) + (rest >> 14)) << 2; /* 2^18 .. 2^28: up = 2 */
    unsigned down = 12;                                                           /* 14 - up */
    if (m >> 23 == 0) {
        m <<= 5;
        down -= 5;
    }
    if (m >> 25 == 0) {
        m <<= 2;
        down -= 2;
    }
    if (m >> 26 == 0) {
        m <<= 1;
        down--;
    }
    if (m >> 27 == 0) {
        m <<= 1;
        down--;
    }
    m |= (rest & 0x3fff) >> down;
    return glint_mulhi_near((((uint32_t)1 << 30) - t) << 2, glint_reciprocal(m)) >> down;
}

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
    const uint32_t f = schlick_near_t(n, t) + 2048;
    const uint32_t low = (f - SCHLICK_HIGH) >> 12;
    if (low == (f + SCHLICK_LOW) >> 12)
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

/* ---- from below, over a run of samples ---- */

/* 2^28 F < f + SCHLICK_LOW, and the two bounds together are less than 2^12: F is this or 1 more. */
__attribute__((flatten)) static inline uint32_t schlick_near(const struct glint_paint *paint, uint32_t t)
{
    return t == 0 ? 65536 : (schlick_near_t(paint->of.exact.n, t) + 2048 - SCHLICK_HIGH) >> 12;
}

static void schlick_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, schlick_near);
}

const struct glint_use_model glint_use_schlick GLINT_FLASH = {GLINT_SCHLICK,
                                                              1,
                                                              NULL,
                                                              NULL,
                                                              schlick_run,
                                                              glint_schlick_t,
                                                              glint_schlick_cutoff_t,
                                                              NULL,
                                                              GLINT_LINE_OF(glint_line_schlick)};

/* ---- of t and m: F = u / d, d = u + M, M = 2^30 m ---- */

static inline uint64_t schlick_grain_divisor(uint32_t m, uint32_t t)
{
    return ((uint64_t)m << 8) + (GLINT_T_ONE - t);
}

static uint32_t schlick_grain(uint32_t m, uint32_t t)
{
    const uint64_t d = schlick_grain_divisor(m, t), u = GLINT_T_ONE - t;
    return u ? (uint32_t)(((u << 17) + d) / (2 * d)) : 0;
}

static __attribute__((noinline)) bool schlick_grain_reaches(uint32_t m, uint32_t t, unsigned q)
{
    const uint64_t u = GLINT_T_ONE - t;
    return u && u << q >= schlick_grain_divisor(m, t);
}

/* F rises with c: it is at most 1 / (m + 1). */
static uint32_t schlick_grain_end(unsigned q)
{
    return q < 10 ? ((((uint32_t)1 << q) - 1) << GLINT_GRAIN_BITS) + 1 : GLINT_GRAIN_MOST + 1;
}

/* As schlick_near_t; d > 2^30 - 2^8, as m >= t - 2^-22. u = 2^30 is taken for 1 less: that makes f low by 1/4 more. */
static inline uint32_t schlick_grain_near(uint32_t scale, uint32_t m, uint32_t t)
{
    const uint32_t u = GLINT_T_ONE - t, rest = ((m & 0x3f) << 8) + (u & 0x3fff); /* < 2^15 */
    uint32_t d = ((m >> 6) + (u >> 14) + (rest >> 14)) << 2;                     /* <= 2^28 - 2^23 + 2^18 */
    unsigned down = 12;
    (void)scale;
    while (!(d >> 27)) {
        d <<= 1;
        down--;
    }
    d |= (rest & 0x3fff) >> down;
    return (((glint_mulhi_near((u - (u >> 30)) << 2, glint_reciprocal(d)) >> down) + 2048 - SCHLICK_HIGH) >> 12);
}

__attribute__((flatten)) static void schlick_grain_run(const struct glint_paint *paint, struct glint_sample *samples,
                                                       unsigned count)
{
    glint_grain_run(paint, samples, count, schlick_grain_end(glint_clamp_q(paint->material.q)), schlick_grain_near, 0,
                    schlick_grain_reaches);
}

static const struct glint_use_grain schlick_use_grain GLINT_FLASH = {
    schlick_grain_end, schlick_grain_run, schlick_grain, schlick_grain_reaches, GLINT_GRAIN_USE};
const struct glint_use_model glint_use_schlick_grain GLINT_FLASH = {GLINT_SCHLICK,
                                                                    1,
                                                                    NULL,
                                                                    NULL,
                                                                    schlick_run,
                                                                    glint_schlick_t,
                                                                    glint_schlick_cutoff_t,
                                                                    &schlick_use_grain,
                                                                    GLINT_LINE_OF(glint_line_schlick)};
