/* SPDX-License-Identifier: MIT
 * Internal. The axes of the tables: t, F and nl, and what value each interval stands for. */
#ifndef GLINT_TABLES_COLUMNS_H
#define GLINT_TABLES_COLUMNS_H

#include "glint.h"

/* Columns over t = 0..t_max, the one of t_max first: a power of two of t each, some to spare at the peak. The least shift
 * for which so many columns hold them, and the middle of column i. */
unsigned glint_columns_shift(uint32_t t_max_q30, uint32_t columns);
static inline uint32_t glint_column_t(uint32_t t_max_q30, unsigned shift, uint32_t i)
{
    const uint64_t back = ((uint64_t)i << shift) + ((uint32_t)1 << shift >> 1);
    return back < t_max_q30 ? t_max_q30 - (uint32_t)back : 0;
}

/* The largest t, up to the cutoff, whose F shows: F falls as t grows, so what shows no more does not come back. */
uint32_t glint_last_t(const struct glint_shader *shader, bool (*shows)(const struct glint_shader *shader, uint32_t f));

/* F in GLINT_COLOUR_STEPS steps, 0..63, of which the last is the peak's, f0 = F(0): the nearest step, and its F. */
struct glint_peak {
    const struct glint_shader *shader;
    uint32_t f0; /* 1.0 at least for n and q of the domain, so never 0; below 2^17 */
};
uint8_t glint_peak_step(const struct glint_peak *peak, uint32_t f);
uint32_t glint_peak_f(const struct glint_peak *peak, uint32_t step);
uint8_t glint_peak_step_at(const struct glint_peak *peak, uint32_t t_q30);

/* A row of GLINT_COLOUR_ROWS: the middle of its nl, Q16; beyond 1 it is 1. */
uint32_t glint_row_nl(uint32_t row);

#endif
