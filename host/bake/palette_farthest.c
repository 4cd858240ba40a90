/* SPDX-License-Identifier: MIT
 * Farthest points first: the next center is the point that is farthest from all centers so far. The largest distance that
 * remains is at most twice the best there is (Gonzalez 1985). A new center can only be nearer to points within the
 * last largest distance, so only the cells in that reach are updated, and each cell remembers its own farthest point:
 * the next one is the largest of those. */
#include "bake/palette_farthest.h"

#include <stdlib.h>

#include "base/memory.h"

/* The point of a cell that is farthest from its nearest center. */
struct farthest {
    double off; /* -1: the cell is empty */
    uint32_t point;
};

/* The points of one cell, after a center was added. */
static void update_cell(const struct palette_choice *c, uint32_t cell, const struct palette_point *center,
                        uint32_t number, struct farthest *farthest)
{
    *farthest = (struct farthest){-1, 0};
    for (uint32_t i = c->of_points.first[cell]; i < c->of_points.first[cell + 1]; i++) {
        const double off = c->points[i].weight * palette_distance(c->points[i].at, center->at);
        if (off < c->off[i]) {
            c->off[i] = off;
            c->nearest[i] = number;
        }
        if (c->off[i] > farthest->off)
            *farthest = (struct farthest){c->off[i], i};
    }
}

double palette_farthest(struct palette_choice *c, uint32_t given)
{
    const struct palette_grid *grid = &c->of_points;
    const uint32_t cells = (uint32_t)(grid->side * grid->side);
    struct farthest *of_cells = allocate(cells, sizeof *of_cells);
    struct farthest next = {INFINITY, 0};
    for (size_t i = 0; i < c->count; i++) {
        c->off[i] = INFINITY;
        if (c->points[i].at[2] > c->points[next.point].at[2])
            next.point = (uint32_t)i;
    }
    for (uint32_t number = 0; number < c->entries; number++) {
        const struct palette_point *center = &c->centers[number];
        const double reach = (number < given ? INFINITY : next.off) / c->least_weight;
        if (number >= given)
            c->centers[number] = c->points[next.point];
        const struct palette_window near = palette_grid_window(grid, center->at, reach);
        for (int y = near.y0; y <= near.y1; y++)
            for (int x = near.x0; x <= near.x1; x++) {
                const uint32_t cell = (uint32_t)(y * grid->side + x);
                update_cell(c, cell, center, number, &of_cells[cell]);
            }
        next = (struct farthest){-1, 0};
        for (uint32_t cell = 0; cell < cells; cell++)
            if (of_cells[cell].off > next.off)
                next = of_cells[cell];
    }
    free(of_cells);
    return next.off;
}
