/* SPDX-License-Identifier: MIT
 * Cayley from below; for n <= 4 it is Blinn's power. */
#include "glint_lobe_cayley.h"
#include "glint_lobe_near.h"

/* 2^28 F < f + GLINT_CAYLEY_LOW, and the two bounds together are less than 2^12: F is this or 1 more. */
static inline uint32_t cayley_near(const struct glint_near *near, uint32_t t)
{
    return t == 0 ? 65536 : (glint_cayley_near_t(near->n, t) + 2048 - GLINT_CAYLEY_HIGH) >> 12;
}

static void cayley_run(const struct glint_near *near, struct glint_sample *samples, unsigned count)
{
    if (near->n > 4)
        glint_near_run(near, samples, count, cayley_near);
    else
        glint_blinn_run(near, samples, count);
}

const struct glint_shade_model glint_shade_cayley GLINT_FLASH = {GLINT_CAYLEY, 1,          NULL,
                                                                 NULL,         cayley_run, glint_cayley_t};
