/* SPDX-License-Identifier: MIT
 * What Eva leaves open and is finite, run whole; built with -fsanitize=undefined, which ends it at the first overflow, index or
 * shift that C does not define. */
#include <stdio.h>

#include "glint.h"
#include "glint_lobe_msh.h"
#include "glint_math_reciprocal.h"

/* A product in MSH's quotient grows with u, so that the largest u stands for all. */
static uint32_t mantissas(void)
{
    uint32_t sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (uint32_t m = (uint32_t)1 << 27; m < (uint32_t)1 << 28; m++)
        sum += glint_reciprocal(m) + glint_msh_quotient((uint32_t)1 << 24, m);
    return sum;
}

static uint32_t cosines(void)
{
    uint32_t sum = 0;
#pragma omp parallel for reduction(+ : sum)
    for (uint32_t n = 1; n <= GLINT_N_MAX; n++)
        for (int32_t c = 0; c <= 65536; c++)
            sum += glint_msh(n, c) + glint_cayley(n, c);
    return sum;
}

static uint32_t bytes(void)
{
    uint32_t sum = 0;
    for (uint32_t v = 0; v < 65536; v++)
        sum += glint_srgb_encode((uint16_t)v) + glint_srgb_decode((uint8_t)v);
    return sum;
}

int main(void)
{
    const uint32_t sums[] = {mantissas(), cosines(), bytes()};
    printf("ok 1 - what Eva leaves open and is finite has no undefined behaviour: sums %u %u %u\n1..1\n",
           (unsigned)sums[0], (unsigned)sums[1], (unsigned)sums[2]);
    return 0;
}
