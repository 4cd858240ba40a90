/* SPDX-License-Identifier: MIT
 * Internal. A colour of COLOUR tables from t and nl. */
#ifndef GLINT_LOOPS_LOOK_H
#define GLINT_LOOPS_LOOK_H

#include "glint.h"
#include "glint_pixel.h"
#include "glint_tables_geometry.h"

/* Tables and limits in registers: the output may alias the structs as far as compilers know. */
struct glint_look {
    const uint8_t *columns;
    const uint8_t *colours;
    uint32_t t_max, limit; /* limit: see glint_look_store */
    unsigned shift;
    uint16_t dark;
};

static inline struct glint_look glint_look_up(const struct glint_tables *tables)
{
    const struct glint_look look = {tables->columns,   (const uint8_t *)tables->colour.colours,
                                    tables->t_max_q30, tables->t_max_q30 - GLINT_NEGATIVE_T,
                                    tables->shift,     tables->dark};
    return look;
}

/* at: in bytes, as the columns are. */
static inline uint16_t glint_look_colour(const struct glint_look *look, uint32_t at)
{
    return *(const uint16_t *)(const void *)(look->colours + at);
}

static inline uint32_t glint_look_row(uint32_t nl)
{
    return nl >> GLINT_COLOUR_ROW_SHIFT << GLINT_COLOUR_ROW_BYTES_LOG;
}

/* A span's pixel. back = t_max - t, modulo 2^32: a t a little below 0 makes it more than t_max, by no more than limit allows. */
static inline void glint_look_store(const struct glint_look *look, uint32_t back, uint32_t nl, uint16_t *out)
{
    if ((int32_t)nl < 0) {
        *out = look->dark;
        return;
    }
    uint32_t at = glint_look_row(nl);
    if (back <= look->limit)
        at += look->columns[(back <= look->t_max ? back : look->t_max) >> look->shift];
    *out = glint_look_colour(look, at);
}

#endif
