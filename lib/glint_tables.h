/* SPDX-License-Identifier: MIT
 * What the files of the table loops share; not for users. */
#ifndef GLINT_TABLES_H
#define GLINT_TABLES_H

#include "glint_internal.h"
#include "glint_pixel.h"

/* 1: cortex_m0plus_*.S, assembled with the same definition, instead of the C of the loops that they have. */
#ifndef GLINT_CORTEX_M0PLUS_ASM
#define GLINT_CORTEX_M0PLUS_ASM 0
#endif

enum { GLINT_SEGMENT = 192, GLINT_DIFFUSE = 65 }; /* SMALL: columns in each half; words for the diffuse part */

/* Where a channel lies in a sum's word, and what 1.0 is there; the guard bit is the one above its top bit. */
struct glint_field {
    uint8_t at, guard;
    uint16_t one;
};
static inline struct glint_field glint_field_of(uint8_t format, int k)
{
    static const struct glint_field of_565[3] = {{10, 19, 31 * 16}, {20, 30, 63 * 16}, {0, 9, 31 * 16}};
    static const struct glint_field others[3] = {{0, 9, 255 * 2}, {10, 19, 255 * 2}, {20, 29, 255 * 2}};
    return format <= GLINT_RGB565_SWAPPED ? of_565[k] : others[k];
}

/* A value (65535 * 2^32 = 1.0) as a field's level, nearest. */
static inline uint32_t glint_field_level(struct glint_field field, uint64_t value)
{
    return (uint32_t)((value * field.one + ((uint64_t)65535 << 31)) >> 32) / 65535;
}

/* Columns over t = 0..t_max, the one of t_max first: a power of two of t each, some to spare at the peak. */
unsigned glint_columns_shift(uint32_t t_max_q30, uint32_t columns);
static inline uint32_t glint_column_t(uint32_t t_max_q30, unsigned shift, uint32_t i) /* its middle */
{
    const uint64_t back = ((uint64_t)i << shift) + ((uint32_t)1 << shift >> 1);
    return back < t_max_q30 ? t_max_q30 - (uint32_t)back : 0;
}

/* The largest t, up to the cutoff, whose F shows: F falls as t grows, so what shows no more does not come back. */
static inline uint32_t glint_last_t(const struct glint_shader *shader,
                                    bool (*shows)(const struct glint_shader *shader, uint32_t f))
{
    uint32_t t = 0;
    for (uint32_t bit = (uint32_t)1 << 30; bit; bit >>= 1)
        if ((t | bit) <= shader->lobe.t_max_q30 && shows(shader, glint_pixel_lobe(shader, t | bit)))
            t |= bit;
    return t;
}

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

/* Bytes a normal; what every rectangle refuses. */
static inline size_t glint_normals_size(enum glint_normals format)
{
    return format == GLINT_NORMALS_INT16 ? sizeof(struct glint_vec) : 4;
}
static inline enum glint_err glint_tables_check(const struct glint_tables *tables,
                                                const struct glint_tables_light *light, enum glint_normals format,
                                                const void *normals, ptrdiff_t stride,
                                                const struct glint_surface *surface)
{
    if (!tables || !light || !normals || !surface || !surface->pixels || tables->kind != light->kind ||
        (glint_normals_size(format) == 4 ? GLINT_MISALIGNED(normals, 32) || GLINT_MISALIGNED(stride, 32)
                                         : GLINT_MISALIGNED(normals, 16) || GLINT_MISALIGNED(stride, 16)))
        return GLINT_ERR_ARG;
    if ((unsigned)format > GLINT_NORMALS_INT8)
        return GLINT_ERR_FORMAT;
    return tables->kind != GLINT_TABLES_SMALL && format == GLINT_NORMALS_INT8 && !light->frontal ? GLINT_ERR_VECTOR
                                                                                                 : GLINT_OK;
}

/* Pixels from and to odd addresses. */
void glint_get_pixels(uint16_t *to, const uint8_t *from, uint16_t w);
void glint_put_pixels(uint8_t *to, const uint16_t *from, uint16_t w);

/* A line, COLOUR tables: aligned 2-byte pixels. */
void glint_colour_vec(const struct glint_tables *tables, const struct glint_tables_light *light,
                      const struct glint_vec *normals, uint16_t w, uint16_t *out);
void glint_colour_int10(const struct glint_tables *tables, const struct glint_tables_light *light,
                        const uint32_t *words, uint16_t w, uint16_t *out);
void glint_colour_int10_aside(const struct glint_tables *tables, const struct glint_tables_light *light,
                              const uint32_t *words, uint16_t w, uint16_t *out);
void glint_colour_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       uint16_t w, uint16_t *out);

/* The first w pixels of a span, 1..GLINT_RUN, COLOUR tables; and for C the loops that they take. */
enum { GLINT_RUN = 32 };
static inline uint16_t glint_piece(uint32_t left) /* how many of so many pixels are one run */
{
    const uint16_t run = GLINT_RUN;
    return left < run ? (uint16_t)left : run;
}

void glint_colour_run(const struct glint_tables *tables, const struct glint_span *at, uint16_t w, uint16_t *out);
void glint_run_dark(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out, const uint16_t *end);
void glint_run_outside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                       const uint16_t *end);
void glint_run_inside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                      const uint16_t *end);
void glint_run_mixed(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                     const uint16_t *end);

/* Any span; where an address or a width is not what a fast loop wants, in pieces. */
void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint8_t *out);
void glint_colour_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                       enum glint_normals format, const void *normals, uint16_t w, uint16_t *out);
void glint_colour_odd(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, uint16_t w, uint8_t *out);
void glint_small_span(const struct glint_tables *tables, const struct glint_span *span,
                      const struct glint_surface *surface);
void glint_small_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w, uint16_t h,
                      const struct glint_surface *surface);

/* glint_tables_span, of which the assembly does the common case. */
enum glint_err glint_span_any(const struct glint_tables *tables, const struct glint_span *span,
                              const struct glint_surface *surface);

/* ALBEDO tables: may they be filled for this material? Their fill, and what is theirs of a light whose l and h are set. */
bool glint_albedo_can(const struct glint_material *material);
void glint_albedo_fill(struct glint_tables *tables, const struct glint_shader *shader, uint32_t *memory);
void glint_albedo_light(struct glint_tables_light *light, const struct glint_tables *tables);
/* A line: aligned 2-byte pixels, as 16-bit numbers, or those with their bytes swapped. */
void glint_albedo_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       const uint16_t *albedo, uint16_t w, uint16_t *out);
void glint_albedo_int8_swapped(const struct glint_tables *tables, const struct glint_tables_light *light,
                               const uint32_t *words, const uint16_t *albedo, uint16_t w, uint16_t *out);

/* Any line, aligned and not. */
void glint_albedo_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                       enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w,
                       uint16_t *out);
void glint_albedo_odd(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w, uint8_t *out);

/* A line of a palette. */
void glint_palette_line(const uint16_t *colours, const uint16_t *offsets, uint16_t w, uint16_t *out);

#endif
