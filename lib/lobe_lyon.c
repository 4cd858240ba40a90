/* SPDX-License-Identifier: MIT
 * Lyon, gamma 4: F = max(0, 1 - n(1-c)/4)^4. R. F. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification,
 * Apple Technical Report 43, 1993: (1 - x/k)^k nears e^-x, and k = 4 takes two squarings. No division, no table.
 *
 * With T = 2^30 t:  F = (p / 2^32)^4, p = 2^32 - nT. There are no ties: p^4 = (2k + 1) 2^111 has no solution. */
#include "glint_grain.h"
#include "glint_math.h"

/* p, modulo 2^32, for 0 < p <= 2^32; 0 else, which for t > 0 can only be that. */
static inline uint32_t lyon_base(uint32_t n, uint32_t t)
{
    const uint32_t high = n * (t >> 16), product = n * t; /* n (t >> 16) < 2^24 */
    if (high >> 16 || product < high << 16)               /* nT >= 2^32: past the low half's carry, too */
        return 0;
    return 0 - product;
}

/* F 2^16 rounded, of p^4 / 2^64 to the last bit; for the one t in 11,000 that needs it. */
static inline __attribute__((always_inline)) uint32_t lyon_exactly(uint32_t p)
{
    const uint64_t square = (uint64_t)p * p, high = square >> 32, low = (uint32_t)square;
    const uint64_t fourth =
        high * high + ((high * low + (low * low >> 33)) >> 31); /* 2 h l + l^2 / 2^32, halved: < 2^64 */
    return (uint32_t)(((fourth >> 47) + 1) >> 1);
}

/* F 2^16 rounded, of p: y = F 2^32 is low by less than 2 of the square, which count twice, and 2: by less than 6. */
static inline __attribute__((always_inline)) uint32_t lyon_rounded(uint32_t p)
{
    const uint32_t y = glint_squarehi_near(glint_squarehi_near(p));
    return ((y + 32768) & 0xffff) > 65536 - 6 ? lyon_exactly(p) : ((y >> 15) + 1) >> 1;
}

/* Inlined into its loop, too, it would be there twice, or be split in two. */
__attribute__((noinline)) __attribute__((flatten)) uint32_t glint_lyon_t(uint32_t n, uint32_t t)
{
    if (t > GLINT_T_ONE)
        return 0;
    if (t == 0)
        return (uint32_t)GLINT_C_ONE; /* p = 2^32 */
    return lyon_rounded(lyon_base(glint_clamp_n(n), t));
}

uint32_t glint_lyon(uint32_t n, int32_t c_q16)
{
    return glint_lyon_t(n, glint_t_of_c(c_q16));
}

/* F >= 2^-q  <=>  p >= 2^(32 - q/4), and p is whole: nT <= 2^32 - r(q mod 4) / 2^(q / 4) rounded up, with
 * r(k) = 2^(32 - k/4) rounded up. The table holds r - 1, so that ceil(r / 2^m) = (r - 1 >> m) + 1. */
static const uint32_t lyon_root[4] GLINT_FLASH = {UINT32_C(0xffffffff), UINT32_C(0xd744fcca), UINT32_C(0xb504f333),
                                                  UINT32_C(0x9837f051)};
uint32_t glint_lyon_cutoff_t(uint32_t n, unsigned q)
{
    q = glint_clamp_q(q);
    const uint32_t t = ~(GLINT_FLASH_U32(lyon_root[q & 3]) >> (q >> 2)) / glint_clamp_n(n);
    return t < GLINT_T_ONE ? t : GLINT_T_ONE; /* where n < 4, F(1) > 0 */
}

uint32_t glint_lyon_cutoff(uint32_t n, unsigned q)
{
    return glint_c_of_cutoff_t(glint_lyon_cutoff_t(n, q));
}

/* ---- from below, over a run of samples ---- */

static inline uint32_t lyon_near(const struct glint_paint *paint, uint32_t t)
{
    return glint_lyon_t(paint->of.exact.n, t);
}

static void lyon_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_near_run(paint, samples, count, lyon_near);
}

const struct glint_use_model glint_use_lyon GLINT_FLASH = {
    GLINT_LYON, 0, NULL, NULL, lyon_run, glint_lyon_t, glint_lyon_cutoff_t, NULL, NULL};

/* ---- of m: p = 2^32 (1 - m / 4) ---- */

static uint32_t lyon_grain(uint32_t m, uint32_t t)
{
    (void)t;
    if (m == 0)
        return (uint32_t)GLINT_C_ONE;
    if (m >> 24)
        return 0;
    return lyon_rounded(0 - (m << 8));
}

static __attribute__((noinline)) bool lyon_grain_reaches(uint32_t m, uint32_t t, unsigned q)
{
    (void)t;
    return m >> 24 == 0 && (m == 0 || 0 - (m << 8) > GLINT_FLASH_U32(lyon_root[q & 3]) >> (q >> 2));
}

static uint32_t lyon_grain_end(unsigned q)
{
    (void)q;
    return (uint32_t)4 << GLINT_GRAIN_BITS;
}

static inline uint32_t lyon_grain_near(uint32_t scale, uint32_t m, uint32_t t)
{
    (void)scale;
    return lyon_grain(m, t);
}

static void lyon_grain_run(const struct glint_paint *paint, struct glint_sample *samples, unsigned count)
{
    glint_grain_run(paint, samples, count, lyon_grain_end(0), lyon_grain_near, 0, lyon_grain_reaches);
}

static const struct glint_use_grain lyon_use_grain GLINT_FLASH = {lyon_grain_end, lyon_grain_run, lyon_grain,
                                                                  lyon_grain_reaches, GLINT_GRAIN_USE};
const struct glint_use_model glint_use_lyon_grain GLINT_FLASH = {
    GLINT_LYON, 0, NULL, NULL, lyon_run, glint_lyon_t, glint_lyon_cutoff_t, &lyon_use_grain, NULL};
