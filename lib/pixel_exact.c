/* SPDX-License-Identifier: MIT */
#include "glint_pixel_exact.h"

#define ONE ((uint64_t)65535 << 32) /* a value of 1.0 */

static const uint8_t bayer[4][4] = {{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};

uint32_t glint_pixel_bayer(uint32_t x, uint32_t y)
{
    return bayer[y & 3][x & 3];
}

uint32_t glint_exact_weight(const struct glint_shader *shader, uint32_t x, uint32_t y)
{
    return shader->dither ? 2 * glint_pixel_bayer(x, y) + 1 : 16;
}

uint64_t glint_exact_value(const struct glint_material *m, int k, uint32_t albedo, uint32_t nl_q16, uint64_t shine)
{
    const uint64_t lit = ((uint64_t)glint_coefficient(m->ambient_q16[k]) << 16) +
                         (uint64_t)glint_coefficient(m->diffuse_q16[k]) * nl_q16;
    const uint64_t x = albedo * lit + glint_coefficient(m->specular_q16[k]) * shine;
    return x < ONE ? x : ONE;
}

uint32_t glint_exact_level(uint64_t x, uint32_t max, uint32_t weight)
{
    return (uint32_t)((x * max + ((uint64_t)65535 << 27) * weight) >> 32) / 65535;
}
