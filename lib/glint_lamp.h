/* SPDX-License-Identifier: MIT
 * A lamp as a pixel sees it; internal. */
#ifndef GLINT_LAMP_H
#define GLINT_LAMP_H

#include "glint.h"

/* GLINT_OK or GLINT_ERR_ARG. */
enum glint_err glint_lamp_check(const struct glint_lamp *lamp);

/* A point or spot for many pixels: its divisors, range^2 and s_inner - s_outer, as 2^63 / (divisor 2^-exponent) rounded down,
 * that in 2^31 .. 2^32. */
struct glint_reach {
    uint32_t range_inverse, width_inverse;
    uint32_t blur; /* what lamp_cone does not know of its quotient, of 2^31; 0: the cone is left to the 64 bits */
    int8_t range_exponent, width_exponent;
};

/* Of a lamp that glint_lamp_check has seen. */
void glint_reach_init(struct glint_reach *reach, const struct glint_lamp *lamp);
/* From a pixel. */
struct glint_sight {
    int32_t v_q30[3]; /* to the viewer */
    int32_t e[3];     /* to the lamp, as sequence.md has it */
};
#define GLINT_REACH_OPEN UINT32_MAX
/* Steps 1a and 1b: att; L and H of *light only where it is not 0. GLINT_REACH_OPEN where 32 bits do not tell: then glint_reach_exact
 * does. V is there already. */
uint32_t glint_reach_near(const struct glint_reach *reach, const struct glint_lamp *lamp,
                          const struct glint_sight *sight, struct glint_light *light);
uint32_t glint_reach_exact(const struct glint_reach *reach, const struct glint_lamp *lamp,
                           const struct glint_sight *sight, struct glint_light *light);

#endif
