/* SPDX-License-Identifier: MIT
 * MSH and Schlick in floating point, and exact: the error of each sequence of operations, whether or not the compiler
 * fuses multiplications and additions, is below the distance of every value from the nearest rounding tie. */
#include "models/batch.h"

#include <stdlib.h>

static int32_t clamp_c(int32_t c)
{
    c = c > 0 ? c : 0;
    return c < GLINT_C_ONE ? c : GLINT_C_ONE;
}

/* With E = 4n(2^16 - C) + 5C, F 2^16 = 2^39 C / (5 E^2); and C is linear in E, so that with u = 1 / E
 *   F 2^16 = u (a u - b),  a = 2^39/5 (2^16 + 5 2^16 / k),  b = 2^39/5 / k,  k = 4n - 5.
 * |a u^2| < 1.7 2^18, reached at n = 1, bounds every term. A rounding costs at most 2^-53 of it, and there are 15: u
 * has 3 and counts twice, a has 4, b 2, the rest 3. So F 2^16 is within 8e-10, and none is within 1.4e-9 of a tie. */
struct msh {
    int32_t k, e_at_0; /* E = e_at_0 - k C < 2^28 */
    double a, b;
};

static struct msh msh_of(uint32_t n)
{
    const int32_t k = 4 * (int32_t)n - 5;
    const double scale = 0x1p39 / 5;
    return (struct msh){k, 4 * GLINT_C_ONE * (int32_t)n, scale * (GLINT_C_ONE + 5.0 * GLINT_C_ONE / k), scale / k};
}

/* ---- portable: left to the compiler ---- */

static void msh_portable(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const struct msh m = msh_of(n);
#pragma omp simd
    for (size_t i = 0; i < count; i++) {
        const double u = 1.0 / (m.e_at_0 - m.k * clamp_c(c_q16[i]));
        f_q16[i] = (uint32_t)(int32_t)(u * (m.a * u - m.b) + 0.5);
    }
}

/* F 2^16 = 2^16 C / D, D = n(2^16 - C) + C <= 2^26: at least 2^-27 from a tie, computed within 2^-36. Without an error
 * where it is a tie: C = 32896, n = 513. */
static void schlick_portable(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const int32_t k = (int32_t)n - 1, d_at_0 = GLINT_C_ONE * (int32_t)n;
#pragma omp simd
    for (size_t i = 0; i < count; i++) {
        const int32_t c = clamp_c(c_q16[i]);
        f_q16[i] = (uint32_t)(int32_t)((double)GLINT_C_ONE * c / (d_at_0 - k * c) + 0.5);
    }
}

static bool runs_everywhere(void)
{
    return true;
}

/* ---- AVX2: latencies overlap in rounds of 16 elements ---- */

#if defined __x86_64__ && defined __GNUC__
#include <immintrin.h>
#define AVX2 __attribute__((target("avx2,fma")))

static bool runs_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}

AVX2 static inline __m256i load_c(const int32_t *c_q16)
{
    const __m256i c = _mm256_loadu_si256((const __m256i *)(const void *)c_q16);
    return _mm256_min_epi32(_mm256_max_epi32(c, _mm256_setzero_si256()), _mm256_set1_epi32(GLINT_C_ONE));
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

/* E = (e_at_0 + 2^37 k) - k (2^37 + C), of integers below 2^49. */
AVX2 static inline struct doubles msh_e(const struct msh *m, __m256i c)
{
    const __m256i upper = _mm256_set1_epi32((1023 + 37) << 20), lower = _mm256_slli_epi32(c, 15);
    const __m256d k = _mm256_set1_pd(m->k), sum = _mm256_set1_pd(m->e_at_0 + 0x1p37 * m->k);
    return (struct doubles){_mm256_fnmadd_pd(k, _mm256_castsi256_pd(_mm256_unpacklo_epi32(lower, upper)), sum),
                            _mm256_fnmadd_pd(k, _mm256_castsi256_pd(_mm256_unpackhi_epi32(lower, upper)), sum)};
}

AVX2 static inline __m256i lower_halves(__m256d low, __m256d high)
{
    return _mm256_castps_si256(_mm256_shuffle_ps(_mm256_castpd_ps(low), _mm256_castpd_ps(high), 0x88));
}

/* One division for two elements: 1 / E1 = E2 / (E1 E2). */
AVX2 static inline __m256d msh_quotient(struct doubles e)
{
    return _mm256_div_pd(_mm256_set1_pd(1), _mm256_mul_pd(e.low, e.high));
}

AVX2 static inline __m256d msh_rounded(const struct msh *m, __m256d u)
{
    const __m256d factor = _mm256_fmsub_pd(_mm256_set1_pd(m->a), u, _mm256_set1_pd(m->b));
    return _mm256_fmadd_pd(factor, u, _mm256_set1_pd(0x1p52));
}

AVX2 static inline __m256i msh_f(const struct msh *m, struct doubles e, __m256d quotient)
{
    return lower_halves(msh_rounded(m, _mm256_mul_pd(quotient, e.high)),
                        msh_rounded(m, _mm256_mul_pd(quotient, e.low)));
}

AVX2 static void msh_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const struct msh m = msh_of(n);
    size_t i = 0;
    for (; i + 16 <= count; i += 16) {
        const struct doubles e0 = msh_e(&m, load_c(c_q16 + i)), e1 = msh_e(&m, load_c(c_q16 + i + 8));
        const __m256d quotient0 = msh_quotient(e0), quotient1 = msh_quotient(e1);
        const __m256i f0 = msh_f(&m, e0, quotient0), f1 = msh_f(&m, e1, quotient1);
        store_f(f_q16 + i, f0);
        store_f(f_q16 + i + 8, f1);
    }
    _mm256_zeroupper(); /* GCC forgets it before a tail call, and SSE instructions would be slow ever after */
    msh_portable(n, c_q16 + i, f_q16 + i, count - i);
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

AVX2 static void schlick_avx2(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const int32_t k = (int32_t)n - 1, d_at_0 = GLINT_C_ONE * (int32_t)n;
    size_t i = 0;
    for (; i + 8 <= count; i += 8)
        store_f(f_q16 + i, schlick_8(k, d_at_0, load_c(c_q16 + i)));
    _mm256_zeroupper();
    schlick_portable(n, c_q16 + i, f_q16 + i, count - i);
}
#endif

const struct batch_loops batch_loops[] = {
#ifdef AVX2
    {"avx2", runs_avx2, msh_avx2, schlick_avx2},
#endif
    {"portable", runs_everywhere, msh_portable, schlick_portable},
};
const size_t batch_loops_count = sizeof batch_loops / sizeof *batch_loops;

/* ---- any model ---- */

static void each_by_itself(enum glint_model model, uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    for (size_t i = 0; i < count; i++)
        f_q16[i] = glint_eval(model, n, c_q16[i]);
}

static void by_table(enum glint_model model, uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    enum { ENTRIES = GLINT_C_ONE + 1 };
    uint32_t *table = count >= ENTRIES ? malloc(ENTRIES * sizeof *table) : NULL;
    if (!table) {
        each_by_itself(model, n, c_q16, f_q16, count);
        return;
    }
    for (int32_t c = 0; c < ENTRIES; c++)
        table[c] = glint_eval(model, n, c);
    for (size_t i = 0; i < count; i++)
        f_q16[i] = table[clamp_c(c_q16[i])];
    free(table);
}

void batch_eval(enum glint_model model, uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const struct batch_loops *loops = batch_loops;
    while (!loops->runs())
        loops++;
    n = n < 1 ? 1 : n > GLINT_N_MAX ? GLINT_N_MAX : n;
    if (model == GLINT_MSH)
        loops->msh(n, c_q16, f_q16, count);
    else if (model == GLINT_SCHLICK)
        loops->schlick(n, c_q16, f_q16, count);
    else
        by_table(model, n, c_q16, f_q16, count);
}
