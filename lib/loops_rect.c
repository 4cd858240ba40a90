/* SPDX-License-Identifier: MIT
 * Rectangles over COLOUR and SMALL tables: what can be refused is refused here, then line by line by the loop that the
 * normals call for. */
#include "glint_loops_dither.h"
#include "glint_loops_check.h"
#include "glint_loops_colour.h"
#include "glint_loops_piece.h"
#include "glint_loops_small.h"
#include "glint_math_align.h"
#include "glint_tables_normals.h"

/* x, y: where on the screen. */
static void colour_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                        enum glint_normals format, const void *normals, uint16_t w, uint16_t *out, uint32_t x,
                        uint32_t y)
{
    if (tables->dither)
        glint_dither_line(tables, light, format, normals, w, out, x, y);
    else if (format == GLINT_NORMALS_INT8)
        glint_colour_int8(tables, light, (const uint32_t *)normals, w, out);
    else if (format == GLINT_NORMALS_INT16)
        glint_colour_vec(tables, light, (const struct glint_vec *)normals, w, out);
    else if (light->frontal)
        glint_colour_int10(tables, light, (const uint32_t *)normals, w, out);
    else
        glint_colour_int10_aside(tables, light, (const uint32_t *)normals, w, out);
}

/* Pixels at an odd address: piece by piece through an aligned one. It is read, too, as gaps keep what was there. */
static void colour_line_odd(const struct glint_tables *tables, const struct glint_tables_light *light,
                            enum glint_normals format, const void *normals, uint16_t w, uint8_t *out, uint32_t left,
                            uint32_t y)
{
    const size_t size = glint_normals_size(format);
    uint16_t piece[GLINT_PIECE];
    for (uint32_t x = 0; x < w; x += GLINT_PIECE) {
        const uint16_t count = glint_piece(w - x);
        glint_get_pixels(piece, out + 2 * x, count);
        colour_line(tables, light, format, (const uint8_t *)normals + size * x, count, piece, left + x, y);
        glint_put_pixels(out + 2 * x, piece, count);
    }
}

enum glint_err glint_tables_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                                 enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w,
                                 uint16_t h, const struct glint_surface *surface)
{
    const enum glint_err err = glint_tables_check(tables, light, format, normals, stride, surface);
    if (err)
        return err;
    if (tables->kind == GLINT_TABLES_ALBEDO)
        return GLINT_ERR_ARG;
    if (tables->kind == GLINT_TABLES_SMALL) {
        glint_small_rect(tables, light, format, normals, stride, w, h, surface);
        return GLINT_OK;
    }
    const uint8_t *in = (const uint8_t *)normals;
    uint8_t *out = (uint8_t *)surface->pixels;
    for (uint16_t y = 0; y < h; y++, in += stride, out += surface->stride)
        if (GLINT_MISALIGNED(out, 16))
            colour_line_odd(tables, light, format, in, w, out, surface->x, surface->y + (uint32_t)y);
        else
            colour_line(tables, light, format, in, w, (uint16_t *)(void *)out, surface->x, surface->y + (uint32_t)y);
    return GLINT_OK;
}
