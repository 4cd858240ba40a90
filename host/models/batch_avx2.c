/* SPDX-License-Identifier: MIT
 * The loops of batch.c for AVX2: latencies overlap in rounds of 16 elements. */
#include "models/batch_avx2.h"
#include "models/batch_portable.h"

#if GLINT_BATCH_AVX2
#include <immintrin.h>
#define AVX2 __attribute__((target("avx2,fma")))

bool batch_runs_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

AVX2 static inline __m256i load_c(const int32_t *c_q16)
{
    const __m256i c = _mm256_loadu_si256((const __m256i *)(const void *)c_q16);
    return _mm256_min_epi32(_mm256_max_epi32(c, _mm256_setzero_si256()), _mm256_set1_epi32(GLINT_C_ONE));
}

/* All bits where c < 0, where F is 0; models whose F is not 0 at c = 0 need to ask. */
AVX2 static inline __m256i back_facing(const int32_t *c_q16)
{
    return _mm256_srai_epi32(_mm256_loadu_si256((const __m256i *)(const void *)c_q16), 31);
}

AVX2 static inline void store_f(uint32_t *f_q16, __m256i f)
{
    _mm256_storeu_si256((__m256i *)(void *)f_q16, f);
}

/* Conversions by bits, which are faster: after the upper half of 2^37, 2^15 C is the lower half of 2^37 + C; and adding
 * 2^52 rounds to nearest into the lower half. The order of the elements, 0 1 4 5 and 2 3 6 7, cancels out. */
struct doubles {
    __m256d low, high;
};

/* at_0 + slope C, of integers below 2^49, as (at_0 - 2^37 slope) + slope (2^37 + C). */
AVX2 static inline struct doubles linear(double at_0, double slope, __m256i c)
{
    const __m256i upper = _mm256_set1_epi32((1023 + 37) << 20), lower = _mm256_slli_epi32(c, 15);
    const __m256d k = _mm256_set1_pd(slope), sum = _mm256_set1_pd(at_0 - 0x1p37 * slope);
    return (struct doubles){_mm256_fmadd_pd(k, _mm256_castsi256_pd(_mm256_unpacklo_epi32(lower, upper)), sum),
                            _mm256_fmadd_pd(k, _mm256_castsi256_pd(_mm256_unpackhi_epi32(lower, upper)), sum)};
}

/* The same, 0 where it is negative. */
AVX2 static inline struct doubles linear_positive(double at_0, double slope, __m256i c)
{
    const struct doubles x = linear(at_0, slope, c);
    return (struct doubles){_mm256_max_pd(x.low, _mm256_setzero_pd()), _mm256_max_pd(x.high, _mm256_setzero_pd())};
}

AVX2 static inline struct doubles msh_e(const struct batch_msh *m, __m256i c)
{
    return linear(m->e_at_0, -m->k, c);
}

AVX2 static inline __m256i lower_halves(__m256d low, __m256d high)
{
    return _mm256_castps_si256(_mm256_shuffle_ps(_mm256_castpd_ps(low), _mm256_castpd_ps(high), 0x88));
}

/* One division for two elements: 1 / E1 = E2 / (E1 E2). */
AVX2 static inline __m256d joint_quotient(struct doubles e)
{
    return _mm256_div_pd(_mm256_set1_pd(1), _mm256_mul_pd(e.low, e.high));
}

AVX2 static inline __m256d msh_rounded(const struct batch_msh *m, __m256d u)
{
    const __m256d factor = _mm256_fmsub_pd(_mm256_set1_pd(m->a), u, _mm256_set1_pd(m->b));
    return _mm256_fmadd_pd(factor, u, _mm256_set1_pd(0x1p52));
}

AVX2 static inline __m256i msh_f(const struct batch_msh *m, struct doubles e, __m256d quotient)
{
    return lower_halves(msh_rounded(m, _mm256_mul_pd(quotient, e.high)),
                        msh_rounded(m, _mm256_mul_pd(quotient, e.low)));
}

AVX2 void batch_msh_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const struct batch_msh m = batch_msh_of(n);
    size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const struct doubles e0 = msh_e(&m, load_c(c_q16 + i)), e1 = msh_e(&m, load_c(c_q16 + i + 8));
        const __m256d quotient0 = joint_quotient(e0), quotient1 = joint_quotient(e1);
        const __m256i f0 = msh_f(&m, e0, quotient0), f1 = msh_f(&m, e1, quotient1);
        store_f(f_q16 + i, f0);
        store_f(f_q16 + i + 8, f1);
    }
    _mm256_zeroupper(); /* GCC forgets it before a tail call, and SSE instructions would be slow ever after */
    batch_msh_portable(n, c_q16 + i, f_q16 + i, count - i);
}

/* In float F 2^16 is within 2^-7 + 2^-8: with 2^-6 added it rounds to the right value or the next, as the remainder
 * tells. Terms of the remainder may wrap; itself it is -D .. D. */
AVX2 static inline __m256i schlick_8(int32_t k, int32_t d_at_0, __m256i c)
{
    const __m256i d = _mm256_sub_epi32(_mm256_set1_epi32(d_at_0), _mm256_mullo_epi32(_mm256_set1_epi32(k), c));
    const __m256 numerator = _mm256_mul_ps(_mm256_cvtepi32_ps(c), _mm256_set1_ps(GLINT_C_ONE));
    const __m256 quotient = _mm256_div_ps(numerator, _mm256_cvtepi32_ps(d));
    const __m256i f = _mm256_cvtps_epi32(_mm256_add_ps(quotient, _mm256_set1_ps(0x1p-6F)));
    const __m256i rounded = _mm256_add_epi32(_mm256_slli_epi32(c, 16), _mm256_srli_epi32(d, 1));
    const __m256i remainder = _mm256_sub_epi32(rounded, _mm256_mullo_epi32(f, d));
    return _mm256_add_epi32(f, _mm256_srai_epi32(remainder, 31));
}

AVX2 void batch_schlick_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const int32_t k = (int32_t)n - 1, d_at_0 = GLINT_C_ONE * (int32_t)n;
    size_t i = 0;
    for (; i + 8 <= count; i += 8)
        store_f(f_q16 + i, schlick_8(k, d_at_0, load_c(c_q16 + i)));
    _mm256_zeroupper();
    batch_schlick_portable(n, c_q16 + i, f_q16 + i, count - i);
}

AVX2 static inline __m256d fourth_rounded(__m256d r)
{
    const __m256d square = _mm256_mul_pd(r, r);
    return _mm256_fmadd_pd(square, square, _mm256_set1_pd(0x1p52));
}

AVX2 static inline __m256i cayley_8(double k, __m256i c)
{
    const struct doubles p = linear_positive(16 * GLINT_C_ONE * (4 - k), 16 * (k + 4), c);
    const struct doubles s = linear(GLINT_C_ONE * (k + 4), 4 - k, c);
    const __m256d quotient = joint_quotient(s);
    return lower_halves(fourth_rounded(_mm256_mul_pd(p.low, _mm256_mul_pd(quotient, s.high))),
                        fourth_rounded(_mm256_mul_pd(p.high, _mm256_mul_pd(quotient, s.low))));
}

AVX2 void batch_cayley_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const __m256i f0 = cayley_8(n, load_c(c_q16 + i)), f1 = cayley_8(n, load_c(c_q16 + i + 8));
        store_f(f_q16 + i, f0);
        store_f(f_q16 + i + 8, f1);
    }
    _mm256_zeroupper();
    batch_cayley_portable(n, c_q16 + i, f_q16 + i, count - i);
}

AVX2 static inline __m256i lyon_8(double k, __m256i c)
{
    const struct doubles p = linear_positive(4 * (4 - k), k * 0x1p-14, c);
    return lower_halves(fourth_rounded(p.low), fourth_rounded(p.high));
}

AVX2 void batch_lyon_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const __m256i back0 = back_facing(c_q16 + i), back1 = back_facing(c_q16 + i + 8);
        const __m256i f0 = lyon_8(n, load_c(c_q16 + i)), f1 = lyon_8(n, load_c(c_q16 + i + 8));
        store_f(f_q16 + i, _mm256_andnot_si256(back0, f0));
        store_f(f_q16 + i + 8, _mm256_andnot_si256(back1, f1));
    }
    _mm256_zeroupper();
    batch_lyon_portable(n, c_q16 + i, f_q16 + i, count - i);
}

AVX2 static inline __m256d ggx_d(double d_at_0, double k, __m256d c)
{
    return _mm256_fnmadd_pd(_mm256_set1_pd(k), _mm256_mul_pd(c, c), _mm256_set1_pd(d_at_0));
}

AVX2 static inline __m256d square_rounded(__m256d r)
{
    return _mm256_fmadd_pd(r, r, _mm256_set1_pd(0x1p52));
}

AVX2 static inline __m256i ggx_8(double k, __m256i c)
{
    const struct doubles of = linear(0, 1, c);
    const double d_at_0 = 0x1p33 + k * 0x1p32;
    const struct doubles d = {ggx_d(d_at_0, k, of.low), ggx_d(d_at_0, k, of.high)};
    const __m256d quotient = _mm256_mul_pd(_mm256_set1_pd(0x1p41), joint_quotient(d));
    return lower_halves(square_rounded(_mm256_mul_pd(quotient, d.high)),
                        square_rounded(_mm256_mul_pd(quotient, d.low)));
}

AVX2 void batch_ggx_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const __m256i back0 = back_facing(c_q16 + i), back1 = back_facing(c_q16 + i + 8);
        const __m256i f0 = ggx_8(n, load_c(c_q16 + i)), f1 = ggx_8(n, load_c(c_q16 + i + 8));
        store_f(f_q16 + i, _mm256_andnot_si256(back0, f0));
        store_f(f_q16 + i + 8, _mm256_andnot_si256(back1, f1));
    }
    _mm256_zeroupper();
    batch_ggx_portable(n, c_q16 + i, f_q16 + i, count - i);
}

/* ---- c^n in Q0.32 by binary powering: each product is cut by less than 1, so that the power is low by less than n. Where
 * that does not decide the rounding, glint_blinn does. Even and odd elements are apart in 64 bits. ---- */

struct powers {
    __m256i even0, odd0, even1, odd1;
};

AVX2 static inline __m256i mulhi(__m256i a, __m256i b)
{
    return _mm256_srli_epi64(_mm256_mul_epu32(a, b), 32);
}

AVX2 static inline struct powers product(struct powers a, struct powers b)
{
    return (struct powers){mulhi(a.even0, b.even0), mulhi(a.odd0, b.odd0), mulhi(a.even1, b.even1),
                           mulhi(a.odd1, b.odd1)};
}

/* F 2^16 of the even or odd elements, if low and low + n - 1 agree: else a bit of *open is set. c = 1 is for the caller. */
AVX2 static inline __m256i power_rounded(__m256i low, uint32_t n, __m256i *open)
{
    const __m256i sum = _mm256_add_epi64(low, _mm256_set1_epi64x(32768));
    const __m256i other = _mm256_add_epi64(sum, _mm256_set1_epi64x(n - 1));
    *open = _mm256_or_si256(*open, _mm256_srli_epi64(_mm256_xor_si256(sum, other), 16));
    return _mm256_srli_epi64(sum, 16);
}

AVX2 static inline void power_store(uint32_t n, __m256i even, __m256i odd, __m256i c, uint32_t *f_q16)
{
    const __m256i one = _mm256_set1_epi32(GLINT_C_ONE);
    __m256i open = _mm256_setzero_si256();
    const __m256i f_even = power_rounded(even, n, &open), f_odd = power_rounded(odd, n, &open);
    const __m256i f = _mm256_or_si256(f_even, _mm256_slli_epi64(f_odd, 32));
    store_f(f_q16, _mm256_blendv_epi8(f, one, _mm256_cmpeq_epi32(c, one)));
    if (!_mm256_testz_si256(open, open)) {
        int32_t again[8]; /* c_q16 may be f_q16 */
        _mm256_storeu_si256((__m256i *)(void *)again, c);
        for (int k = 0; k < 8; k++)
            f_q16[k] = glint_blinn(n, again[k]);
    }
}

AVX2 static inline void power_16(uint32_t n, const int32_t *c_q16, uint32_t *f_q16)
{
    const __m256i c0 = load_c(c_q16), c1 = load_c(c_q16 + 8);
    const __m256i x0 = _mm256_slli_epi32(c0, 16), x1 = _mm256_slli_epi32(c1, 16); /* 0 for c = 1 */
    const struct powers x = {_mm256_blend_epi32(x0, _mm256_setzero_si256(), 0xaa), _mm256_srli_epi64(x0, 32),
                             _mm256_blend_epi32(x1, _mm256_setzero_si256(), 0xaa), _mm256_srli_epi64(x1, 32)};
    struct powers power = x;
    uint32_t bit = 512;
    while (bit > n)
        bit >>= 1;
    while (bit >>= 1) {
        power = product(power, power);
        if (n & bit)
            power = product(power, x);
    }
    power_store(n, power.even0, power.odd0, c0, f_q16);
    power_store(n, power.even1, power.odd1, c1, f_q16 + 8);
}

AVX2 void batch_power_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    size_t i = 0;
    for (; i + 16 <= count; i += 16)
        power_16(n, c_q16 + i, f_q16 + i);
    _mm256_zeroupper();
    for (; i < count; i++)
        f_q16[i] = glint_blinn(n, c_q16[i]);
}

AVX2 void batch_lookup_avx2(const uint32_t *table, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    size_t i = 0;
    for (; i + 8 <= count; i += 8)
        store_f(f_q16 + i,
                _mm256_andnot_si256(back_facing(c_q16 + i),
                                    _mm256_i32gather_epi32((const int *)(const void *)table, load_c(c_q16 + i), 4)));
    _mm256_zeroupper();
    batch_lookup_portable(table, c_q16 + i, f_q16 + i, count - i);
}
#endif
