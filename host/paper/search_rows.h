/* SPDX-License-Identifier: MIT
 * Rows of a search's result from the functions' places in the lists. */
#ifndef GLINT_SEARCH_ROWS_H
#define GLINT_SEARCH_ROWS_H

#include "paper/search_grid.h"

double grid_points(const struct search_options *options);
double fourth_power(size_t count);
struct search_row *rows_new(size_t count);
void row_set_exponents(const struct search_options *options, const struct candidate *at, struct family *family);
/* Of the index-th of all ways to pick a1 a2 a3 a5; a4 is a3. */
void row_set_coefficients(const struct search_options *options, uint64_t index, struct family *family);

#endif
