/* SPDX-License-Identifier: MIT
 * Internal. */
#ifndef GLINT_TABLES_SMALL_H
#define GLINT_TABLES_SMALL_H

#include "glint_tables_columns.h"

/* Fills SMALL tables (sequence.md). */
void glint_small_fill(struct glint_tables *tables, const struct glint_peak *peak, void *memory);

#endif
