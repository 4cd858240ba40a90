/* SPDX-License-Identifier: MIT */
#include "bake/palette_nearest.h"

#include <stdbool.h>
#include <string.h>

/* A counting sort: how many a cell holds, then where each cell starts, then each center to its cell's next place. That
 * leaves each start at the following cell's, so the starts move up by one. */
void palette_sort_centers(const struct palette_choice *c, struct palette_grid *grid, uint32_t *order)
{
    const size_t cells = (size_t)grid->side * (size_t)grid->side;
    memset(grid->first, 0, (cells + 1) * sizeof *grid->first);
    for (uint32_t i = 0; i < c->entries; i++)
        grid->first[palette_grid_cell(grid, c->centers[i].at) + 1]++;
    for (size_t i = 0; i < cells; i++)
        grid->first[i + 1] += grid->first[i];
    for (uint32_t i = 0; i < c->entries; i++)
        order[grid->first[palette_grid_cell(grid, c->centers[i].at)]++] = i;
    memmove(grid->first + 1, grid->first, cells * sizeof *grid->first);
    grid->first[0] = 0;
}

/* The cells in square rings around the point's own. What lies in ring r is at least (r - 1) cells away, so the search
 * ends where that is more than the best distance so far. Of two equally near centers the one with the lower number
 * counts: the order of the search does not matter. */
uint32_t palette_nearest(const struct palette_choice *c, const struct palette_grid *grid, const uint32_t *order,
                         const double at[3], double *off)
{
    const int x0 = palette_column(grid, at[0]), y0 = palette_column(grid, at[1]);
    uint32_t best = 0;
    *off = INFINITY;
    for (int ring = 0; ring < grid->side && (ring - 1) * grid->cell < *off; ring++)
        for (int y = y0 - ring; y <= y0 + ring; y++) {
            if (y < 0 || y >= grid->side)
                continue;
            const bool edge = y == y0 - ring || y == y0 + ring;
            for (int x = x0 - ring; x <= x0 + ring; x += edge || !ring ? 1 : 2 * ring) {
                if (x < 0 || x >= grid->side)
                    continue;
                const uint32_t cell = (uint32_t)(y * grid->side + x);
                for (uint32_t i = grid->first[cell]; i < grid->first[cell + 1]; i++) {
                    const double d = palette_distance(at, c->centers[order[i]].at);
                    if (d < *off || (d == *off && order[i] < best)) {
                        *off = d;
                        best = order[i];
                    }
                }
            }
        }
    return best;
}
