/* SPDX-License-Identifier: MIT
 * Cayley, an extension, not of the paper: c^n for n <= 4, else r^4, r = (4(1+c) - n(1-c)) / (4(1+c) + n(1-c)), 0 where
 * r < 0. It comes from c = (1 - x) / (1 + x): n such factors are nearly 4 of (1 - nx/4) / (1 + nx/4).
 *
 * With T = 2^30 t: r = p / s, p = 2^33 - (n + 4) T, s = 2^33 + (n - 4) T. Where p > 0, s < 2 * 2^33. An approximation in
 * 32 bits decides the rounding but for one t in 108; there an exact comparison of p^4 and s^4 does. */
#include "glint_grain.h"
#include "glint_math.h"

enum { CAYLEY_LOW = 21, CAYLEY_HIGH = 17 };

/* f with f - HIGH < 2^28 F < f + LOW for 4 < n <= 1000, 0 < t < 1; 0 where F = 0.
 *
 * F = r^4, r = p / s, p = 2^33 - (n + 4) T, s = 2^33 + (n - 4) T, T = 2^30 t; where p > 0, 2^33 <= s < 2^34.
 * Errors, each in units of its value's last place, and what they make of 2^28 F = 2^28 r^4:
 *   p / 2        high by <= 1/2, as v is rounded down: of r by < 1/4            high < 1/8
 *   reciprocal   2^-30 (-16.1 .. 16.4), four times in r^4                       low < 16.1, high < 16.4
 *   r            low by < 3 2^-31, four times                                   low < 3/2
 *   r^2          low by < 2 2^-30, twice                                        low < 1
 *   r^4          low by < 2 2^-28                                               low < 2
 * and the squares of these, less than 2^-20 of them. */
static inline uint32_t cayley_near_t(uint32_t n, uint32_t t)
{
    const uint32_t fall = (n + 4) * (t >> 14), rest = (n + 4) * (t & 0x3fff) >> 1; /* < 2^26, < 2^23 */
    if (fall >> 19)
        return 0;
    const uint32_t v = (fall << 13) + rest; /* (n + 4) T / 2, rounded down */
    if (v < rest)
        return 0;
    const uint32_t m = ((uint32_t)1 << 27) + ((v - (t << 2)) >> 5);  /* s / 2^6, rounded down */
    const uint32_t r = glint_mulhi_near(0 - v, glint_reciprocal(m)); /* Q31 */
    return glint_squarehi_near(glint_squarehi_near(r));              /* Q30, Q28 */
}

enum { CAYLEY_LIMBS = 5 }; /* of 32 bits, least significant first */

/* x^4 for x < 2^34. */
static void cayley_fourth(uint32_t out[CAYLEY_LIMBS], uint64_t x)
{
    /* x^2 = c2 2^64 + c1 2^32 + c0, c2 < 16 */
    const uint32_t low = (uint32_t)x, high = (uint32_t)(x >> 32); /* high < 4 */
    const uint64_t low2 = glint_multiply(low, low);
    const uint64_t middle = (low2 >> 32) + 2 * glint_multiply(low, high);
    const uint32_t c0 = (uint32_t)low2, c1 = (uint32_t)middle, c2 = (uint32_t)(middle >> 32) + high * high;
    const uint64_t a = glint_multiply(c0, c0), b = glint_multiply(c0, c1), c = glint_multiply(c1, c1);
    uint64_t sum = (a >> 32) + 2 * (uint64_t)(uint32_t)b; /* each sum < 2^38 */
    out[0] = (uint32_t)a;
    out[1] = (uint32_t)sum;
    sum = (sum >> 32) + 2 * (b >> 32) + (uint32_t)c + 2 * glint_multiply(c0, c2);
    out[2] = (uint32_t)sum;
    sum = (sum >> 32) + (c >> 32) + 2 * glint_multiply(c1, c2);
    out[3] = (uint32_t)sum;
    out[4] = (uint32_t)(sum >> 32) + c2 * c2;
}

/* r^4 >= m 2^-17, exactly, for p > 0 and m < 2^18: both sides < 2^154. There are no ties for odd m: 17 is odd. */
static inline __attribute__((always_inline)) bool cayley_ratio_at_least(uint64_t ratio_p, uint64_t ratio_s, uint32_t m)
{
    uint32_t left[CAYLEY_LIMBS], right[CAYLEY_LIMBS];
    cayley_fourth(left, ratio_p);
    cayley_fourth(right, ratio_s);
    uint32_t before = 0;
    uint64_t product = 0;
    bool at_least = true;
    for (int i = 0; i < CAYLEY_LIMBS; i++) {
        const uint32_t p = left[i] << 17 | before >> 15;
        before = left[i];
        product = (product >> 32) + glint_multiply(right[i], m);
        if (p != (uint32_t)product)
            at_least = p > (uint32_t)product;
    }
    return at_least;
}

static __attribute__((noinline)) bool cayley_at_least(uint32_t n, uint32_t t, uint32_t m)
{
    return cayley_ratio_at_least(((uint64_t)1 << 33) - glint_multiply(n + 4, t),
                                 ((uint64_t)1 << 33) + glint_multiply(n - 4, t), m);
}

__attribute__((flatten)) uint32_t glint_cayley_t(uint32_t n, uint32_t t)
{
    n = glint_clamp_n(n);
    if (n <= 4)
        return glint_blinn_t(n, t); /* exact: see glint_power */
    if (t == 0)
        return (uint32_t)GLINT_C_ONE;
    if (t >= GLINT_T_ONE)
        return 0;
    const uint32_t f = cayley_near_t(n, t) + 2048;
    const uint32_t low = (f - CAYLEY_HIGH) >> 12, high = (f + CAYLEY_LOW) >> 12;
    return low == high || !cayley_at_least(n, t, 2 * high - 1) ? low : high;
}

uint32_t glint_cayley(uint32_t n, int32_t c_q16)
{
    return glint_cayley_t(n, glint_t_of_c(c_q16));
}

static bool cayley_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return (uint64_t)(n + 4) * t >> 33 == 0 && cayley_at_least(n, t, (uint32_t)1 << (17 - q));
}

uint32_t glint_cayley_cutoff_t(uint32_t n, unsigned q)
{
    return glint_clamp_n(n) <= 4 ? glint_blinn_cutoff_t(n, q) : glint_largest_t(cayley_reaches, n, q);
}

uint32_t glint_cayley_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_cayley_cutoff_t(n, q));
}

/* ---- from below, over a run of samples ---- */

/* 2^28 F < f + CAYLEY_LOW, and the two bounds together are less than 2^12: F is this or 1 more. */
__attribute__((flatten)) static inline uint32_t cayley_near(const struct glint_paint *paint, uint32_t t)
{
    return t == 0 ? 65536 : (cayley_near_t(paint->of.exact.n, t) + 2048 - CAYLEY_HIGH) >> 12;
}

static void cayley_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    if (paint->of.exact.n > 4)
        glint_near_run(paint, samples, count, cayley_near);
    else
        glint_blinn_run(paint, samples, count);
}

const struct glint_use_model glint_use_cayley GLINT_FLASH = {GLINT_CAYLEY,
                                                             1,
                                                             NULL,
                                                             NULL,
                                                             cayley_run,
                                                             glint_cayley_t,
                                                             glint_cayley_cutoff_t,
                                                             NULL,
                                                             GLINT_LINE_OF(glint_line_cayley)};

/* ---- of t and m, as r^4 for every n: p = 2^33 - 4 T - M, s = 2^33 - 4 T + M, M = 2^30 m ---- */

static inline uint64_t cayley_grain_p(uint32_t m, uint32_t t) /* p > 0, or above 2^63 */
{
    return ((uint64_t)1 << 33) - 4 * (uint64_t)t - ((uint64_t)m << 8);
}

static inline uint64_t cayley_grain_s(uint32_t m, uint32_t t)
{
    return ((uint64_t)1 << 33) - 4 * (uint64_t)t + ((uint64_t)m << 8);
}

/* As cayley_near_t, but s may be less than 2^33, by half at most: then r is twice what is multiplied, and low by up to 6 2^-31. */
enum { CAYLEY_GRAIN_LOW = CAYLEY_LOW + 2 };
static inline uint32_t cayley_grain_quick(uint32_t m, uint32_t t)
{
    const uint32_t v = (m << 7) + 2 * t; /* 2^32 - p / 2, m < 2^25 */
    if (v < 2 * t)
        return 0;
    uint32_t s = ((uint32_t)1 << 27) + 4 * m - ((t + 15) >> 4); /* s / 2^6, rounded down, >= 2^26 */
    unsigned up = 0;
    if (!(s >> 27)) {
        s = ((uint32_t)1 << 28) + 8 * m - ((t + 7) >> 3);
        up = 1;
    }
    const uint32_t r = glint_mulhi_near(0 - v, glint_reciprocal(s)) << up; /* Q31 */
    return glint_squarehi_near(glint_squarehi_near(r));
}

static uint32_t cayley_grain(uint32_t m, uint32_t t)
{
    const uint64_t p = cayley_grain_p(m, t);
    if (m == 0)
        return (uint32_t)GLINT_C_ONE;
    if (m >> 25 || (int64_t)p <= 0)
        return 0;
    const uint32_t f = cayley_grain_quick(m, t) + 2048;
    const uint32_t low = (f - CAYLEY_HIGH) >> 12, high = (f + CAYLEY_GRAIN_LOW) >> 12;
    return low == high || !cayley_ratio_at_least(p, cayley_grain_s(m, t), 2 * high - 1) ? low : high;
}

static __attribute__((noinline)) bool cayley_grain_reaches(uint32_t m, uint32_t t, unsigned q)
{
    const uint64_t p = cayley_grain_p(m, t);
    return (int64_t)p > 0 && cayley_ratio_at_least(p, cayley_grain_s(m, t), (uint32_t)1 << (17 - q));
}

/* p > 0 where m < 4 (1 + c) alone. */
static uint32_t cayley_grain_end(unsigned q)
{
    (void)q;
    return (uint32_t)8 << GLINT_GRAIN_BITS;
}

static inline uint32_t cayley_grain_near(uint32_t scale, uint32_t m, uint32_t t)
{
    (void)scale;
    return m == 0 ? 65536 : (cayley_grain_quick(m, t) + 2048 - CAYLEY_HIGH) >> 12;
}

__attribute__((flatten)) static void cayley_grain_run(const struct glint_paint *paint, struct glint_sample *samples,
                                                      unsigned count)
{
    glint_grain_run(paint, samples, count, cayley_grain_end(0), cayley_grain_near, 0, cayley_grain_reaches);
}

static const struct glint_use_grain cayley_use_grain GLINT_FLASH = {cayley_grain_end, cayley_grain_run, cayley_grain,
                                                                    cayley_grain_reaches, GLINT_GRAIN_USE};
const struct glint_use_model glint_use_cayley_grain GLINT_FLASH = {GLINT_CAYLEY,
                                                                   1,
                                                                   NULL,
                                                                   NULL,
                                                                   cayley_run,
                                                                   glint_cayley_t,
                                                                   glint_cayley_cutoff_t,
                                                                   &cayley_use_grain,
                                                                   GLINT_LINE_OF(glint_line_cayley)};
