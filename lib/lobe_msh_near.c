/* SPDX-License-Identifier: MIT
 * MSH from below. E = 2^16 (4n(1 - c) + 5c) comes scaled by 2^up, such that m, the largest, is just below 2^28: most of a
 * highlight is dim, so most pixels need no shift more. */
#include "glint_lobe_msh.h"
#include "glint_lobe_msh_near.h"
#include "glint_lobe_near.h"

/* m = FACTOR t 2^-14 + ADDEND, < 2^28 for t < t_end, where F > 0 and so E < 2^27: up >= 1. FACTOR < 2^17. */
static void msh_fold(struct glint_near *near)
{
    const int32_t k = 4 * (int32_t)near->n - 5;
    const uint32_t t = near->t_end - 1;
    uint32_t largest = (uint32_t)5 << 16; /* E + 1, or at t = 0 where n = 1 */
    if (k > 0)
        largest += (uint32_t)k * (t >> 14) + ((uint32_t)k * (t & 0x3fff) >> 14) + 1;
    unsigned up = 0;
    while (largest << up < (uint32_t)1 << 27 && k * ((int32_t)1 << up) < (int32_t)1 << 16)
        up++;
    near->k[GLINT_MSH_FACTOR] = k * ((int32_t)1 << up);
    near->k[GLINT_MSH_ADDEND] = (int32_t)((uint32_t)5 << 16 << up);
    near->k[GLINT_MSH_SHIFT] = 32 - 2 * (int32_t)up;
}

static inline uint32_t msh_near(const struct glint_near *near, uint32_t t)
{
    const int32_t k = near->k[GLINT_MSH_FACTOR];
    uint32_t m =
        (uint32_t)(k * (int32_t)(t >> 14) + (k * (int32_t)(t & 0x3fff) >> 14)) + (uint32_t)near->k[GLINT_MSH_ADDEND];
    unsigned shift = (unsigned)near->k[GLINT_MSH_SHIFT];
    while (!(m >> 27)) {
        m <<= 1;
        shift -= 2;
    }
    const uint32_t f =
        (glint_msh_quotient((GLINT_T_ONE - t) >> 6, m) + ((uint32_t)1 << shift >> 1) - GLINT_MSH_HIGH) >> shift;
    return f < near->f_max ? f : near->f_max;
}

static void msh_run(const struct glint_near *near, struct glint_sample *samples, unsigned count)
{
    glint_near_run(near, samples, count, msh_near);
}

const struct glint_shade_model glint_shade_msh GLINT_FLASH = {GLINT_MSH, 1, NULL, msh_fold, msh_run, glint_msh_t};
