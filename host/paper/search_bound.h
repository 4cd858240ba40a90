/* SPDX-License-Identifier: MIT
 * A lower bound of a function's deviation, found without visiting the whole grid. */
#ifndef GLINT_SEARCH_BOUND_H
#define GLINT_SEARCH_BOUND_H

#include <stdbool.h>
#include <stddef.h>

#include "paper/search_grid.h"

enum { BOUND_BLOCKS = 64 };

/* The grid's shininess in blocks, shared by all threads. */
struct bound_grid {
    const struct grid *grid;
    size_t blocks, edge[BOUND_BLOCKS + 1]; /* block k: places edge[k] .. edge[k+1] - 1 */
    double *low, *high;                    /* of the reference, [angle][block] */
};
void bound_grid_init(struct bound_grid *bounds, const struct grid *grid);
void bound_grid_free(struct bound_grid *bounds);

/* All functions that differ in their scale alone, F = scale G: one a thread. Rows of G are computed when first asked for. */
struct bound {
    const struct bound_grid *bounds;
    struct candidate at; /* with scale 1 */
    size_t rows;         /* of G that are known */
    bool finite;         /* so far */
    double *low, *high;  /* of G, [angle][block] */
};
void bound_init(struct bound *bound, const struct bound_grid *bounds);
void bound_begin(struct bound *bound, const struct candidate *at);
/* May the sum over the grid be within the limit? False only where it is above, or no number. */
bool bound_allows(struct bound *bound, double scale, double limit);
void bound_free(struct bound *bound);

#endif
