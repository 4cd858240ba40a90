/* SPDX-License-Identifier: MIT
 * The pixels of a run by COLOUR tables: a loop for each of what they can have in common (loops_span.c). */
#include "glint_tables.h"

#if !GLINT_CORTEX_M0PLUS_ASM
static inline uint16_t colour_at(const uint8_t *at)
{
    return *(const uint16_t *)(const void *)at;
}

static inline uint32_t row(uint32_t nl) /* in bytes, as the columns are */
{
    return nl >> 24 << 7;
}

void glint_run_dark(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out, const uint16_t *end)
{
    (void)at;
    const uint16_t pixel = tables->dark;
    while (out != end)
        *out++ = pixel;
}

/* Unrolled by hand, as compilers do not at -O2. */
void glint_run_outside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                       const uint16_t *end)
{
    const uint8_t *const colours = (const uint8_t *)tables->colour.colours;
    const uint32_t dnl = (uint32_t)at->dnl_q30;
    uint32_t nl = (uint32_t)at->nl_q30;
    for (; end - out >= 4; out += 4) {
        out[0] = colour_at(colours + row(nl));
        nl += dnl;
        out[1] = colour_at(colours + row(nl));
        nl += dnl;
        out[2] = colour_at(colours + row(nl));
        nl += dnl;
        out[3] = colour_at(colours + row(nl));
        nl += dnl;
    }
    for (; out != end; out++) {
        *out = colour_at(colours + row(nl));
        nl += dnl;
    }
}

/* back = t_max - t, so that a column is back >> shift; here scaled, so that the shift is a constant. */
void glint_run_inside(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out,
                      const uint16_t *end)
{
    const uint8_t *const columns = tables->columns, *const colours = (const uint8_t *)tables->colour.colours;
    const unsigned scale = 20u - tables->shift; /* back >> shift < 2^12 */
    uint32_t back = (tables->t_max_q30 - at->t_q30) << scale, dback = (0 - at->dt_q30) << scale;
    uint32_t nl = (uint32_t)at->nl_q30;
    const uint32_t ddback = (0 - at->ddt_q30) << scale, dnl = (uint32_t)at->dnl_q30;
    for (; out != end; out++) {
        *out = colour_at(colours + row(nl) + columns[back >> 20]);
        back += dback;
        dback += ddback;
        nl += dnl;
    }
}

void glint_run_mixed(const struct glint_tables *tables, const struct glint_span *at, uint16_t *out, const uint16_t *end)
{
    const uint8_t *const columns = tables->columns, *const colours = (const uint8_t *)tables->colour.colours;
    const unsigned shift = tables->shift;
    const uint32_t t_max = tables->t_max_q30, limit = t_max - GLINT_NEGATIVE_T;
    uint32_t back = t_max - at->t_q30, dt = at->dt_q30, nl = (uint32_t)at->nl_q30;
    const uint32_t ddt = at->ddt_q30, dnl = (uint32_t)at->dnl_q30;
    for (; out != end; out++) {
        if ((int32_t)nl < 0) {
            *out = tables->dark;
        } else {
            uint32_t at_byte = row(nl);
            if (back <= limit)
                at_byte += columns[(back <= t_max ? back : t_max) >> shift];
            *out = colour_at(colours + at_byte);
        }
        back -= dt;
        dt += ddt;
        nl += dnl;
    }
}
#endif
