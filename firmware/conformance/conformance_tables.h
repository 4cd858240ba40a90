/* SPDX-License-Identifier: MIT
 * Checks of tables, and of what they draw. */
#ifndef CONFORMANCE_TABLES_H
#define CONFORMANCE_TABLES_H

#include "conformance.h"

/* Into the hash, too: err and, of what was filled, every byte. Whether there is a paint; the next one takes its memory. Where tables are left
 * out there is none. */
bool conform_fill(struct glint_paint *paint, enum glint_tables_kind kind, const struct glint_material *material,
                  const struct glint_output *output);

/* What a light makes of them. */
void conform_tables_lit(void);
void conform_colours(const struct conformance_size *size);
void conform_dithered(const struct conformance_size *size);
void conform_albedo(const struct conformance_size *size);

#endif
