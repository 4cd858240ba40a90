/* SPDX-License-Identifier: MIT
 * For a fixed angle the function is monotone in n wherever its denominator keeps its sign, and so is c^n. So between two
 * edges of a block both lie between their values at the edges, and where these ranges do not meet, each of the block's
 * points is off by at least the gap. Some thirty edges a row then stand for a thousand points, and the first few rows
 * are enough to see that most functions come nowhere near the best. */
#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "paper/search_bound.h"

/* What rounding may add to a bound: each gap is right within a few parts in 2^52. */
#define SLACK (1 - 1e-9)

/* Each block a third as long as what lies before it: narrow at small n, where c^n falls fastest. The last place is a block
 * by itself. 20 million places, the most a grid may have, make 60 blocks. */
static void place_edges(struct bound_grid *bounds, size_t count)
{
    for (size_t at = 0; at + 1 < count; at += 1 + at / 3)
        bounds->edge[bounds->blocks++] = at;
    bounds->edge[bounds->blocks++] = count - 1;
    bounds->edge[bounds->blocks] = count;
}

static bool increasing(const double *values, size_t count)
{
    for (size_t i = 1; i < count; i++)
        if (!(values[i] > values[i - 1]))
            return false;
    return true;
}

/* The place whose value ends the block: the next one's first, of the last block its own. */
static size_t end_of(const struct bound_grid *bounds, size_t block)
{
    return block + 1 < bounds->blocks ? bounds->edge[block + 1] : bounds->edge[block];
}

void bound_grid_init(struct bound_grid *bounds, const struct grid *grid)
{
    *bounds = (struct bound_grid){.grid = grid};
    /* A list of n in another order has no monotone blocks: then there is no bound, and every sum is formed. */
    if (!increasing(grid->shininess_values, grid->shininess))
        return;
    place_edges(bounds, grid->shininess);
    bounds->low = allocate(grid->angles * bounds->blocks, sizeof(double));
    bounds->high = allocate(grid->angles * bounds->blocks, sizeof(double));
    for (size_t i = 0; i < grid->angles; i++)
        for (size_t k = 0; k < bounds->blocks; k++) {
            const double *reference = grid->reference + i * grid->shininess;
            bounds->high[i * bounds->blocks + k] = reference[bounds->edge[k]];
            bounds->low[i * bounds->blocks + k] = reference[end_of(bounds, k)];
        }
}

void bound_grid_free(struct bound_grid *bounds)
{
    free(bounds->low);
    free(bounds->high);
}

void bound_init(struct bound *bound, const struct bound_grid *bounds)
{
    *bound = (struct bound){.bounds = bounds};
    bound->low = allocate(bounds->grid->angles * bounds->blocks, sizeof(double));
    bound->high = allocate(bounds->grid->angles * bounds->blocks, sizeof(double));
}

void bound_free(struct bound *bound)
{
    free(bound->low);
    free(bound->high);
}

void bound_begin(struct bound *bound, const struct candidate *at)
{
    bound->at = *at;
    bound->at.scale = 1;
    bound->rows = 0;
    bound->finite = true;
}

/* G at the edges of one angle, and from them its range in each block. */
static void next_row(struct bound *bound)
{
    const struct bound_grid *bounds = bound->bounds;
    const size_t blocks = bounds->blocks;
    double *low = bound->low + bound->rows * blocks, *high = bound->high + bound->rows * blocks;
    double value[BOUND_BLOCKS], denominator[BOUND_BLOCKS];
    candidate_places(bounds->grid, &bound->at, bound->rows, bounds->edge, blocks, value, denominator);
    for (size_t k = 0; k < blocks; k++) {
        const size_t next = k + 1 < blocks ? k + 1 : k;
        bound->finite &= isfinite(value[k]) != 0;
        const bool monotone = denominator[k] * denominator[next] > 0;
        low[k] = monotone ? fmin(value[k], value[next]) : -INFINITY;
        high[k] = monotone ? fmax(value[k], value[next]) : INFINITY;
    }
    bound->rows++;
}

bool bound_allows(struct bound *bound, double scale, double limit)
{
    const struct bound_grid *bounds = bound->bounds;
    const size_t blocks = bounds->blocks;
    double sum = 0;
    for (size_t i = 0; blocks && i < bounds->grid->angles; i++) {
        if (i == bound->rows)
            next_row(bound);
        if (!bound->finite)
            return false;
        const double *low = bound->low + i * blocks, *high = bound->high + i * blocks;
        const double *reference_low = bounds->low + i * blocks, *reference_high = bounds->high + i * blocks;
        for (size_t k = 0; k < blocks; k++) {
            const double above = scale * low[k] - reference_high[k], below = reference_low[k] - scale * high[k];
            const double gap = above > below ? above : below;
            sum += gap > 0 ? gap * (double)(bounds->edge[k + 1] - bounds->edge[k]) : 0;
        }
        if (sum * SLACK > limit)
            return false;
    }
    return true;
}
