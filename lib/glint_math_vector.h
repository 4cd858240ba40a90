/* SPDX-License-Identifier: MIT
 * Internal. Unit vectors in Q2.30. */
#ifndef GLINT_MATH_VECTOR_H
#define GLINT_MATH_VECTOR_H

#include "glint.h"

/* v / |v|, good to 2^-28; false where v = 0. */
bool glint_unit_q30(int32_t out[3], const int32_t v[3]);
/* From unit vectors; false where the light is straight behind. */
bool glint_light_between(struct glint_light *light, const int32_t l_q30[3], const int32_t v_q30[3]);

#endif
