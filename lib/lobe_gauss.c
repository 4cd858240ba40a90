/* SPDX-License-Identifier: MIT
 * Gauss, eq. (1): F = exp(-n x^2 / 2), x = acos c. One function of c suffices: F = g^n, g = exp(-acos(c)^2 / 2). */
#include "glint_lobe.h"
#include "glint_math.h"

/* g as a polynomial in t = 1 - c, Q1.62, off by < 2^-63 on 0..1; printed by tests/exact/gauss_coefficients.py. */
/* clang-format off */
static const int64_t gauss_coefficient[GLINT_SERIES_DEGREE + 1] GLINT_FLASH = {
    INT64_C(4611686018427387904),
    INT64_C(-4611686018427387904),
    INT64_C(1537228672809129187),
    INT64_C(-204963823041202087),
    INT64_C(10980204804983791),
    INT64_C(-244004529195297),
    INT64_C(-7394449473368),
    INT64_C(-5358566600847),
    INT64_C(-2889535085333),
    INT64_C(-1261383954339),
    INT64_C(-1517806780370),
    INT64_C(2270939252367),
    INT64_C(-6708310050724),
    INT64_C(12548361250167),
    INT64_C(-18818080236510),
    INT64_C(21332030655007),
    INT64_C(-18243119585130),
    INT64_C(11344592357050),
    INT64_C(-4875727488197),
    INT64_C(1297533102584),
    INT64_C(-164032749236),
};
/* clang-format on */

/* g^n in Q0.64, 0 < t <= 1; g is good to 2^-57. As g' <= -0.29 a step of t moves g by 2^-32 at the least: monotone. */
static uint64_t gauss_power(uint32_t n, uint32_t t)
{
    return glint_series_power(gauss_coefficient, n, t);
}

/* ---- quickly: F = 2^-(n t b), b(t) = log2(e) acos(1 - t)^2 / (2 t), 1.44 .. 1.78 ---- */

/* b in Q31, off by < 2^-24.2 of it on 0..1; only the coefficient of t^6 is negative. Printed by
 * tests/exact/gauss_near.py. */
/* clang-format off */
static const uint32_t gauss_exponents[8] GLINT_FLASH = {
    3098163907, 516373763, 137426014, 46347971, 7983879, 21050881, 12874301, 7734345,
};
/* clang-format on */

/* Relative error 2^-28 (-14 .. 13), polynomial and products together. */
static inline uint32_t gauss_exponent(uint32_t t)
{
    const uint32_t x = t << 2;
    uint32_t b = GLINT_FLASH_U32(gauss_exponents[5]) -
                 glint_mulhi_near(
                     GLINT_FLASH_U32(gauss_exponents[6]) - glint_mulhi_near(GLINT_FLASH_U32(gauss_exponents[7]), x), x);
    for (int k = 4; k >= 0; k--)
        b = GLINT_FLASH_U32(gauss_exponents[k]) + glint_mulhi_near(b, x);
    return b;
}

enum { GAUSS_LOW = 7, GAUSS_HIGH = 9 };

/* f with f - HIGH < 2^28 F < f + LOW for 0 < n <= 1000, 0 < t < 1; or 0 where 2^28 F < 31.
 *
 * F = 2^-X, X = n t b. Errors, each in units of its value's last place, and what they make of 2^28 F, L = -ln F:
 *   b       2^-28 (-15 .. 13.5) of it: of X as much  high < 15 F L, low < 13.5 F L
 *   n t     Q28, low by <= 3/4: of X by < 0.67       high < 0.93 F
 *   X       Q27, low by < 3                          high < 4.16 F
 *   2^-x    2^-32 (-34 .. 24) of it                  high < 1.5 F, low < 2.13 F
 *   shifts  low by < 1                               low < 1
 * High: F (15 L + 6.6) <= 8.6, where L = 0.56. Low: F (13.5 L + 2.13) + 1 <= 6.9, where L = 0.84. Proved: tests/proof.
 * Of the model's function and of its loop, so not inlined. */
__attribute__((noinline)) static uint32_t gauss_near_t(uint32_t n, uint32_t t)
{
    const uint32_t whole = n * (t >> 14); /* < 2^26 */
    if (whole >= ((uint32_t)1 << 20) - 1024)
        return 0; /* n t > 15.98: 2^28 F < 31. Below, the sum stays under 2^32: n 2^14 < 1024 2^14 */
    const uint32_t x = glint_mulhi_near((whole << 12) + (n * (t & 0x3fff) >> 2), gauss_exponent(t)); /* Q27 */
    return glint_exp2_near(x & 0x7ffffff) >> 4 >> (x >> 27);
}

/* The normative sequence is gauss_power's; the quick form decides its rounding but for one t in 256. */
uint32_t glint_gauss_t(uint32_t n, uint32_t t)
{
    if (t > GLINT_T_ONE)
        return 0;
    if (t == 0)
        return (uint32_t)GLINT_C_ONE; /* 1.0 has no place in Q0.64 */
    n = glint_clamp_n(n);
    if (t < GLINT_T_ONE) {
        const uint32_t f = gauss_near_t(n, t) + 2048;
        const uint32_t low = (f - GAUSS_HIGH) >> 12;
        if (low == (f + GAUSS_LOW) >> 12)
            return low;
    }
    return glint_power_round(gauss_power(n, t));
}

uint32_t glint_gauss(uint32_t n, int32_t c_q16)
{
    return glint_gauss_t(n, glint_t_of_c(c_q16));
}

static bool gauss_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return gauss_power(n, t) >> (64 - q) != 0;
}

uint32_t glint_gauss_cutoff_t(uint32_t n, unsigned q)
{
    return q == 0 ? 0 : glint_largest_t(gauss_reaches, n, q); /* F >= 1 only at t = 0 */
}

uint32_t glint_gauss_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_gauss_cutoff_t(n, q));
}

/* ---- from below, over a run of samples ---- */

/* Where there is no quick form. (A call of glint_gauss_t would have compilers split that in two.) */
__attribute__((noinline)) static uint32_t gauss_end(uint32_t n, uint32_t t)
{
    return t == 0 ? 65536 : glint_power_round(gauss_power(n, t));
}

/* 2^28 F < f + GAUSS_LOW, and the two bounds together are less than 2^12: F is this or 1 more. F > 0 at t = 1, too,
 * where n is small. */
static inline uint32_t gauss_near(const struct glint_paint *paint, uint32_t t)
{
    if (t == 0 || t == GLINT_T_ONE)
        return gauss_end(paint->of.exact.n, t);
    const uint32_t f = gauss_near_t(paint->of.exact.n, t) + 2048;
    return (f - GAUSS_HIGH) >> 12;
}

static void gauss_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, gauss_near);
}

const struct glint_use_model glint_use_gauss GLINT_FLASH = {
    GLINT_GAUSS, 1, NULL, NULL, gauss_run, glint_gauss_t, glint_gauss_cutoff_t, NULL, NULL};
