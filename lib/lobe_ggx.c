/* SPDX-License-Identifier: MIT
 * GGX, its peak 1: F = 1 / e^2, e = 1 + n (1 - c^2) / 2 = 1 + n t (2 - t) / 2. Walter et al. 2007, Microfacet Models for Refraction
 * through Rough Surfaces, with alpha^2 = 2 / (n + 2). At c = 0 it is not 0, and nothing is lit beyond: F steps there.
 *
 * With T = 2^30 t: e = D / 2^61, D = 2^61 + n T (2^31 - T). An approximation in 32 bits decides most roundings, elsewhere an exact
 * comparison of products does. There are no ties: m D^2 = 2^139 has no solution for odd m, but D^2 = 2^139, which is no square. */
#include "glint_grain.h"
#include "glint_math.h"

/* t (2 - t) in Q32, 0 < t <= 1; low by at most 2, never high. (1 is taken for 1 - 2^-30, where that is 2^-60 less.) */
static inline uint32_t ggx_sine(uint32_t t)
{
    t -= t >> 30;
    return (t << 3) - 2 - glint_squarehi_near(t << 2);
}

enum { GGX_LOW = 10 };
static inline uint32_t ggx_high(uint32_t n)
{
    return (n >> 3) + 10;
}

/* f with f - ggx_high(n) < 2^28 F < f + LOW for 0 < n <= 1000, 0 < t <= 1.
 *
 * e = 2^(18 - up) 2^-36 m, 2^27 <= m < 2^28. Errors of 2^28 F <= 2^28:
 *   t (2 - t)    low by <= 2 2^-32: of e by <= n 2^-32, twice in F  high <= n / 8
 *   reciprocal   2^-30 (-16.1 .. 16.4) of 1 / e, twice               low < 8.1, high < 8.3
 *   square       low by < 2 2^-30 of at most 1                       low < 1/2
 *   shift        low by < 1 */
static inline uint32_t ggx_near_t(uint32_t n, uint32_t t)
{
    const uint32_t x = ggx_sine(t), rest = n * (x & 0x7fff);                /* < 2^25 */
    uint32_t m = (((uint32_t)1 << 18) + n * (x >> 15) + (rest >> 15)) << 1; /* 2^19 .. 2^28: up = 1 */
    unsigned down = 14;                                                     /* 15 - up */
    if (m >> 23 == 0) {
        m <<= 5;
        down -= 5;
    }
    if (m >> 26 == 0) {
        m <<= 2;
        down -= 2;
    }
    if (m >> 27 == 0) {
        m <<= 1;
        down--;
    }
    if (m >> 27 == 0) {
        m <<= 1;
        down--;
    }
    m |= (rest & 0x7fff) >> down;
    return glint_squarehi_near(glint_reciprocal(m)) >> (2 * down - 10); /* 20 - 2 up */
}

/* F >= m 2^-17, exactly, for 0 < m < 2^18, t <= 1: m D D <= 2^139. In digits of 32 bits, least significant first; the sum that is added
 * to the lower four rounds the fifth one up. */
static bool ggx_at_least(uint32_t n, uint32_t t, uint32_t m)
{
    const uint64_t s = glint_multiply(t, ((uint32_t)1 << 31) - t); /* <= 2^60 */
    uint64_t sum = glint_multiply(n, (uint32_t)s);
    uint32_t d[3], md[3];
    d[0] = (uint32_t)sum;
    sum = (sum >> 32) + glint_multiply(n, (uint32_t)(s >> 32)) + ((uint32_t)1 << 29);
    d[1] = (uint32_t)sum;
    d[2] = (uint32_t)(sum >> 32); /* D < 2^70: < 2^6 */
    sum = 0;
    for (int i = 0; i < 3; i++) {
        sum = (sum >> 32) + glint_multiply(m, d[i]);
        md[i] = (uint32_t)sum; /* m D < 2^88 */
    }
    uint64_t carry = 0;
    for (int k = 0; k < 5; k++) {
        sum = carry + (k < 4 ? UINT32_MAX : 0);
        carry = 0;
        for (int i = k < 3 ? 0 : k - 2; i <= k && i < 3; i++) {
            const uint64_t product = glint_multiply(md[i], d[k - i]);
            sum += (uint32_t)product;
            carry += product >> 32;
        }
        carry += sum >> 32;
    }
    return (uint32_t)sum <= 2048;
}

uint32_t glint_ggx_t(uint32_t n, uint32_t t)
{
    if (t > GLINT_T_ONE)
        return 0;
    if (t == 0)
        return (uint32_t)GLINT_C_ONE;
    n = glint_clamp_n(n);
    const uint32_t f = ggx_near_t(n, t) + 2048;
    const uint32_t low = (f - ggx_high(n)) >> 12, high = (f + GGX_LOW) >> 12;
    return low == high || !ggx_at_least(n, t, 2 * high - 1) ? low : high;
}

uint32_t glint_ggx(uint32_t n, int32_t c_q16)
{
    return glint_ggx_t(n, glint_t_of_c(c_q16));
}

static bool ggx_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return ggx_at_least(n, t, (uint32_t)1 << (17 - q));
}

uint32_t glint_ggx_cutoff_t(uint32_t n, unsigned q)
{
    return glint_largest_t(ggx_reaches, n, q);
}

uint32_t glint_ggx_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_ggx_cutoff_t(n, q));
}

/* ---- from below, over a run of samples ---- */

/* 2^18 e comes scaled by 2^up, such that m, the largest, is just below 2^28: most of a highlight is dim, so most pixels need no
 * shift more. m = FACTOR t (2 - t) 2^17 + ADDEND; FACTOR = n 2^up < 2^17. */
enum { GGX_FACTOR, GGX_ADDEND, GGX_SHIFT };

/* t (2 - t) in Q31, 0 <= t <= 1; high by less than 4, never low. */
static inline uint32_t ggx_sine_near(uint32_t t)
{
    return (t << 2) - 2 * glint_squarehi_near(t << 1);
}

static void ggx_fold(struct glint_paint *paint)
{
    const uint32_t n = paint->of.exact.n, x = ggx_sine_near(paint->of.exact.t_end - 1);
    const uint32_t largest = ((uint32_t)1 << 18) + n * (x >> 14) + n; /* < 2^27 */
    unsigned up = 0;
    while (largest << up < (uint32_t)1 << 27 && n << up < (uint32_t)1 << 16)
        up++;
    paint->of.exact.k[GGX_FACTOR] = (int32_t)(n << up);
    paint->of.exact.k[GGX_ADDEND] = (int32_t)1 << (18 + up);
    paint->of.exact.k[GGX_SHIFT] = 33 - 2 * (int32_t)up;
}

/* 2^85 / m^2 <= 2^31, off by < 2220, 2^27 <= m < 2^28: y and p as msh_quotient has them. */
enum { GGX_SQUARE = 2220 };
static inline uint32_t ggx_square(uint32_t m)
{
    const uint32_t y = GLINT_FLASH_U8(glint_reciprocals[(m >> 21) - 64]), square = y * y;
    const int32_t r = (int32_t)(m * y) >> 14;
    const int32_t p = (r * (3 * r - (r * r >> 19)) >> 22) - r; /* within 1.1, of 2^20 */
    return (square << 15) + (uint32_t)((int32_t)square * p >> 5);
}

/* The square is high by < 2^13 + 1, too, of m, which is low by < 1 and doubled 8 times at most; and low by < 4n of t (2 - t): together less
 * than 2^15, the smallest step of F, so F is this or 1 more. */
enum { GGX_NEAR_HIGH = GGX_SQUARE + 1 + (1 << 13) };

__attribute__((flatten)) static inline uint32_t ggx_near(const struct glint_paint *paint, uint32_t t)
{
    const uint32_t k = (uint32_t)paint->of.exact.k[GGX_FACTOR], x = ggx_sine_near(t);
    uint32_t m = k * (x >> 14) + (k * (x & 0x3fff) >> 14) + (uint32_t)paint->of.exact.k[GGX_ADDEND];
    unsigned shift = (unsigned)paint->of.exact.k[GGX_SHIFT];
    while (!(m >> 27)) {
        m <<= 1;
        shift -= 2;
    }
    return (ggx_square(m) + ((uint32_t)1 << shift >> 1) - GGX_NEAR_HIGH) >> shift;
}

static void ggx_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, ggx_near);
}

const struct glint_use_model glint_use_ggx GLINT_FLASH = {
    GLINT_GGX, 1, NULL, ggx_fold, ggx_run, glint_ggx_t, glint_ggx_cutoff_t, NULL, GLINT_LINE_OF(glint_line_ggx)};

/* ---- of m: F = (2^22 / d)^2, d = 2^22 (1 + m) < 2^32 ---- */

static uint32_t ggx_grain(uint32_t m, uint32_t t)
{
    const uint64_t d = ((uint32_t)1 << GLINT_GRAIN_BITS) + m, square = d * d, one = (uint64_t)1 << 60;
    const uint64_t f = one / square, rest = one - f * square;
    (void)t;
    return (uint32_t)f + (rest >= square - rest);
}

static __attribute__((noinline)) bool ggx_grain_reaches(uint32_t m, uint32_t t, unsigned q)
{
    const uint64_t d = ((uint32_t)1 << GLINT_GRAIN_BITS) + m;
    (void)t;
    return d * d <= (uint64_t)1 << (44 + q);
}

/* m <= 2^(q / 2) - 1 */
static uint32_t ggx_grain_end(unsigned q)
{
    const uint32_t root = (uint32_t)(q & 1 ? 5931642 : 4194304) << q / 2; /* of 2^q, rounded up */
    return root - ((uint32_t)1 << GLINT_GRAIN_BITS) + 1;
}

/* High and low by less than GGX_SQUARE, high by 33 more of what x loses: together less than 2^15, the smallest step of F. */
static inline uint32_t ggx_grain_near(uint32_t scale, uint32_t m, uint32_t t)
{
    uint32_t x = ((uint32_t)1 << GLINT_GRAIN_BITS) + m;
    unsigned shift = 25;
    (void)scale, (void)t;
    while (x >> 28) {
        x >>= 1;
        shift += 2;
    }
    while (!(x >> 27)) {
        x <<= 1;
        shift -= 2;
    }
    return (ggx_square(x) + ((uint32_t)1 << shift >> 1) - (GGX_SQUARE + 33)) >> shift;
}

__attribute__((flatten)) static void ggx_grain_run(const struct glint_paint *paint, struct glint_sample *samples,
                                                   unsigned count)
{
    const uint32_t end = ggx_grain_end(glint_clamp_q(paint->material.q));
    glint_grain_run(paint, samples, count, end, ggx_grain_near, 0, ggx_grain_reaches);
}

static const struct glint_use_grain ggx_use_grain GLINT_FLASH = {ggx_grain_end, ggx_grain_run, ggx_grain,
                                                                 ggx_grain_reaches, GLINT_GRAIN_USE_SINE};
const struct glint_use_model glint_use_ggx_grain GLINT_FLASH = {GLINT_GGX,
                                                                1,
                                                                NULL,
                                                                ggx_fold,
                                                                ggx_run,
                                                                glint_ggx_t,
                                                                glint_ggx_cutoff_t,
                                                                &ggx_use_grain,
                                                                GLINT_LINE_OF(glint_line_ggx)};
