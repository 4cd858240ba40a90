/* SPDX-License-Identifier: MIT
 * The loops over COLOUR tables, a line each. RAM: 20,480 bytes of tables, what a light takes, no buffers. */
#include "tables.h"

#if GLINT_CORTEX_M0PLUS_ASM /* what cortex_m0plus.S takes for granted; an array of -1 where it is not so */
#define AT(type, field, offset) (offsetof(struct type, field) == (offset))
typedef char glint_layout[AT(glint_tables, columns, 0) && AT(glint_tables, colour, 4) && AT(glint_tables, dark, 12) &&
                                  AT(glint_tables_light, x, 12) && AT(glint_tables_light, y, 16) &&
                                  AT(glint_tables_light, z, 20) && AT(glint_tables_light, cut, 24) &&
                                  AT(glint_tables_light, r, 28) && AT(glint_tables_light, a, 32) &&
                                  AT(glint_run, back, 0) && AT(glint_run, dback, 4) && AT(glint_run, ddback, 8) &&
                                  AT(glint_run, nl, 12) && AT(glint_run, dnl, 16) && AT(glint_run, columns, 20) &&
                                  AT(glint_run, colours, 24) && AT(glint_run, shift, 28) && AT(glint_run, t_max, 32) &&
                                  AT(glint_run, limit, 36) && AT(glint_run, dark, 40)
                              ? 1
                              : -1];
#endif

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

static inline uint16_t colour_at(const uint8_t *at)
{
    return *(const uint16_t *)(const void *)at;
}

static inline uint16_t colour(const struct look *look, uint32_t t, int32_t nl)
{
    if (nl < 0)
        return look->dark;
    uint32_t at = (uint32_t)nl >> 24 << 7; /* bytes, as in the columns */
    if (t <= look->t_max)
        at += look->columns[(look->t_max - t) >> look->shift];
    return colour_at(look->colours + at);
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
        const struct glint_vec n = glint_unpack_int10(*words);
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
        *out = colour_at(colours + at);
    }
}
#endif

/* ---- Spans ---- */

#if !GLINT_CORTEX_M0PLUS_ASM
void glint_run_outside(const uint8_t *colours, uint32_t nl, uint32_t dnl, uint16_t *out, const uint16_t *end)
{
    for (; end - out >= 2; out += 2) {
        out[0] = colour_at(colours + (nl >> 24 << 7));
        nl += dnl;
        out[1] = colour_at(colours + (nl >> 24 << 7));
        nl += dnl;
    }
    if (out != end)
        *out = colour_at(colours + (nl >> 24 << 7));
}

void glint_run_inside(const struct glint_run *run, uint16_t *out, const uint16_t *end)
{
    const uint8_t *const columns = run->columns, *const colours = run->colours;
    const uint32_t shift = run->shift;
    uint32_t back = run->back, dback = run->dback, nl = run->nl;
    const uint32_t ddback = run->ddback, dnl = run->dnl;
    for (; out != end; out++) {
        *out = colour_at(colours + (nl >> 24 << 7) + columns[back >> shift]);
        back += dback;
        dback += ddback;
        nl += dnl;
    }
}

void glint_run_mixed(const struct glint_run *run, uint16_t *out, const uint16_t *end)
{
    const uint8_t *const columns = run->columns, *const colours = run->colours;
    const uint32_t shift = run->shift;
    uint32_t back = run->back, dback = run->dback, nl = run->nl;
    const uint32_t ddback = run->ddback, dnl = run->dnl, t_max = run->t_max, limit = run->limit;
    const uint16_t dark = run->dark;
    for (; out != end; out++) {
        if ((int32_t)nl < 0) {
            *out = dark;
        } else {
            uint32_t at = nl >> 24 << 7;
            if (back <= limit)
                at += columns[(back <= t_max ? back : t_max) >> shift];
            *out = colour_at(colours + at);
        }
        back += dback;
        dback += ddback;
        nl += dnl;
    }
}
#endif

/* Of up to RUN pixels it is cheap to know that all are alike: t is convex and nl linear. Modulo 2^32 they are that only
 * where no sum wraps: with steps below 2^25 and ddt below 2^21, 31 steps change nl and t by less than 2^31. */
enum { RUN = 32 };
#define BIG ((uint32_t)1 << 25)

static inline void unlit(uint16_t dark, uint16_t *out, const uint16_t *end)
{
    while (out != end)
        *out++ = dark;
}

/* The lowest t of a run, or less: where it lies between the ends, above their tangents up to the middle. */
static inline int32_t lowest(int32_t first, int32_t last, int32_t step, int32_t last_step, int32_t m)
{
    if (step >= 0)
        return first;
    if (last_step <= 0)
        return last;
    const int32_t half = (m + 1) >> 1, a = first + half * step, b = last - half * last_step;
    return a < b ? a : b;
}

void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint16_t w, uint16_t *out)
{
    const int32_t t_max = (int32_t)tables->t_max_q30;
    const uint8_t *const colours = (const uint8_t *)tables->colour.colours;
    uint32_t t = span->t_q30, dt = span->dt_q30, nl = (uint32_t)span->nl_q30;
    const uint32_t ddt = span->ddt_q30, dnl = (uint32_t)span->dnl_q30;
    for (uint32_t left = w; left;) {
        const uint32_t count = left < RUN ? left : RUN, m = count - 1;
        const uint32_t last_nl = nl + m * dnl, last_dt = dt + m * ddt, last_t = t + m * dt + (m * (m - 1) >> 1) * ddt;
        uint16_t *const end = out + count;
        bool mixed = (dnl + BIG) >> 26 || (dt + BIG) >> 26 || ddt >> 21 || (int32_t)(nl ^ last_nl) < 0;
        if (!mixed && (int32_t)nl < 0) {
            unlit(tables->dark, out, end);
        } else {
            int32_t low = -1;
            if (!mixed && (int32_t)(t | last_t) >= 0)
                low = lowest((int32_t)t, (int32_t)last_t, (int32_t)dt, (int32_t)last_dt, (int32_t)m);
            if (low > t_max) {
                glint_run_outside(colours, nl, dnl, out, end);
            } else {
                const struct glint_run run = {(uint32_t)t_max - t,
                                              0 - dt,
                                              0 - ddt,
                                              nl,
                                              dnl,
                                              tables->columns,
                                              colours,
                                              tables->shift,
                                              (uint32_t)t_max,
                                              (uint32_t)t_max - GLINT_NEGATIVE_T,
                                              tables->dark};
                if (low >= 0 && (int32_t)t <= t_max && (int32_t)last_t <= t_max)
                    glint_run_inside(&run, out, end);
                else
                    glint_run_mixed(&run, out, end);
            }
        }
        left -= count;
        out = end;
        nl = last_nl + dnl;
        t = last_t + last_dt;
        dt = last_dt + ddt;
    }
}
