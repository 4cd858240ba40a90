/* SPDX-License-Identifier: MIT
 * Internal. Three channels in a word: sums of two such words are the channels' sums. */
#ifndef GLINT_TABLES_FIELD_H
#define GLINT_TABLES_FIELD_H

#include "glint.h"
#include "glint_pixel_exact.h"

/* Where a channel lies in the word, and what 1.0 is there; the guard bit is the one above its top bit: set by a sum that
 * overflows the channel. */
struct glint_field {
    uint8_t at, guard;
    uint16_t one;
};

/* SMALL tables: RGB565 5.4, 6.4, 5.4 bits; else 8.1 bits each. */
static inline struct glint_field glint_field_of(uint8_t format, int k)
{
    static const struct glint_field of_565[3] GLINT_FLASH = {{10, 19, 31 * 16}, {20, 30, 63 * 16}, {0, 9, 31 * 16}};
    static const struct glint_field others[3] GLINT_FLASH = {{0, 9, 255 * 2}, {10, 19, 255 * 2}, {20, 29, 255 * 2}};
    return glint_format_is_565(format) ? GLINT_FLASH_STRUCT(struct glint_field, of_565[k])
                                       : GLINT_FLASH_STRUCT(struct glint_field, others[k]);
}

/* A value (65535 * 2^32 = 1.0) as a field's level, nearest. one < 2^10, so the product is below 2^58. */
static inline uint32_t glint_field_level(struct glint_field field, uint64_t value)
{
    return (uint32_t)((value * field.one + ((uint64_t)65535 << 31)) >> 32) / 65535;
}

#endif
