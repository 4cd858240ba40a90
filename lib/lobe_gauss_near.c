/* SPDX-License-Identifier: MIT
 * Gauss from below. */
#include "glint_lobe_gauss.h"
#include "glint_lobe_near.h"

/* 2^28 F < f + GLINT_GAUSS_LOW, and the two bounds together are less than 2^12: F is this or 1 more. F > 0 at t = 1, too,
 * where n is small. */
static inline uint32_t gauss_near(const struct glint_near *near, uint32_t t)
{
    if (t == 0 || t == GLINT_T_ONE)
        return glint_gauss_t(near->n, t);
    const uint32_t f = glint_gauss_near_t(near->n, t) + 2048;
    return (f - GLINT_GAUSS_HIGH) >> 12;
}

static void gauss_run(const struct glint_near *near, struct glint_sample *samples, unsigned count)
{
    glint_near_run(near, samples, count, gauss_near);
}

const struct glint_shade_model glint_shade_gauss GLINT_FLASH = {GLINT_GAUSS, 1, NULL, NULL, gauss_run, glint_gauss_t};
