/* SPDX-License-Identifier: MIT */
#include "bake/palette_grid.h"

#include "base/memory.h"

enum { SIDE_LIMIT = 128 };

struct palette_grid palette_grid_new(uint32_t points)
{
    const int side = (int)fmin(SIDE_LIMIT, ceil(2 * sqrt(points)));
    struct palette_grid grid = {side, 65536. / side, NULL};
    grid.first = allocate((size_t)side * (size_t)side + 1, sizeof *grid.first);
    return grid;
}

uint32_t palette_grid_cell(const struct palette_grid *grid, const double at[3])
{
    return (uint32_t)(palette_column(grid, at[1]) * grid->side + palette_column(grid, at[0]));
}

struct palette_window palette_grid_window(const struct palette_grid *grid, const double at[3], double reach)
{
    return (struct palette_window){palette_column(grid, at[0] - reach), palette_column(grid, at[0] + reach),
                                   palette_column(grid, at[1] - reach), palette_column(grid, at[1] + reach)};
}
