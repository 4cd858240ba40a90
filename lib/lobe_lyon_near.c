/* SPDX-License-Identifier: MIT
 * Lyon, whose own function is quick. */
#include "glint_lobe_near.h"

static inline uint32_t lyon_near(const struct glint_near *near, uint32_t t)
{
    return glint_lyon_t(near->n, t);
}

static void lyon_run(const struct glint_near *near, struct glint_sample *samples, unsigned count)
{
    glint_near_run(near, samples, count, lyon_near);
}

const struct glint_shade_model glint_shade_lyon GLINT_FLASH = {GLINT_LYON, 0, NULL, NULL, lyon_run, glint_lyon_t};
