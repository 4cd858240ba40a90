/* SPDX-License-Identifier: MIT
 * The demo's sphere, for the program that writes its tables and for the tests. The pixel i right of and j above column 320,
 * row 240 has the normal x = 164 i, y = 164 j in Q1.15 and the z that makes the length 1, rounded down: a radius of 199.8
 * pixels. */
#ifndef GATEWARE_SPHERE_H
#define GATEWARE_SPHERE_H

#include <stdint.h>

enum { SPHERE_X = 320, SPHERE_Y = 240, SPHERE_ROWS = 199, SPHERE_STEP = 164, SPHERE_ONE = 1 << 30 };

/* z^2 at |i|, |j| <= 199. */
static inline int32_t sphere_z2(int32_t i, int32_t j)
{
    return SPHERE_ONE - SPHERE_STEP * SPHERE_STEP * (i * i + j * j);
}

/* Row j shows the pixels from -half to half. */
static inline int32_t sphere_half_width(int32_t j)
{
    int32_t half = 0;
    while (sphere_z2(half + 1, j) >= 0)
        half++;
    return half;
}

/* How many pixels the next span covers: short ones where the sphere turns away. It goes from its first pixel's normal to
 * that of the pixel after its last, so that its steps are divided by a power of two; a row's last span shows that, too. */
static inline int32_t sphere_span(int32_t done, int32_t left)
{
    return done >= 8 && left >= 24 ? 16 : 2;
}

#endif
