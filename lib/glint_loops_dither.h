/* SPDX-License-Identifier: MIT
 * Internal. Lines and spans over COLOUR tables with dither, and a pixel of them. */
#ifndef GLINT_LOOPS_DITHER_H
#define GLINT_LOOPS_DITHER_H

#include "glint_tables_dither.h"
#include "glint_tables_order.h"

/* What a line reads: its parts of the tables, from nl = 0 on. */
struct glint_dither_look {
    const uint8_t *pixels, *sums;
    const uint32_t *shines;
    uint32_t t_max;
    unsigned shift;
    uint32_t nudge; /* of nl, Q30, so that lines take turns between two rows */
};

/* An odd number of eighths of a row for each y mod 4: 7, 5, 1, 3; the order that leaves least beside the thresholds. */
static inline uint32_t glint_dither_nudge(uint32_t y)
{
    return (UINT32_C(0x3157) >> (4 * (y & 3)) & 15) << (GLINT_DITHER_ROW_SHIFT - 3);
}

static inline struct glint_dither_look glint_dither_look_up(const struct glint_tables *tables, uint32_t y)
{
    const uint8_t *const bytes = (const uint8_t *)tables->colour.colours;
    const struct glint_dither_look look = {bytes + (y & 3) * GLINT_DITHER_PIXELS_PART + (1 << GLINT_DITHER_PIXELS_LOG),
                                           bytes + GLINT_DITHER_SUMS + (y & 3) * GLINT_DITHER_SUMS_PART,
                                           (const uint32_t *)(const void *)tables->columns,
                                           tables->t_max_q30,
                                           tables->shift,
                                           glint_dither_nudge(y)};
    return look;
}

/* row: -1 is dark. phase: 2 (x mod 4). */
static inline uint16_t glint_dither_past(const struct glint_dither_look *look, int32_t row, uint32_t phase)
{
    return *(const uint16_t *)(const void *)(look->pixels + row * (1 << GLINT_DITHER_PIXELS_LOG) + phase);
}

/* A sum whose fields may overflow, each to full. */
static inline uint32_t glint_dither_full(uint32_t sum, bool carry)
{
    const uint32_t over = sum & GLINT_DITHER_GUARDS, full = (over - (over >> 5)) | (over & 2048) >> 6;
    return sum | full | (carry ? UINT32_C(0xf8000000) : 0);
}

static inline uint16_t glint_dither_within(const struct glint_dither_look *look, uint32_t row, uint32_t phase,
                                           uint32_t column, bool swapped)
{
    const uint32_t shine = look->shines[column];
    uint32_t sum = *(const uint32_t *)(const void *)(look->sums + (row << GLINT_DITHER_SUMS_LOG) + 2 * phase);
    sum += shine;
    if (sum < shine || sum & GLINT_DITHER_GUARDS)
        sum = glint_dither_full(sum, sum < shine);
    return glint_packed(sum & GLINT_DITHER_FIELDS, swapped);
}

/* A pixel of any t and nl; t modulo 2^32, as lines and spans have it. */
static inline uint16_t glint_dither_pixel(const struct glint_dither_look *look, uint32_t t, uint32_t nl, uint32_t phase,
                                          bool swapped)
{
    if ((int32_t)nl < 0)
        return glint_dither_past(look, -1, phase);
    const uint32_t row = (nl + look->nudge) >> GLINT_DITHER_ROW_SHIFT;
    return t > look->t_max ? glint_dither_past(look, (int32_t)row, phase)
                           : glint_dither_within(look, row, phase, (look->t_max - t) >> look->shift, swapped);
}

/* The phase of the next pixel. */
static inline uint32_t glint_dither_next(uint32_t phase)
{
    return (phase + 2) & 6;
}

/* Aligned 2-byte pixels, the first of them at the screen's x, y. INT8 needs a light whose viewer is at (0, 0, 1). */
void glint_dither_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                       enum glint_normals format, const void *normals, uint16_t w, uint16_t *out, uint32_t x,
                       uint32_t y);
/* Pixels at any address. */
void glint_dither_span(const struct glint_tables *tables, const struct glint_span *span,
                       const struct glint_surface *surface);

/* A line of INT8, as 16-bit numbers or with their bytes swapped; with twins in assembly. phase: 2 (x mod 4). */
void glint_dither_int8_plain(const struct glint_tables *tables, const struct glint_tables_light *light,
                             const uint32_t *words, uint16_t w, uint16_t *out, uint32_t phase, uint32_t y);
void glint_dither_int8_swapped(const struct glint_tables *tables, const struct glint_tables_light *light,
                               const uint32_t *words, uint16_t w, uint16_t *out, uint32_t phase, uint32_t y);

#endif
