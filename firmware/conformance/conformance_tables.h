/* SPDX-License-Identifier: MIT
 * Checks of the tables and their loops. */
#ifndef CONFORMANCE_TABLES_H
#define CONFORMANCE_TABLES_H

#include "conformance.h"

/* Into the hash, too: err and, of what was filled, every byte. Whether there are tables; the next ones take their memory. */
bool conform_fill(struct glint_tables *tables, enum glint_tables_kind kind, const struct glint_shader *shader);

/* The memory that tables take, aligned as a pointer: for what needs none of them. */
void *conform_memory(size_t *bytes);

void conform_small(const struct conformance_size *size);
void conform_colours(const struct conformance_size *size);
void conform_dithered(const struct conformance_size *size);
void conform_albedo(const struct conformance_size *size);

#endif
