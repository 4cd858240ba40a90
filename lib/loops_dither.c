/* SPDX-License-Identifier: MIT
 * Lines over COLOUR tables with dither. The loops are those of loops_colour.c but for what they read: past the highlight a
 * finished pixel for nl and the place on the screen, within it the sum of a word for these and one for t. Phases are 2 (x mod 4). */
#include "glint_loops_dither.h"
#include "glint_loops_vector.h"
#include "glint_math_assembly.h"
#include "glint_tables_normals.h"

static inline uint16_t by_vector(const struct glint_dither_look *look, const struct glint_tables_light *light,
                                 struct glint_vec n, uint32_t phase, bool swapped)
{
    return glint_dither_pixel(look, glint_fast_t(&n, &light->h), (uint32_t)glint_fast_nl(&n, &light->l), phase,
                              swapped);
}

/* Any viewer: by a product of vectors each. */
static void vector_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                        const struct glint_vec *normals, uint16_t w, uint16_t *out, uint32_t phase, uint32_t y)
{
    const struct glint_dither_look look = glint_dither_look_up(tables, y);
    const struct glint_tables_light at = *light;
    const bool swapped = glint_is_swapped(tables);
    for (const uint16_t *end = out + w; out < end; normals++, out++, phase = glint_dither_next(phase))
        if (normals->x | normals->y | normals->z)
            *out = by_vector(&look, &at, *normals, phase, swapped);
}

static void aside_line(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       uint16_t w, uint16_t *out, uint32_t phase, uint32_t y)
{
    const struct glint_dither_look look = glint_dither_look_up(tables, y);
    const struct glint_tables_light at = *light;
    const bool swapped = glint_is_swapped(tables);
    for (const uint16_t *end = out + w; out < end; words++, out++, phase = glint_dither_next(phase)) {
        const struct glint_vec n = glint_unpack_int10(*words);
        if (n.z == 0) {
            const uint32_t skip = glint_gap(*words >> 12, (size_t)(end - out));
            words += skip;
            out += skip;
            phase += 2 * skip;
            continue;
        }
        *out = by_vector(&look, &at, n, phase, swapped);
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM
/* The viewer at (0, 0, 1): rows and columns as in loops_colour.c. */
static inline void dithered_int8(const struct glint_tables *tables, const struct glint_tables_light *light,
                                 const uint32_t *words, uint16_t w, uint16_t *out, uint32_t phase, uint32_t y,
                                 bool swapped)
{
    const struct glint_dither_look look = glint_dither_look_up(tables, y);
    const int32_t lx = light->x, ly = light->y, lz = light->z;
    const uint32_t cut = (uint32_t)light->cut, r = light->r;
    const uint32_t nudge = look.nudge >> 1;
    const unsigned a = light->a;
    for (const uint16_t *end = out + w; out < end; words++, out++, phase = glint_dither_next(phase)) {
        const uint32_t word = *words;
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            const uint32_t skip = glint_gap(word, (size_t)(end - out));
            words += skip;
            out += skip;
            phase += 2 * skip;
            continue;
        }
        const int32_t d =
            (int32_t)((uint32_t)((int8_t)word * lx) + (uint32_t)((int16_t)word * ly) + (uint32_t)(z * lz));
        if (d < 0) {
            *out = glint_dither_past(&look, -1, phase);
            continue;
        }
        const int32_t row = (int32_t)(((uint32_t)d + nudge) >> (GLINT_DITHER_ROW_SHIFT - 1));
        const uint32_t e = (uint32_t)d + ((uint32_t)z << 14) - cut;
        *out = (int32_t)e < 0 ? glint_dither_past(&look, row, phase)
                              : glint_dither_within(&look, (uint32_t)row, phase,
                                                    ((e >> a) * r) >> (32 - GLINT_DITHER_COLUMNS_LOG), swapped);
    }
}

void glint_dither_int8_plain(const struct glint_tables *tables, const struct glint_tables_light *light,
                             const uint32_t *words, uint16_t w, uint16_t *out, uint32_t phase, uint32_t y)
{
    dithered_int8(tables, light, words, w, out, phase, y, false);
}

void glint_dither_int8_swapped(const struct glint_tables *tables, const struct glint_tables_light *light,
                               const uint32_t *words, uint16_t w, uint16_t *out, uint32_t phase, uint32_t y)
{
    dithered_int8(tables, light, words, w, out, phase, y, true);
}
#endif

static void int10_line(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       uint16_t w, uint16_t *out, uint32_t phase, uint32_t y)
{
    const struct glint_dither_look look = glint_dither_look_up(tables, y);
    const bool swapped = glint_is_swapped(tables);
    const int32_t hx = (light->h.x + 1) >> 1, hy = (light->h.y + 1) >> 1, hz = (light->h.z + 1) >> 1;
    const uint32_t t_half = look.t_max >> 1, peak = (uint32_t)light->peak, m = peak >> 15, nudge = look.nudge >> 1;
    const unsigned shift = look.shift - 1u;
    for (const uint16_t *end = out + w; out < end; words++, out++, phase = glint_dither_next(phase)) {
        const uint32_t word = *words;
        const int32_t top_z = (int32_t)(word << 20);
        if (top_z == 0) {
            const uint32_t skip = glint_gap(word >> 12, (size_t)(end - out));
            words += skip;
            out += skip;
            phase += 2 * skip;
            continue;
        }
        const uint32_t u = (uint32_t)(((int32_t)word >> 22) * 32 - hx);
        const uint32_t v = (uint32_t)(((int32_t)(word << 10) >> 22) * 32 - hy);
        const uint32_t z = (uint32_t)((top_z >> 17) - hz);
        const uint32_t s = u * u + v * v + z * z;
        const int32_t nl = (int32_t)(peak - m * (s >> 14) - (uint32_t)(top_z >> 2));
        const int32_t row = nl < 0 ? -1 : (int32_t)(((uint32_t)nl + nudge) >> (GLINT_DITHER_ROW_SHIFT - 1));
        *out = s > t_half || row < 0 ? glint_dither_past(&look, row, phase)
                                     : glint_dither_within(&look, (uint32_t)row, phase, (t_half - s) >> shift, swapped);
    }
}

void glint_dither_line(const struct glint_tables *tables, const struct glint_tables_light *light,
                       enum glint_normals format, const void *normals, uint16_t w, uint16_t *out, uint32_t x,
                       uint32_t y)
{
    const uint32_t phase = 2 * (x & 3);
    if (format == GLINT_NORMALS_INT8 && glint_is_swapped(tables))
        glint_dither_int8_swapped(tables, light, (const uint32_t *)normals, w, out, phase, y);
    else if (format == GLINT_NORMALS_INT8)
        glint_dither_int8_plain(tables, light, (const uint32_t *)normals, w, out, phase, y);
    else if (format == GLINT_NORMALS_INT16)
        vector_line(tables, light, (const struct glint_vec *)normals, w, out, phase, y);
    else if (light->frontal)
        int10_line(tables, light, (const uint32_t *)normals, w, out, phase, y);
    else
        aside_line(tables, light, (const uint32_t *)normals, w, out, phase, y);
}
