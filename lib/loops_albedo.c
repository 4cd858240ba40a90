/* SPDX-License-Identifier: MIT
 * The loops over ALBEDO tables. All three channels are scaled by one multiplication: spread over a word as fields with room
 * between them, the albedo takes a level of 32 without one field reaching the next; the highlight is added, field by field,
 * and what overflows into a guard bit is set full. RAM: 8,584 bytes of tables, what a light takes, no buffers. */
#include "glint_loops_albedo.h"
#include "glint_loops_check.h"
#include "glint_loops_piece.h"
#include "glint_loops_vector.h"
#include "glint_math_align.h"
#include "glint_pixel.h"
#include "glint_tables_albedo.h"
#include "glint_math_assembly.h"
#include "glint_tables_geometry.h"
#include "glint_tables_normals.h"
#include "glint_tables_order.h"

#define FIELDS GLINT_ALBEDO_FIELDS
#define FIELDS_HALF UINT32_C(0x02008010) /* of 32nds, in each field */

/* ---- A pixel ---- */

static inline uint32_t lit(uint16_t albedo, uint32_t level)
{
    return (((albedo | (uint32_t)albedo << 16) & FIELDS) * level + FIELDS_HALF) >> 5 & FIELDS;
}

static inline uint32_t full(uint32_t sum) /* a field whose guard is set is full */
{
    const uint32_t over = sum & ~FIELDS;
    return over ? (sum | (over - (over >> 5)) | over >> 6) & FIELDS
                : sum; /* green has 6 bits: its lowest by the >> 6 */
}

/* ---- Lines ---- */

/* By t and nl, as spans and the wider normals have them. Below 0, t may come by rounding. */
static inline uint16_t albedo_pixel(const struct glint_tables *tables, uint32_t t, int32_t nl, uint16_t albedo,
                                    bool swapped)
{
    uint32_t word = lit(albedo, nl < 0 ? tables->dark : *glint_albedo_level(tables, nl >> GLINT_ALBEDO_LEVEL_SHIFT));
    if (nl >= 0 && t <= tables->t_max_q30)
        word = full(word + tables->colour.sums[(tables->t_max_q30 - t) >> tables->shift]);
    return glint_packed(word, swapped);
}

static void wide_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w, uint16_t *out)
{
    const struct glint_vec l = light->l, h = light->h;
    const bool swapped = glint_is_swapped(tables);
    for (uint16_t i = 0; i < w; i++) {
        const struct glint_vec n = glint_normal_at(format, normals, i);
        if (n.x | n.y | n.z)
            out[i] = albedo_pixel(tables, glint_fast_t(&n, &h), glint_fast_nl(&n, &l), albedo[i], swapped);
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM
static inline void int8_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                             const uint32_t *words, const uint16_t *albedo, uint16_t w, uint16_t *out, bool swapped)
{
    const uint32_t *const shine = tables->colour.sums;
    const uint8_t *const levels = tables->columns;
    const int32_t lx = light->x, ly = light->y, lz = light->z;
    const uint32_t cut = (uint32_t)light->cut, dark = tables->dark, r = light->r;
    for (uint16_t i = 0; i < w; i++) {
        const uint32_t word = words[i];
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            const uint16_t left = (uint16_t)(w - i), gap = (uint16_t)(word ? word : 1);
            i = (uint16_t)(i + (gap < left ? gap : left) - 1);
            continue;
        }
        /* Q25, negative where lit: the level is behind its table's end, and e needs no other address */
        const int32_t d = (int8_t)word * lx + (int16_t)word * ly + z * lz;
        if (d >= 0) {
            out[i] = glint_packed(lit(albedo[i], dark), swapped);
            continue;
        }
        uint32_t sum = lit(albedo[i], levels[d >> (GLINT_ALBEDO_LEVEL_SHIFT - 5)]);
        const uint32_t e = ((uint32_t)z << 10) - cut - (uint32_t)d;
        if ((int32_t)e >= 0)
            sum = full(sum + shine[(e * r) >> (32 - GLINT_ALBEDO_COLUMNS_LOG)]);
        out[i] = glint_packed(sum, swapped);
    }
}

void glint_albedo_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       const uint16_t *albedo, uint16_t w, uint16_t *out)
{
    int8_line(tables, light, words, albedo, w, out, false);
}

void glint_albedo_int8_swapped(const struct glint_tables *tables, const struct glint_tables_light *light,
                               const uint32_t *words, const uint16_t *albedo, uint16_t w, uint16_t *out)
{
    int8_line(tables, light, words, albedo, w, out, true);
}
#endif

static void albedo_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                        enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w,
                        uint16_t *out)
{
    if (format != GLINT_NORMALS_INT8)
        wide_line(tables, light, format, normals, albedo, w, out);
    else if (glint_is_swapped(tables))
        glint_albedo_int8_swapped(tables, light, (const uint32_t *)normals, albedo, w, out);
    else
        glint_albedo_int8(tables, light, (const uint32_t *)normals, albedo, w, out);
}

/* Pixels at an odd address: piece by piece through an aligned one. It is read, too, as gaps keep what was there. */
static void albedo_line_odd(const struct glint_tables *tables, const struct glint_tables_light *light,
                            enum glint_normals format, const void *normals, const uint16_t *albedo, uint16_t w,
                            uint8_t *out)
{
    const size_t size = glint_normals_size(format);
    uint16_t piece[GLINT_PIECE];
    for (uint32_t x = 0; x < w; x += GLINT_PIECE) {
        const uint16_t count = glint_piece(w - x);
        glint_get_pixels(piece, out + 2 * x, count);
        albedo_line(tables, light, format, (const uint8_t *)normals + size * x, albedo + x, count, piece);
        glint_put_pixels(out + 2 * x, piece, count);
    }
}

enum glint_err glint_tables_albedo_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                                        enum glint_normals format, const void *normals, ptrdiff_t stride,
                                        const uint16_t *albedo, ptrdiff_t albedo_stride, uint16_t w, uint16_t h,
                                        const struct glint_surface *surface)
{
    const enum glint_err err = glint_tables_check(tables, light, format, normals, stride, surface);
    if (err)
        return err;
    if (tables->kind != GLINT_TABLES_ALBEDO || !albedo || GLINT_MISALIGNED(albedo, 16) ||
        GLINT_MISALIGNED(albedo_stride, 16))
        return GLINT_ERR_ARG;
    const uint8_t *in = (const uint8_t *)normals, *map = (const uint8_t *)albedo;
    uint8_t *out = (uint8_t *)surface->pixels;
    for (; h; h--) {
        const uint16_t *colours = (const uint16_t *)(const void *)map;
        if (GLINT_MISALIGNED(out, 16))
            albedo_line_odd(tables, light, format, in, colours, w, out);
        else
            albedo_line(tables, light, format, in, colours, w, (uint16_t *)(void *)out);
        in += stride;
        map += albedo_stride;
        out += surface->stride;
    }
    return GLINT_OK;
}

enum glint_err glint_tables_albedo_span(const struct glint_tables *tables, const struct glint_span *span,
                                        const uint16_t *albedo, const struct glint_surface *surface)
{
    if (!tables || !span || !albedo || !surface || !surface->pixels || tables->kind != GLINT_TABLES_ALBEDO ||
        GLINT_MISALIGNED(albedo, 16))
        return GLINT_ERR_ARG;
    const bool swapped = glint_is_swapped(tables);
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    uint8_t *out = (uint8_t *)surface->pixels;
    for (uint16_t x = 0; x < span->w; x++, out += 2) {
        const uint16_t value = albedo_pixel(tables, t >= GLINT_NEGATIVE_T ? 0 : t, (int32_t)nl, albedo[x], swapped);
        glint_put_pixels(out, &value, 1);
        t += dt;
        dt += span->ddt_q30;
        nl += (uint32_t)span->dnl_q30;
    }
    return GLINT_OK;
}
