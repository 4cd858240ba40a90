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
    const unsigned shift = run->shift;
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
    const unsigned shift = run->shift;
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
enum run_kind { MIXED, OUTSIDE, INSIDE, UNLIT };

static inline enum run_kind run_kind(const struct glint_run *run, uint32_t m, uint32_t nl_last, uint32_t back_last)
{
    const uint32_t big = (uint32_t)1 << 25, t_max = run->t_max, dt = 0 - run->dback, ddt = 0 - run->ddback;
    if (run->dnl + big > 2 * big || dt + big > 2 * big || ddt >> 21)
        return MIXED;
    if ((int32_t)(run->nl & nl_last) < 0)
        return UNLIT;
    const int32_t first = (int32_t)(t_max - run->back), last = (int32_t)(t_max - back_last);
    if ((int32_t)(run->nl | nl_last) < 0 || (first | last) < 0)
        return MIXED;
    const int32_t step = (int32_t)dt, last_step = step + (int32_t)((m - 1) * ddt);
    int32_t low = first < last ? first : last;
    if (step < 0 && last_step > 0) { /* the lowest t lies between: above the tangents of the ends, to their middle */
        const int32_t half = (int32_t)(m + 1) >> 1, a = first + half * step, b = last - half * last_step;
        low = a < b ? a : b;
    }
    if (low > (int32_t)t_max)
        return OUTSIDE;
    return low >= 0 && first <= (int32_t)t_max && last <= (int32_t)t_max ? INSIDE : MIXED;
}

void glint_colour_span(const struct glint_tables *tables, const struct glint_span *span, uint16_t w, uint16_t *out)
{
    const uint32_t t_max = tables->t_max_q30;
    struct glint_run run = {t_max - span->t_q30,
                            0 - span->dt_q30,
                            0 - span->ddt_q30,
                            (uint32_t)span->nl_q30,
                            (uint32_t)span->dnl_q30,
                            tables->columns,
                            (const uint8_t *)tables->colour.colours,
                            tables->shift,
                            t_max,
                            t_max - GLINT_NEGATIVE_T,
                            tables->dark};
    for (uint32_t left = w; left;) {
        const uint32_t count = left < RUN ? left : RUN, m = count - 1;
        const uint32_t nl_last = run.nl + m * run.dnl;
        const uint32_t back_last = run.back + m * run.dback + (m * (m - 1) >> 1) * run.ddback;
        uint16_t *const end = out + count;
        switch (run_kind(&run, m, nl_last, back_last)) {
        case OUTSIDE:
            glint_run_outside(run.colours, run.nl, run.dnl, out, end);
            break;
        case INSIDE:
            glint_run_inside(&run, out, end);
            break;
        case UNLIT:
            for (uint16_t *at = out; at != end; at++)
                *at = run.dark;
            break;
        default:
            glint_run_mixed(&run, out, end);
        }
        left -= count;
        if (!left)
            return;
        out = end;
        run.nl = nl_last + run.dnl;
        run.dback += m * run.ddback;
        run.back = back_last + run.dback;
        run.dback += run.ddback;
    }
}
