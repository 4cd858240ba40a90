/* SPDX-License-Identifier: MIT
 * A lobe as a table for a program of one's own: its entries, their errors, and C source with look-ups. */
#ifndef GLINT_BAKE_LOBE_TABLE_H
#define GLINT_BAKE_LOBE_TABLE_H

#include <stdbool.h>
#include <stdio.h>

#include "glint.h"

/* Entry i is the lobe at the distance x = i 2^shift from the peak: x = 65536 - c_q16, or x = t_q30. */
struct lobe_table {
    struct glint_lobe lobe;
    bool of_t, clamp_peak;
    unsigned bits, shift;
    uint32_t count, one; /* `one` stands for 1.0 */
    uint32_t *entries;   /* they never rise, and the last is 0: it lies beyond the cutoff */
};
/* `lobe`, `of_t`, `clamp_peak`, `bits` and `count` are set. */
void lobe_table_fill(struct lobe_table *table);

/* All in one file to include: a static array, and its look-ups. */
void lobe_table_write_c(const struct lobe_table *table, const char *name, FILE *out);
/* A header with the look-ups and a source to link; `header` is the header's file name. */
void lobe_table_write_header(const struct lobe_table *table, const char *name, FILE *out);
void lobe_table_write_definition(const struct lobe_table *table, const char *name, const char *header, FILE *out);
/* The entries alone, low bytes first. */
void lobe_table_write_raw(const struct lobe_table *table, FILE *out);

#endif
