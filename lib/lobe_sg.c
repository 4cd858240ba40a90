/* SPDX-License-Identifier: MIT
 * The spherical Gaussian, F = exp(-n (1 - c)) = g^n, g = exp(-t). */
#include "glint_lobe.h"
#include "glint_math.h"

/* g as a polynomial in t, Q1.62: its series, off by < 2^-62 on 0..1; printed by tests/exact/exponential.py. */
/* clang-format off */
static const int64_t sg_coefficient[GLINT_SERIES_DEGREE + 1] GLINT_FLASH = {
    INT64_C(4611686018427387904),
    INT64_C(-4611686018427387904),
    INT64_C(2305843009213693952),
    INT64_C(-768614336404564651),
    INT64_C(192153584101141163),
    INT64_C(-38430716820228233),
    INT64_C(6405119470038039),
    INT64_C(-915017067148291),
    INT64_C(114377133393536),
    INT64_C(-12708570377060),
    INT64_C(1270857037706),
    INT64_C(-115532457973),
    INT64_C(9627704831),
    INT64_C(-740592679),
    INT64_C(52899477),
    INT64_C(-3526632),
    INT64_C(220414),
    INT64_C(-12966),
    INT64_C(720),
    INT64_C(-38),
    INT64_C(2),
};
/* clang-format on */

/* g^n in Q0.64, 0 < t <= 1; g is good to 2^-57. As g' <= -0.36 a step of t moves g by 2^-32 at the least: monotone. */
static uint64_t sg_power(uint32_t n, uint32_t t)
{
    return glint_series_power(sg_coefficient, n, t);
}

/* ---- quickly: F = 2^-(n t log2(e)) ---- */

#define SG_EXPONENT UINT32_C(3098164009) /* log2(e) in Q31, low by less than 2^-33 of it */
enum { SG_LOW = 4, SG_HIGH = 7 };

/* f with f - HIGH < 2^28 F < f + LOW for 0 < n <= 1000, 0 <= t <= 1; or 0 where 2^28 F < 31.
 *
 * F = 2^-X, X = n t log2(e). Errors, each in units of its value's last place, and what they make of 2^28 F, L = -ln F:
 *   log2(e)   2^-33 of it: of X as much              high < 0.04 F L
 *   n t       Q28, low by <= 3/4: of X by < 0.55     high < 0.77 F
 *   X         Q27, low by < 3                        high < 4.16 F
 *   2^-x      2^-32 (-34 .. 24) of it                high < 1.5 F, low < 2.13 F
 *   shifts    low by < 1                             low < 1
 * High: < 6.5. Low: < 3.2. */
static inline uint32_t sg_near_t(uint32_t n, uint32_t t)
{
    const uint32_t whole = n * (t >> 14); /* < 2^26 */
    if (whole >= ((uint32_t)1 << 20) - 1024)
        return 0; /* n t > 15.98: 2^28 F < 31. Below, the sum stays under 2^32: n 2^14 < 1024 2^14 */
    const uint32_t x = glint_mulhi_near((whole << 12) + (n * (t & 0x3fff) >> 2), SG_EXPONENT); /* Q27 */
    return glint_exp2_near(x & 0x7ffffff) >> 4 >> (x >> 27);
}

/* The normative sequence is sg_power's; the quick form decides its rounding but for one t in 370. */
uint32_t glint_sg_t(uint32_t n, uint32_t t)
{
    if (t > GLINT_T_ONE)
        return 0;
    n = glint_clamp_n(n);
    const uint32_t f = sg_near_t(n, t) + 2048;
    const uint32_t low = (f - SG_HIGH) >> 12;
    if (low == (f + SG_LOW) >> 12) /* so at t = 0, too, where 1.0 has no place in Q0.64 */
        return low;
    return glint_power_round(sg_power(n, t));
}

uint32_t glint_sg(uint32_t n, int32_t c_q16)
{
    return glint_sg_t(n, glint_t_of_c(c_q16));
}

static bool sg_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return sg_power(n, t) >> (64 - q) != 0;
}

uint32_t glint_sg_cutoff_t(uint32_t n, unsigned q)
{
    return q == 0 ? 0 : glint_largest_t(sg_reaches, n, q); /* F >= 1 only at t = 0 */
}

uint32_t glint_sg_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_sg_cutoff_t(n, q));
}

/* ---- from below, over a run of samples ---- */

/* 2^28 F < f + SG_LOW, and the two bounds together are less than 2^12: F is this or 1 more. */
__attribute__((flatten)) static inline uint32_t sg_near(const struct glint_paint *paint, uint32_t t)
{
    return (sg_near_t(paint->of.exact.n, t) + 2048 - SG_HIGH) >> 12;
}

static void sg_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, sg_near);
}

const struct glint_use_model glint_use_sg GLINT_FLASH = {GLINT_SG,          1,    NULL, NULL, sg_run, glint_sg_t,
                                                         glint_sg_cutoff_t, NULL, NULL};
