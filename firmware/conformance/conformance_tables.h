/* SPDX-License-Identifier: MIT
 * Checks of the tables and their loops. */
#ifndef CONFORMANCE_TABLES_H
#define CONFORMANCE_TABLES_H

#include "conformance.h"

void conform_small(const struct conformance_size *size);
void conform_colours(const struct conformance_size *size);
void conform_dithered(const struct conformance_size *size);
void conform_albedo(const struct conformance_size *size);

#endif
