/* SPDX-License-Identifier: MIT
 * Random lamps about the random scenes. */
#ifndef GLINT_UNIT_LAMPS_H
#define GLINT_UNIT_LAMPS_H

#include "shading.h"

enum { ONE_Q30 = 1 << 30, PIXEL = 16 };

static inline int32_t within(int32_t limit)
{
    return (int32_t)below(2 * (uint32_t)limit + 1) - limit;
}

static inline int32_t cosine(double degrees)
{
    return (int32_t)lround(ONE_Q30 * cos(degrees * M_PI / 180));
}

static inline struct glint_lamp random_lamp(void)
{
    struct glint_lamp lamp;
    enum glint_err err;
    do {
        const int32_t a[3] = {(int32_t)below(W * PIXEL), (int32_t)below(H * PIXEL), within(600)};
        const int32_t b[3] = {(int32_t)below(W * PIXEL), (int32_t)below(H * PIXEL), within(100)};
        const int32_t direction[3] = {within(100), within(100), within(100) + 50}, viewer[3] = {0, 0, 1};
        const uint32_t range = 1 + below(1500);
        const double inner = below(9000) / 100., outer = inner + below(3000) / 100.;
        switch (below(3)) {
        case GLINT_DIRECTIONAL:
            err = glint_lamp_directional(&lamp, direction, viewer);
            break;
        case GLINT_POINT:
            err = glint_lamp_point(&lamp, a, range);
            break;
        default:
            err = glint_lamp_spot(&lamp, a, b, range, cosine(inner), cosine(outer));
        }
    } while (err != GLINT_OK);
    for (int k = 0; k < 3; k++)
        lamp.color_q16[k] = below(4) ? below(65537) : 65536;
    return lamp;
}

static inline void random_lamps(struct glint_lamp lamps[GLINT_LAMPS_MAX])
{
    for (unsigned i = 0; i < GLINT_LAMPS_MAX; i++)
        lamps[i] = random_lamp();
}

#endif
