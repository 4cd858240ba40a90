/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "paper/search_order.h"
#include "paper/search_rows.h"

double grid_points(const struct search_options *options)
{
    return (double)options->angles * (double)options->shininess.count;
}

double fourth_power(size_t count)
{
    return (double)count * (double)count * (double)count * (double)count;
}

struct search_row *rows_new(size_t count)
{
    return allocate(count ? count : 1, sizeof(struct search_row));
}

void row_set_exponents(const struct search_options *options, const struct candidate *at, struct family *family)
{
    const double *b = options->exponents.values;
    const double chosen[5] = {b[at->b1], b[at->b2], b[at->b3], b[at->b3], b[at->b5]};
    memcpy(family->b, chosen, sizeof chosen);
}

void row_set_coefficients(const struct search_options *options, uint64_t index, struct family *family)
{
    size_t i[4];
    pick_four(index, options->coefficients.count, i);
    const double *a = options->coefficients.values;
    const double chosen[5] = {a[i[0]], a[i[1]], a[i[2]], a[i[2]], a[i[3]]};
    memcpy(family->a, chosen, sizeof chosen);
}
