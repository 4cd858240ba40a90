/* SPDX-License-Identifier: MIT
 * Blinn's power from below. */
#include "glint_lobe_near.h"
#include "glint_math_power.h"

/* The power is f 2^-32 or up to 3n - 2 < 2^12 more of 2^-32: F is this or 1 more. */
static inline uint32_t blinn_near(const struct glint_near *near, uint32_t t)
{
    return t == 0 ? 65536 : ((glint_power_near((GLINT_T_ONE - t) << 2, near->n) >> 15) + 1) >> 1;
}

void glint_blinn_run(const struct glint_near *near, struct glint_sample *samples, unsigned count)
{
    glint_near_run(near, samples, count, blinn_near);
}

const struct glint_shade_model glint_shade_blinn GLINT_FLASH = {GLINT_BLINN,  1, NULL, NULL, glint_blinn_run,
                                                                glint_blinn_t};
