/* SPDX-License-Identifier: MIT */
#include "glint_loops_piece.h"

void glint_get_pixels(uint16_t *to, const uint8_t *from, uint16_t w)
{
    for (uint32_t i = 0; i < 2 * (uint32_t)w; i++)
        ((uint8_t *)to)[i] = from[i];
}

void glint_put_pixels(uint8_t *to, const uint16_t *from, uint16_t w)
{
    for (uint32_t i = 0; i < 2 * (uint32_t)w; i++)
        to[i] = ((const uint8_t *)from)[i];
}
