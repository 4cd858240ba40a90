/* SPDX-License-Identifier: MIT
 * Modified Schlick, eq. (5): F = 2c / (1.25 (n - nc + 1.25c)^2).
 *
 * With C = 2^16 c and E = 2^16 (4n(1 - c) + 5c), 2^18 <= E < 2^28:  F 2^16 = 2^39 C / (5 E^2). Small cores divide slowly or
 * not at all, so F comes from an approximate reciprocal, and where that does not settle the rounding, from an exact
 * comparison of products. There are no ties for integer n. */
#include "glint_fused.h"
#include "glint_grain.h"
#include "glint_math.h"

/* 2^71 C / (5 m^2) for C = u / 2^8 <= 2^16, within 2400; less than 0.4 * 2^32. With y m = 2^35 (1 + r),
 * 1 / m^2 = y^2 2^-70 (1 + p), p = -2r + 3r^2 - 4r^3 + .. Products of 32 bits only, and all that fits is kept. */
static inline uint32_t msh_quotient(uint32_t u_q24, uint32_t m)
{
    const uint32_t y = GLINT_FLASH_U8(glint_reciprocals[(m >> 21) - 64]);
    const int32_t r = (int32_t)(m * y) >> 14;                  /* Q21, |r| < 18960: 2^35 is 0 modulo 2^32. Low by < 1 */
    const int32_t p = (r * (3 * r - (r * r >> 19)) >> 22) - r; /* Q20, |p| < 19300, within 1.1: r and >> err apart */
    const uint32_t b = (u_q24 * y >> 8) * y;                   /* y^2 C < 254^2 2^16 < 2^32. Low by < 254 */
    /* 2^70 C / m^2, off by 1.1 * 2^12 of p + 19300 / 2^4 of b >> 16 + 254 of b + 1 < 5970; less than 2^32: m is near
     * 1.25 * 2^27 where C is near 2^16, elsewhere the whole steps of C missing leave 2^16 each */
    const uint32_t x = b + (uint32_t)((int32_t)(b >> 16) * p >> 4);
    uint32_t q = (x >> 2) + (x >> 3); /* 2/5 x = 3/8 x (1 + 1/16) (1 + 1/256) (1 + 1/65536). Low by < 6 */
    q += q >> 4;
    q += q >> 8;
    return q + (q >> 16);
}

/* E = 2^-s m, 2^27 <= m < 2^28: then F 2^16 = 2^(2s - 32) times the quotient. */
struct scaled {
    uint32_t m;
    unsigned shift; /* 32 - 2s, 14 .. 30 */
};

static inline struct scaled scale(uint32_t e) /* 2^18 <= e < 2^27 */
{
    struct scaled a = {e << 1, 30};
    if (a.m >> 20 == 0) {
        a.m <<= 8;
        a.shift -= 16;
    }
    if (a.m >> 24 == 0) {
        a.m <<= 4;
        a.shift -= 8;
    }
    unsigned top = (unsigned)(a.m >> 24); /* a byte: cores without a barrel shifter have it for nothing */
    if (top < 4) {
        a.m <<= 2;
        top <<= 2;
        a.shift -= 4;
    }
    if (top < 8) {
        a.m <<= 1;
        a.shift -= 2;
    }
    return a;
}

/* F 2^16, rounded, is low or high. They differ for one pixel in 30 of a highlight of n = 60 (q = 8), one in 11 at n = 10. */
struct range {
    uint32_t low, high; /* high <= low + 1 */
};
enum { SLACK = 2560 }; /* 2400, and from t, where u and m are cut by < 1 each, 254 * 254 / 2^8 * 2/5 < 101 or 26 */

/* In each of those that call it, as that costs less. */
static inline __attribute__((always_inline)) struct range candidates(uint32_t u_q24, struct scaled a)
{
    const uint32_t q = msh_quotient(u_q24, a.m) + ((uint32_t)1 << (a.shift - 1));
    const struct range f = {(q - SLACK) >> a.shift, (q + SLACK) >> a.shift};
    return f;
}

/* E, <= 4000 * 2^16. (For n = 1 the factor is -1, modulo 2^32.) */
static inline uint32_t denominator(uint32_t n, uint32_t c)
{
    return (4 * n - 5) * ((uint32_t)GLINT_C_ONE - c) + 5 * (uint32_t)GLINT_C_ONE;
}

uint32_t glint_msh(uint32_t n, int32_t c_q16)
{
    if (c_q16 <= 0)
        return 0;
    const uint32_t c = c_q16 < GLINT_C_ONE ? (uint32_t)c_q16 : (uint32_t)GLINT_C_ONE;
    const uint32_t e = denominator(glint_clamp_n(n), c);
    if (e >> 27)
        return 0; /* F 2^16 < 0.4 */
    const struct range f = candidates(c << 8, scale(e));
    if (f.low == f.high)
        return f.low;
    const uint64_t d = 5 * ((uint64_t)e * e);
    return (2 * f.high - 1) * d > (uint64_t)c << 40 ? f.low : f.high; /* < 2^58 */
}

/* F >= 2^-q  <=>  C 2^(23+q) >= 5 E^2 < 2^59. F rises with C, so the smallest such C is found by bisection; it exists,
 * as F(1) = 1.024. The closed form (12) is exact nowhere and singular at n = 1.25. */
uint32_t glint_msh_cutoff(uint32_t n, unsigned q)
{
    n = glint_clamp_n(n);
    q = glint_clamp_q(q);
    uint32_t below = 0;
    for (uint32_t bit = 32768; bit; bit >>= 1) {
        const uint32_t c = below + bit;
        const uint64_t e = denominator(n, c);
        if ((uint64_t)(c << q) << 23 < 5 * (e * e))
            below = c;
    }
    return below + 1;
}

/* With U = 2^30 (1 - t), 2^14 E = (4n - 5) T + 5 2^30 has 14 bits more; n = 1 makes the factor -1. */
struct denominator {
    uint32_t e;        /* floor(E), 2^18 <= e <= 4000 2^16 */
    uint32_t fraction; /* Q14 */
};

static inline struct denominator denominator_of_t(uint32_t n, uint32_t t)
{
    const int32_t k = 4 * (int32_t)n - 5;
    const int32_t low = k * (int32_t)(t & 0x3fff); /* < 2^26 */
    const struct denominator d = {(uint32_t)(k * (int32_t)(t >> 14) + 5 * GLINT_C_ONE + (low >> 14)),
                                  (uint32_t)low & 0x3fff};
    return d;
}

/* F >= m 2^-17, exactly, for 0 < m < 2^18:  U 2^54 >= 5m (2^14 E)^2, in digits of base 2^21. */
static bool msh_at_least(uint32_t u, struct denominator d, uint32_t m)
{
    const uint64_t e = (uint64_t)d.e << 14 | d.fraction; /* < 2^42 */
    const uint64_t high = e >> 21, low = e & 0x1fffff, five_m = 5 * m;
    const uint64_t digit0 = five_m * (low * low);                         /* < 2^63 */
    const uint64_t digit1 = 2 * (five_m * (high * low)) + (digit0 >> 21); /* < 2^64 */
    const uint64_t digit2 = five_m * (high * high) + (digit1 >> 21);
    const uint64_t left = (uint64_t)u << 12;
    return left > digit2 || (left == digit2 && !(digit1 & 0x1fffff) && !(digit0 & 0x1fffff));
}

uint32_t glint_msh_t(uint32_t n, uint32_t t)
{
    if (t >= GLINT_T_ONE)
        return 0;
    const uint32_t u = GLINT_T_ONE - t;
    const struct denominator d = denominator_of_t(glint_clamp_n(n), t);
    if (d.e >> 27)
        return 0; /* F 2^16 < 0.4 */
    struct scaled a = scale(d.e);
    a.m |= d.fraction >> (a.shift / 2 - 2); /* 14 - s */
    const struct range f = candidates(u >> 6, a);
    return f.low == f.high || !msh_at_least(u, d, 2 * f.high - 1) ? f.low : f.high;
}

static bool msh_reaches(uint32_t n, uint32_t t, unsigned q)
{
    return msh_at_least(GLINT_T_ONE - t, denominator_of_t(n, t), (uint32_t)1 << (17 - q));
}

uint32_t glint_msh_cutoff_t(uint32_t n, unsigned q)
{
    return glint_largest_t(msh_reaches, n, q);
}

/* ---- from below, over a run of samples ---- */

/* E = 2^16 (4n(1 - c) + 5c) comes scaled by 2^up, such that m, the largest, is just below 2^28: most of a
 * highlight is dim, so most pixels need no shift more. */

/* k t 2^-14 + addend, rounded down. */
static inline uint32_t msh_m(int32_t k, int32_t addend, uint32_t t)
{
    return (uint32_t)(k * (int32_t)(t >> 14) + (k * (int32_t)(t & 0x3fff) >> 14)) + (uint32_t)addend;
}

/* m = FACTOR t 2^-14 + ADDEND, < 2^28 for t < t_end, where F > 0 and so E < 2^27: up >= 1. FACTOR < 2^17. */
static void msh_fold(struct glint_paint *paint)
{
    const int32_t k = 4 * (int32_t)paint->of.exact.n - 5;
    /* E < largest + 1; n = 1: at t = 0 */
    const uint32_t largest = msh_m(k, (int32_t)5 << 16, k > 0 ? paint->of.exact.t_end - 1 : 0);
    unsigned up = 0;
    while (largest << up < (uint32_t)1 << 27 && k * ((int32_t)1 << up) < (int32_t)1 << 16)
        up++;
    paint->of.exact.k[GLINT_MSH_FACTOR] = k * ((int32_t)1 << up);
    paint->of.exact.k[GLINT_MSH_ADDEND] = (int32_t)((uint32_t)5 << 16 << up);
    paint->of.exact.k[GLINT_MSH_SHIFT] = 32 - 2 * (int32_t)up;
}

__attribute__((flatten)) static inline uint32_t msh_near(const struct glint_paint *paint, uint32_t t)
{
    uint32_t m = msh_m(paint->of.exact.k[GLINT_MSH_FACTOR], paint->of.exact.k[GLINT_MSH_ADDEND], t);
    unsigned shift = (unsigned)paint->of.exact.k[GLINT_MSH_SHIFT];
    while (!(m >> 27)) {
        m <<= 1;
        shift -= 2;
    }
    const uint32_t f =
        (msh_quotient((GLINT_T_ONE - t) >> 6, m) + ((uint32_t)1 << shift >> 1) - GLINT_MSH_HIGH) >> shift;
    return f < paint->of.exact.f_max ? f : paint->of.exact.f_max;
}

static void msh_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, msh_near);
}

const struct glint_use_model glint_use_msh GLINT_FLASH = {
    GLINT_MSH, 1, NULL, msh_fold, msh_run, glint_msh_t, glint_msh_cutoff_t, NULL, GLINT_LINE_OF(glint_line_msh)};

/* ---- of t and m ---- */

/* 2^14 E = 4 m 2^30 + 5 (2^30 - T), < 2^42. */
static inline struct denominator denominator_of_m(uint32_t m, uint32_t u)
{
    const uint64_t e = ((uint64_t)m << 10) + 5 * (uint64_t)u;
    const struct denominator d = {(uint32_t)(e >> 14), (uint32_t)e & 0x3fff};
    return d;
}

/* As 4 m >= 4 t - 2^-20, E >= 4 + c - 2^-20: where it is less than 4, c < 2^-20. */
static uint32_t msh_grain(uint32_t m, uint32_t t)
{
    const uint32_t u = GLINT_T_ONE - t;
    const struct denominator d = denominator_of_m(m, u);
    if (d.e >> 18 == 0 || d.e >> 27)
        return 0; /* F 2^16 < 0.4 */
    struct scaled a = scale(d.e);
    a.m |= d.fraction >> (a.shift / 2 - 2); /* 14 - s */
    const struct range f = candidates(u >> 6, a);
    return f.low == f.high || !msh_at_least(u, d, 2 * f.high - 1) ? f.low : f.high;
}

static __attribute__((noinline)) bool msh_grain_reaches(uint32_t m, uint32_t t, unsigned q)
{
    const uint32_t u = GLINT_T_ONE - t;
    return u && msh_at_least(u, denominator_of_m(m, u), (uint32_t)1 << (17 - q));
}

/* Where m >= 1.25, F rises with c: it is at most that of c = 1, 1.6 / (m + 1.25)^2, and m <= sqrt(1.6 2^q) - 1.25. */
static uint32_t msh_grain_end(unsigned q)
{
    const uint32_t least = (uint32_t)5 << (GLINT_GRAIN_BITS - 2);
    const uint32_t root = (uint32_t)(q & 1 ? 7503000 : 5305422) << q / 2; /* of 1.6 2^q, rounded up */
    return (root - least > least ? root - least : least) + 1;
}

/* up: such that the largest x is less than 2^28. */
static inline uint32_t msh_grain_near(uint32_t up, uint32_t m, uint32_t t)
{
    const uint32_t u = GLINT_T_ONE - t;
    uint32_t x = m + (5 * (u >> 2) >> 8) + 2;
    unsigned shift = 24;
    while (x >> 28) {
        x >>= 1;
        shift += 2;
    }
    x <<= up;
    shift -= (unsigned)(2 * up);
    while (!(x >> 27)) {
        x <<= 1;
        shift -= 2;
    }
    return (msh_quotient(u >> 6, x) + ((uint32_t)1 << shift >> 1) - GLINT_MSH_GRAIN_HIGH) >> shift;
}

__attribute__((flatten)) static void msh_grain_run(const struct glint_paint *paint, struct glint_sample *samples,
                                                   unsigned count)
{
    const uint32_t end = msh_grain_end(glint_clamp_q(paint->material.q));
    glint_grain_run(paint, samples, count, end, msh_grain_near, glint_msh_grain_up(end), msh_grain_reaches);
}

#if GLINT_CORTEX_M0PLUS_ASM && GLINT_FUSED
#define MSH_GRAIN_DRAW glint_fused_grain
#else
#define MSH_GRAIN_DRAW glint_grain_draw
#endif
static const struct glint_use_grain msh_use_grain GLINT_FLASH = {msh_grain_end, msh_grain_run, msh_grain,
                                                                 msh_grain_reaches, GLINT_GRAIN_USE_BY(MSH_GRAIN_DRAW)};
const struct glint_use_model glint_use_msh_grain GLINT_FLASH = {GLINT_MSH,
                                                                1,
                                                                NULL,
                                                                msh_fold,
                                                                msh_run,
                                                                glint_msh_t,
                                                                glint_msh_cutoff_t,
                                                                &msh_use_grain,
                                                                GLINT_LINE_OF(glint_line_msh)};
