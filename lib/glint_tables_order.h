/* SPDX-License-Identifier: MIT
 * Internal. Pixels of RGB565 that loops put together from fields of a word. */
#ifndef GLINT_TABLES_ORDER_H
#define GLINT_TABLES_ORDER_H

#include "glint.h"

/* Does a pixel in the format's order differ from this machine's? */
static inline bool glint_is_swapped(const struct glint_tables *tables)
{
    const uint16_t one = 1;
    const bool low_first = *(const uint8_t *)&one == 1;
    return (tables->format == GLINT_RGB565_SWAPPED) == low_first;
}

/* The fields of both halves side by side. */
static inline uint16_t glint_packed(uint32_t word, bool swapped)
{
    const uint32_t rgb = word | word >> 16;
    return (uint16_t)(swapped ? rgb << 8 | (rgb >> 8 & 255) : rgb);
}

#endif
