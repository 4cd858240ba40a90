/* SPDX-License-Identifier: MIT
 * Where an address or a width is not what the fast loops want: in pieces of so many pixels, 64 bytes of stack. */
#include "glint_tables.h"

enum { PIECE = GLINT_RUN };

void glint_get_pixels(uint16_t *to, const uint8_t *from, uint16_t w)
{
    for (uint16_t i = 0; i < 2 * w; i++)
        ((uint8_t *)to)[i] = from[i];
}

void glint_put_pixels(uint8_t *to, const uint16_t *from, uint16_t w)
{
    for (uint16_t i = 0; i < 2 * w; i++)
        to[i] = ((const uint8_t *)from)[i];
}

void glint_colour_odd(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, uint16_t w, uint8_t *out)
{
    const size_t size = glint_normals_size(format);
    uint16_t piece[PIECE];
    for (uint32_t x = 0; x < w; x += PIECE) {
        const uint16_t count = glint_piece(w - x);
        glint_get_pixels(piece, out + 2 * x, count);
        glint_colour_line(tables, light, format, (const uint8_t *)normals + size * x, count, piece);
        glint_put_pixels(out + 2 * x, piece, count);
    }
}

void glint_albedo_odd(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w, uint8_t *out)
{
    const size_t size = glint_normals_size(format);
    uint16_t piece[PIECE];
    for (uint32_t x = 0; x < w; x += PIECE) {
        const uint16_t count = glint_piece(w - x);
        glint_get_pixels(piece, out + 2 * x, count);
        glint_albedo_line(tables, light, format, (const uint8_t *)normals + size * x, albedo + x, count, piece);
        glint_put_pixels(out + 2 * x, piece, count);
    }
}

static inline void advance(struct glint_span *at)
{
    const uint32_t n = PIECE;
    at->t_q30 += n * at->dt_q30 + n * (n - 1) / 2 * at->ddt_q30;
    at->dt_q30 += n * at->ddt_q30;
    at->nl_q30 = (int32_t)((uint32_t)at->nl_q30 + n * (uint32_t)at->dnl_q30);
}

static void odd_span(const struct glint_tables *tables, struct glint_span *at, uint32_t w, uint8_t *out)
{
    for (uint32_t left = w; left;) {
        uint16_t piece[PIECE];
        const uint16_t count = glint_piece(left);
        glint_colour_run(tables, at, count, piece);
        glint_put_pixels(out, piece, count);
        out += 2 * PIECE;
        left -= count;
        advance(at);
    }
}

void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint8_t *out)
{
    struct glint_span at = *span;
    if (GLINT_MISALIGNED(out, 16)) {
        odd_span(tables, &at, at.w, out);
        return;
    }
    uint32_t left = at.w;
    for (; left > PIECE; left -= PIECE, out += 2 * PIECE) {
        glint_colour_run(tables, &at, PIECE, (uint16_t *)(void *)out);
        advance(&at);
    }
    if (left)
        glint_colour_run(tables, &at, (uint16_t)left, (uint16_t *)(void *)out);
}
