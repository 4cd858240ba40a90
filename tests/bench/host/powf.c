/* SPDX-License-Identifier: MIT
 * Blinn's power in float over an array: -Ofast, with which GCC takes libmvec's powf. */
#include <math.h>

#include "methods.h"

void float_blinn(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    const float *c = in;
    float *f = out;
    for (size_t i = 0; i < count; i++)
        f[i] = powf(c[i], (float)n);
}
