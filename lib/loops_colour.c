/* SPDX-License-Identifier: MIT
 * The loops over COLOUR tables, a line each. RAM: 20,480 bytes of tables, what a light takes, no buffers. */
#include "tables.h"

/* Table and limits in registers. */
struct look {
    const uint8_t *columns;
    const uint8_t *colours;
    uint32_t t_max;
    unsigned shift;
    uint16_t dark;
};

static inline struct look look_up(const struct glint_tables *tables)
{
    const struct look look = {tables->columns, (const uint8_t *)tables->colour.colours, tables->t_max_q30,
                              tables->shift, tables->dark};
    return look;
}

static inline uint16_t colour(const struct look *look, uint32_t t, int32_t nl)
{
    if (nl < 0)
        return look->dark;
    uint32_t at = (uint32_t)nl >> 24 << 7; /* bytes, as in the columns */
    if (t <= look->t_max)
        at += look->columns[(look->t_max - t) >> look->shift];
    return *(const uint16_t *)(const void *)(look->colours + at);
}

void glint_colour_vec(const struct glint_tables *tables, const struct glint_tables_light *light,
                      const struct glint_vec *normals, uint16_t w, uint16_t *out)
{
    const struct look look = look_up(tables);
    const struct glint_vec l = light->l, h = light->h;
    for (uint16_t i = 0; i < w; i++)
        if (normals[i].x | normals[i].y | normals[i].z)
            out[i] = colour(&look, glint_fast_t(&normals[i], &h), glint_fast_nl(&normals[i], &l));
}

void glint_colour_int10(const struct glint_tables *tables, const struct glint_tables_light *light,
                        const uint32_t *words, uint16_t w, uint16_t *out)
{
    const struct look look = look_up(tables);
    const struct glint_vec l = light->l, h = light->h;
    for (const uint32_t *end = words + w; words != end; words++, out++) {
        if (!*words)
            continue;
        const struct glint_vec n = glint_normals_unpack(GLINT_NORMALS_INT10, *words);
        *out = colour(&look, glint_fast_t(&n, &h), glint_fast_nl(&n, &l));
    }
}

#if !GLINT_CORTEX_M0PLUS_ASM
void glint_colour_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       uint16_t w, uint16_t *out)
{
    const uint8_t *const columns = tables->columns;
    const uint8_t *const colours = (const uint8_t *)tables->colour.colours;
    const int32_t lx = light->x, ly = light->y, lz = light->z;
    const uint32_t cut = (uint32_t)light->cut, r = light->r;
    const unsigned a = light->a;
    const uint16_t dark = tables->dark;
    for (const uint16_t *end = out + w; out < end; words++, out++) {
        const uint32_t word = *words;
        const int32_t z = (int32_t)word >> 16;
        if (z == 0) {
            const uint32_t left = (uint32_t)(end - out), gap = word ? word : 1, skip = (gap < left ? gap : left) - 1;
            words += skip;
            out += skip;
            continue;
        }
        const int32_t d =
            (int32_t)((uint32_t)((int8_t)word * lx) + (uint32_t)((int16_t)word * ly) + (uint32_t)(z * lz));
        if (d < 0) {
            *out = dark;
            continue;
        }
        uint32_t at = (uint32_t)d >> 23 << 7; /* bytes */
        const uint32_t e = (uint32_t)d + ((uint32_t)z << 14) - cut;
        if ((int32_t)e >= 0)
            at += columns[((e >> a) * r) >> 20];
        *out = *(const uint16_t *)(const void *)(colours + at);
    }
}
#endif

void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint16_t w, uint16_t *out)
{
    const struct look look = look_up(tables);
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    const uint32_t ddt = span->ddt_q30, dnl = (uint32_t)span->dnl_q30;
    for (const uint16_t *end = out + w; out != end; out++) {
        *out = colour(&look, t >= GLINT_NEGATIVE_T ? 0 : t, (int32_t)nl);
        t += dt;
        dt += ddt;
        nl += dnl;
    }
}
