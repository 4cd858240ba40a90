/* SPDX-License-Identifier: MIT
 * A picture of few normals: they are shaded once, as a palette; each pixel then holds 2 x its place there, as an offset in
 * bytes, so that a pixel costs one load of the offset and one of the colour. */
#include "glint_loops_palette.h"
#include "glint_math_align.h"
#include "glint_math_assembly.h"

#include "glint.h"

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
