/* SPDX-License-Identifier: MIT
 * What the files of the table loops share; not for users. */
#ifndef GLINT_TABLES_H
#define GLINT_TABLES_H

#include "internal.h"
#include "pixel.h"

/* 1: cortex_m0plus.S, assembled with the same definition, instead of the C of the inner loops it has. */
#ifndef GLINT_CORTEX_M0PLUS_ASM
#define GLINT_CORTEX_M0PLUS_ASM 0
#endif

enum { GLINT_SEGMENT = 192, GLINT_DIFFUSE = 65 }; /* SMALL: columns in each half; words for the diffuse part */

/* Where a channel lies in a sum's word, and what 1.0 is there; the guard bit is the one above its top bit. */
struct glint_field {
    uint8_t at, guard;
    uint16_t one;
};
static inline struct glint_field glint_field(uint8_t format, int k)
{
    static const struct glint_field of_565[3] = {{10, 19, 31 * 16}, {20, 30, 63 * 16}, {0, 9, 31 * 16}};
    static const struct glint_field others[3] = {{0, 9, 255 * 2}, {10, 19, 255 * 2}, {20, 29, 255 * 2}};
    return format <= GLINT_RGB565_SWAPPED ? of_565[k] : others[k];
}

/* What a type wants: on 8-bit machines, whose compilers place everything anywhere, 1. */
#define GLINT_MISALIGNED(address_or_stride, type)                                                                      \
    ((uintptr_t)(address_or_stride) % offsetof(                                                                        \
                                          struct {                                                                     \
                                              char before;                                                             \
                                              type at;                                                                 \
                                          },                                                                           \
                                          at) !=                                                                       \
     0)

static inline struct glint_vec glint_unpack_int10(uint32_t word)
{
    const struct glint_vec n = {(int16_t)(((int32_t)word >> 22) * 64), (int16_t)(((int32_t)(word << 10) >> 22) * 64),
                                (int16_t)(((int32_t)(word << 20) >> 20) * 16)};
    return n;
}

/* t and nl of a normal, modulo 2^32: right for unit normals, harmless for others. */
static inline uint32_t glint_fast_t(const struct glint_vec *n, const struct glint_vec *h)
{
    const uint32_t x = (uint32_t)((int32_t)n->x - h->x), y = (uint32_t)((int32_t)n->y - h->y),
                   z = (uint32_t)((int32_t)n->z - h->z);
    return (x * x + y * y + z * z) >> 1;
}
static inline int32_t glint_fast_nl(const struct glint_vec *n, const struct glint_vec *l)
{
    return (int32_t)((uint32_t)(n->x * (int32_t)l->x) + (uint32_t)(n->y * (int32_t)l->y) +
                     (uint32_t)(n->z * (int32_t)l->z));
}

/* A line, COLOUR tables: aligned 2-byte pixels. */
void glint_colour_vec(const struct glint_tables *tables, const struct glint_tables_light *light,
                      const struct glint_vec *normals, uint16_t w, uint16_t *out);
void glint_colour_int10(const struct glint_tables *tables, const struct glint_tables_light *light,
                        const uint32_t *words, uint16_t w, uint16_t *out);
void glint_colour_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       uint16_t w, uint16_t *out);
void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint16_t w, uint16_t *out);

/* Pixels of a span; back = t_max - t, so that a column is back >> shift. Where GLINT_CORTEX_M0PLUS_ASM, in its order. */
struct glint_run {
    uint32_t back, dback, ddback, nl, dnl;
    const uint8_t *columns, *colours;
    uint32_t shift, t_max, limit; /* back <= limit: t is up to t_max, or a little below 0 */
    uint16_t dark;
};
void glint_run_outside(const uint8_t *colours, uint32_t nl, uint32_t dnl, uint16_t *out, const uint16_t *end);
void glint_run_inside(const struct glint_run *run, uint16_t *out, const uint16_t *end);
void glint_run_mixed(const struct glint_run *run, uint16_t *out, const uint16_t *end);

/* A line of a palette. */
void glint_palette_line(const uint16_t *colours, const uint16_t *offsets, uint16_t w, uint16_t *out);

/* A pixel, SMALL tables, any format and alignment. */
void glint_small_pixel(const struct glint_tables *tables, const struct glint_surface *surface, uint16_t x, uint16_t y,
                       uint32_t t_q30, int32_t nl_q30);

#endif
