/* SPDX-License-Identifier: MIT
 * COLOUR tables where an address or a width is not what the fast loops want: in pieces of so many pixels. */
#include "tables.h"

enum { PIECE = GLINT_RUN };

static void get_pixels(uint16_t *to, const uint8_t *from, uint16_t w)
{
    for (uint16_t i = 0; i < 2 * w; i++)
        ((uint8_t *)to)[i] = from[i];
}

static void put_pixels(uint8_t *to, const uint16_t *from, uint16_t w)
{
    for (uint16_t i = 0; i < 2 * w; i++)
        to[i] = ((const uint8_t *)from)[i];
}

void glint_colour_odd(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, uint16_t w, uint8_t *out)
{
    const size_t size = format == GLINT_NORMALS_INT16 ? sizeof(struct glint_vec) : 4;
    uint16_t piece[PIECE];
    for (uint32_t x = 0; x < w; x += PIECE) {
        const uint16_t count = (uint16_t)(w - x < PIECE ? w - x : PIECE);
        get_pixels(piece, out + 2 * x, count);
        glint_colour_line(tables, light, format, (const uint8_t *)normals + size * x, count, piece);
        put_pixels(out + 2 * x, piece, count);
    }
}

void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint16_t w, uint8_t *out)
{
    struct glint_span at = *span;
    const uint32_t n = PIECE, dnl = (uint32_t)at.dnl_q30;
    const bool aligned = (uintptr_t)out % 2 == 0;
    for (uint32_t left = w; left;) {
        const uint16_t count = (uint16_t)(left < n ? left : n);
        if (aligned) {
            glint_colour_run(tables, &at, count, (uint16_t *)(void *)out);
        } else {
            uint16_t piece[PIECE];
            glint_colour_run(tables, &at, count, piece);
            put_pixels(out, piece, count);
        }
        out += 2 * n;
        left -= count;
        at.t_q30 += n * at.dt_q30 + n * (n - 1) / 2 * at.ddt_q30;
        at.dt_q30 += n * at.ddt_q30;
        at.nl_q30 = (int32_t)((uint32_t)at.nl_q30 + n * dnl);
    }
}
