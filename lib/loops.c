/* SPDX-License-Identifier: MIT
 * Rectangles, spans and palettes by table loops: what can be refused is refused here, then line by line. */
#include "glint_tables.h"

struct glint_vec glint_normals_unpack(enum glint_normals format, uint32_t word)
{
    struct glint_vec n = {0, 0, 0};
    if (format == GLINT_NORMALS_INT10 && word << 20) {
        n = glint_unpack_int10(word);
    } else if (format == GLINT_NORMALS_INT8 && word >> 16) {
        n.x = (int16_t)((int8_t)word * 256);
        n.y = (int16_t)((int32_t)(int16_t)word - (int8_t)word);
        n.z = (int16_t)(word >> 16);
    }
    return n;
}

static inline void line(const struct glint_tables *tables, const struct glint_tables_light *light,
                        enum glint_normals format, const void *normals, uint16_t w, uint16_t *out)
{
    if (format == GLINT_NORMALS_INT8)
        glint_colour_int8(tables, light, (const uint32_t *)normals, w, out);
    else if (format == GLINT_NORMALS_INT16)
        glint_colour_vec(tables, light, (const struct glint_vec *)normals, w, out);
    else if (light->frontal)
        glint_colour_int10(tables, light, (const uint32_t *)normals, w, out);
    else
        glint_colour_int10_aside(tables, light, (const uint32_t *)normals, w, out);
}

void glint_colour_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                       enum glint_normals format, const void *normals, uint16_t w, uint16_t *out)
{
    line(tables, light, format, normals, w, out);
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
    for (; h; h--, in += stride, out += surface->stride)
        if (GLINT_MISALIGNED(out, 16))
            glint_colour_odd(tables, light, format, in, w, out);
        else
            line(tables, light, format, in, w, (uint16_t *)(void *)out);
    return GLINT_OK;
}

enum glint_err glint_span_any(const struct glint_tables *tables, const struct glint_span *span,
                              const struct glint_surface *surface)
{
    if (!tables || !span || !surface || !surface->pixels || tables->kind == GLINT_TABLES_ALBEDO)
        return GLINT_ERR_ARG;
    if (tables->kind == GLINT_TABLES_SMALL)
        glint_small_span(tables, span, surface);
    else
        glint_colour_span(tables, span, (uint8_t *)surface->pixels);
    return GLINT_OK;
}

#if !GLINT_CORTEX_M0PLUS_ASM
void glint_palette_line(const uint16_t *colours, const uint16_t *offsets, uint16_t w, uint16_t *out)
{
    for (const uint16_t *end = offsets + w; offsets != end; offsets++, out++)
        *out = *(const uint16_t *)(const void *)((const uint8_t *)colours + *offsets);
}
#endif

enum glint_err glint_palette_rect(const uint16_t *colours, const uint16_t *offsets, ptrdiff_t stride, uint16_t w,
                                  uint16_t h, const struct glint_surface *surface)
{
    if (!colours || !offsets || !surface || !surface->pixels || GLINT_MISALIGNED(colours, 16) ||
        GLINT_MISALIGNED(offsets, 16) || GLINT_MISALIGNED(stride, 16) || GLINT_MISALIGNED(surface->pixels, 16) ||
        GLINT_MISALIGNED(surface->stride, 16))
        return GLINT_ERR_ARG;
    for (uint16_t y = 0; y < h; y++) {
        const uint16_t *in = (const uint16_t *)(const void *)((const uint8_t *)offsets + stride * (ptrdiff_t)y);
        uint16_t *out = (uint16_t *)(void *)((uint8_t *)surface->pixels + surface->stride * (ptrdiff_t)y);
        glint_palette_line(colours, in, w, out);
    }
    return GLINT_OK;
}
