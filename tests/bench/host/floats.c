/* SPDX-License-Identifier: MIT
 * The formulas in float over an array, for the compiler to vectorise: -O3. */
#include "../peers.c"
#include "methods.h"

void float_msh(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    const float *c = in;
    float *f = out;
    for (size_t i = 0; i < count; i++)
        f[i] = peer_msh_float((float)n, c[i]);
}

void float_schlick(uint32_t n, const void *restrict in, void *restrict out, size_t count)
{
    const float *c = in;
    float *f = out;
    for (size_t i = 0; i < count; i++)
        f[i] = peer_schlick_float((float)n, c[i]);
}
