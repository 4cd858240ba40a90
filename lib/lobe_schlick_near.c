/* SPDX-License-Identifier: MIT
 * Schlick from below. */
#include "glint_lobe_schlick.h"
#include "glint_lobe_near.h"

/* 2^28 F < f + GLINT_SCHLICK_LOW, and the two bounds together are less than 2^12: F is this or 1 more. */
static inline uint32_t schlick_near(const struct glint_near *near, uint32_t t)
{
    return t == 0 ? 65536 : (glint_schlick_near_t(near->n, t) + 2048 - GLINT_SCHLICK_HIGH) >> 12;
}

static void schlick_run(const struct glint_near *near, struct glint_sample *samples, unsigned count)
{
    glint_near_run(near, samples, count, schlick_near);
}

const struct glint_shade_model glint_shade_schlick GLINT_FLASH = {GLINT_SCHLICK, 1,           NULL,
                                                                  NULL,          schlick_run, glint_schlick_t};
