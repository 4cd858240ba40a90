/* SPDX-License-Identifier: MIT
 * Internal. Packed normals as the loops read them. */
#ifndef GLINT_TABLES_NORMALS_H
#define GLINT_TABLES_NORMALS_H

#include "glint.h"

/* Bytes a normal. */
static inline size_t glint_normals_size(enum glint_normals format)
{
    return format == GLINT_NORMALS_INT16 ? sizeof(struct glint_vec) : 4;
}

/* The word's fields, shifted up to its sign bit and down to Q15 each. */
static inline struct glint_vec glint_unpack_int10(uint32_t word)
{
    const struct glint_vec n = {(int16_t)(((int32_t)word >> 22) * 64), (int16_t)(((int32_t)(word << 10) >> 22) * 64),
                                (int16_t)(((int32_t)(word << 20) >> 20) * 16)};
    return n;
}

/* Normal i of a line in any format; 0, 0, 0 where there is no surface. */
static inline struct glint_vec glint_normal_at(enum glint_normals format, const void *normals, uint32_t i)
{
    return format == GLINT_NORMALS_INT16 ? ((const struct glint_vec *)normals)[i]
                                         : glint_normals_unpack(format, ((const uint32_t *)normals)[i]);
}

/* From a word without surface on: how many more are to be stepped over. */
static inline uint32_t glint_gap(uint32_t count, size_t left)
{
    return (uint32_t)(count < 1 ? 1 : count < left ? count : left) - 1;
}

#endif
