/* SPDX-License-Identifier: MIT
 * The formulas as one writes them with libfixmath, Q16.16. */
#include <libfixmath/fix16.h>

#include "methods.h"

void fixmath_msh(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    const fix16_t *c = in, one = fix16_from_int(1);
    fix16_t *f = out;
    for (size_t i = 0; i < count; i++) {
        const fix16_t d = (fix16_t)n * (one - c[i]) + c[i] + (c[i] >> 2);
        const fix16_t ratio = fix16_div(c[i], d);
        f[i] = fix16_div(fix16_mul(ratio, F16(1.6)), d);
    }
}

void fixmath_schlick(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    const fix16_t *c = in, one = fix16_from_int(1);
    fix16_t *f = out;
    for (size_t i = 0; i < count; i++)
        f[i] = fix16_div(c[i], (fix16_t)n * (one - c[i]) + c[i]);
}

void fixmath_blinn(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    const fix16_t *c = in;
    fix16_t *f = out;
    for (size_t i = 0; i < count; i++)
        f[i] = c[i] > 0 ? fix16_exp((fix16_t)n * fix16_log(c[i])) : 0;
}
