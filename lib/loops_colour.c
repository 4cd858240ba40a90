/* SPDX-License-Identifier: MIT
 * The loops over COLOUR tables, a line each: nl leads to a row of colours, t to a column, which holds the colour's place in
 * the row as an offset in bytes; no pixel multiplies by more than a vector. RAM: 20,480 bytes of tables, what a light
 * takes, no buffers. */
#include "glint_loops_colour.h"
#include "glint_loops_look.h"
#include "glint_loops_vector.h"
#include "glint_math_assembly.h"
#include "glint_tables_geometry.h"
#include "glint_tables_normals.h"

/* t: a vector's, never below 0. */
static inline uint16_t colour(const struct glint_look *look, uint32_t t, int32_t nl)
{
    if (nl < 0)
        return look->dark;
    uint32_t at = glint_look_row((uint32_t)nl);
    if (t <= look->t_max)
        at += look->columns[(look->t_max - t) >> look->shift];
    return glint_look_colour(look, at);
}

/* Any viewer, any normals: t and nl by a product of vectors each. */
void glint_colour_vec(const struct glint_tables *tables, const struct glint_tables_light *light,
                      const struct glint_vec *normals, uint16_t w, uint16_t *out)
{
    const struct glint_look look = glint_look_up(tables);
    const struct glint_vec l = light->l, h = light->h;
    for (uint16_t i = 0; i < w; i++)
        if (normals[i].x | normals[i].y | normals[i].z)
            out[i] = colour(&look, glint_fast_t(&normals[i], &h), glint_fast_nl(&normals[i], &l));
}

/* 10 bits, for any viewer: unpacked, then as above. */
void glint_colour_int10_aside(const struct glint_tables *tables, const struct glint_tables_light *light,
                              const uint32_t *words, uint16_t w, uint16_t *out)
{
    const struct glint_look look = glint_look_up(tables);
    const struct glint_vec l = light->l, h = light->h;
    for (const uint16_t *end = out + w; out < end; words++, out++) {
        const struct glint_vec n = glint_unpack_int10(*words);
        if (n.z == 0) {
            const uint32_t skip = glint_gap(*words >> 12, (size_t)(end - out));
            words += skip;
            out += skip;
            continue;
        }
        *out = colour(&look, glint_fast_t(&n, &h), glint_fast_nl(&n, &l));
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM
/* 8 bits, the viewer at (0, 0, 1). H lies between L and the viewer, so N.H |L + V| = N.L + z: one product d (Q29) gives the
 * row, and with z the place e (Q29) from the last column on, to which r brings a column's number. Three multiplications
 * for the vectors, and one inside the highlight. */
void glint_colour_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       uint16_t w, uint16_t *out)
{
    const struct glint_look look = glint_look_up(tables);
    const int32_t lx = light->x, ly = light->y, lz = light->z;
    const uint32_t cut = (uint32_t)light->cut, r = light->r;
    const unsigned a = light->a;
    for (const uint16_t *end = out + w; out < end; words++, out++) {
        const uint32_t word = *words;
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            const uint32_t skip = glint_gap(word, (size_t)(end - out));
            words += skip;
            out += skip;
            continue;
        }
        const int32_t d =
            (int32_t)((uint32_t)((int8_t)word * lx) + (uint32_t)((int16_t)word * ly) + (uint32_t)(z * lz));
        if (d < 0) {
            *out = look.dark;
            continue;
        }
        uint32_t at = (uint32_t)d >> (GLINT_COLOUR_ROW_SHIFT - 1) << GLINT_COLOUR_ROW_BYTES_LOG;
        const uint32_t e = (uint32_t)d + ((uint32_t)z << 14) - cut;
        if ((int32_t)e >= 0)
            at += look.columns[((e >> a) * r) >> (32 - GLINT_COLOUR_COLUMNS_LOG)];
        *out = glint_look_colour(&look, at);
    }
}

/* 10 bits, the viewer at (0, 0, 1). As above, but backwards: s = |N - H|^2 / 2 in Q29, which keeps its precision near the
 * peak, gives the column, and nl = |L + V| (1 - s) - z (Q29) the row. */
void glint_colour_int10(const struct glint_tables *tables, const struct glint_tables_light *light,
                        const uint32_t *words, uint16_t w, uint16_t *out)
{
    const struct glint_look look = glint_look_up(tables);
    const int32_t hx = (light->h.x + 1) >> 1, hy = (light->h.y + 1) >> 1, hz = (light->h.z + 1) >> 1;
    const uint32_t t_half = look.t_max >> 1, peak = (uint32_t)light->peak, m = peak >> 15;
    const unsigned shift = look.shift - 1u;
    for (const uint16_t *end = out + w; out < end; words++, out++) {
        const uint32_t word = *words;
        const int32_t top_z = (int32_t)(word << 20);
        if (top_z == 0) {
            const uint32_t skip = glint_gap(word >> 12, (size_t)(end - out));
            words += skip;
            out += skip;
            continue;
        }
        const uint32_t x = (uint32_t)(((int32_t)word >> 22) * 32 - hx);
        const uint32_t y = (uint32_t)(((int32_t)(word << 10) >> 22) * 32 - hy);
        const uint32_t z = (uint32_t)((top_z >> 17) - hz);
        const uint32_t s = x * x + y * y + z * z;
        const uint32_t nl = peak - m * (s >> 14) - (uint32_t)(top_z >> 2);
        if ((int32_t)nl < 0) {
            *out = look.dark;
            continue;
        }
        uint32_t at = nl >> (GLINT_COLOUR_ROW_SHIFT - 1) << GLINT_COLOUR_ROW_BYTES_LOG;
        if (s <= t_half)
            at += look.columns[(t_half - s) >> shift];
        *out = glint_look_colour(&look, at);
    }
}
#endif
