/* SPDX-License-Identifier: MIT
 * What eva_vectors.c shows of a direction, taken for given by the drivers of lights. */
#ifndef EVA_DIRECTIONS_H
#define EVA_DIRECTIONS_H

#include "glint_math_vector.h"

/*@ assigns out[0 .. 2], \result \from v[0 .. 2];
    ensures \result == 0 || \result == 1;
    ensures \initialized(out + (0 .. 2));
    ensures -0x40000000 <= out[0] <= 0x40000000;
    ensures -0x40000000 <= out[1] <= 0x40000000;
    ensures -0x40000000 <= out[2] <= 0x40000000; */
bool glint_unit_q30(int32_t out[3], const int32_t v[3]);

#endif
