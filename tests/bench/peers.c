/* SPDX-License-Identifier: MIT */
#include "peers.h"

#include <math.h>

#include "glint.h"

float peer_blinn_powf(float n, float c)
{
    return powf(c, n);
}

float peer_schlick_float(float n, float c)
{
    return c / (n - n * c + c);
}

float peer_msh_float(float n, float c)
{
    const float d = n - n * c + 1.25f * c;
    return 2 * c / (1.25f * d * d);
}

/* c^n at 256 steps of c, the nearest below, for one n: the method of software renderers. */
static uint16_t table[257];

void peer_table_fill(uint32_t n)
{
    for (uint32_t i = 0; i < 256; i++)
        table[i] = (uint16_t)glint_blinn(n, (int32_t)(i << 8));
    table[256] = UINT16_MAX;
}

uint32_t peer_table(uint32_t n, uint32_t c_q16)
{
    (void)n;
    return table[c_q16 >> 8];
}
