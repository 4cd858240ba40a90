/* SPDX-License-Identifier: MIT
 * Highlight functions in floating point, and exact: the error of each sequence of operations, whether or not the compiler
 * fuses multiplications and additions, is below the distance of every value from the nearest rounding tie. */
#include "models/batch_portable.h"

bool batch_runs_portable(void)
{
    return true;
}

struct batch_msh batch_msh_of(uint32_t n)
{
    const int32_t k = 4 * (int32_t)n - 5;
    const double scale = 0x1p39 / 5;
    return (struct batch_msh){k, 4 * GLINT_C_ONE * (int32_t)n, scale * (GLINT_C_ONE + 5.0 * GLINT_C_ONE / k),
                              scale / k};
}

void batch_msh_portable(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const struct batch_msh m = batch_msh_of(n);
#pragma omp simd
    for (size_t i = 0; i < count; i++) {
        const double u = 1.0 / (m.e_at_0 - m.k * batch_clamp_c(c_q16[i]));
        f_q16[i] = (uint32_t)(int32_t)(u * (m.a * u - m.b) + 0.5);
    }
}

/* F 2^16 = 2^16 C / D, D = n(2^16 - C) + C <= 2^26: at least 2^-27 from a tie, computed within 2^-36. Without an error
 * where it is a tie: C = 32896, n = 513. */
void batch_schlick_portable(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const int32_t k = (int32_t)n - 1, d_at_0 = GLINT_C_ONE * (int32_t)n;
#pragma omp simd
    for (size_t i = 0; i < count; i++) {
        const int32_t c = batch_clamp_c(c_q16[i]);
        f_q16[i] = (uint32_t)(int32_t)((double)GLINT_C_ONE * c / (d_at_0 - k * c) + 0.5);
    }
}

void batch_cayley_portable(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const int32_t k = (int32_t)n;
#pragma omp simd
    for (size_t i = 0; i < count; i++) {
        const int32_t d = GLINT_C_ONE - batch_clamp_c(c_q16[i]), p = 8 * GLINT_C_ONE - (k + 4) * d;
        const double r = 16.0 * (p > 0 ? p : 0) / (8 * GLINT_C_ONE + (k - 4) * d), square = r * r;
        f_q16[i] = (uint32_t)(int32_t)(square * square + 0.5);
    }
}

void batch_lyon_portable(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const int32_t k = (int32_t)n;
#pragma omp simd
    for (size_t i = 0; i < count; i++) {
        const int32_t c = c_q16[i], p = 4 * GLINT_C_ONE - k * (GLINT_C_ONE - batch_clamp_c(c));
        const double base = (p > 0 ? p : 0) * 0x1p-14, square = base * base;
        f_q16[i] = c < 0 ? 0 : (uint32_t)(int32_t)(square * square + 0.5); /* at c = 0 it is more than 0 for n < 4 */
    }
}

void batch_ggx_portable(uint32_t n, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    const double k = n, d_at_0 = 0x1p33 + k * 0x1p32;
#pragma omp simd
    for (size_t i = 0; i < count; i++) {
        const double c = batch_clamp_c(c_q16[i]), root = 0x1p41 / (d_at_0 - k * (c * c));
        f_q16[i] = c_q16[i] < 0 ? 0 : (uint32_t)(int32_t)(root * root + 0.5);
    }
}

void batch_lookup_portable(const uint32_t *table, const int32_t *c_q16, uint32_t *f_q16, size_t count)
{
    for (size_t i = 0; i < count; i++)
        f_q16[i] = c_q16[i] < 0 ? 0 : table[batch_clamp_c(c_q16[i])];
}
