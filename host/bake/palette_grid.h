/* SPDX-License-Identifier: MIT
 * Points on the unit sphere, sorted into the cells of a square grid over x and y, so that what lies near a place is found
 * without looking at all of them. */
#ifndef GLINT_PALETTE_GRID_H
#define GLINT_PALETTE_GRID_H

#include <math.h>
#include <stddef.h>
#include <stdint.h>

struct palette_point {
    double at[3];  /* in units of 2^-15 */
    double weight; /* how much an error matters */
    uint32_t pixels;
};

/* A set of points, in order of the cells that they lie in. */
struct palette_grid {
    int side;
    double cell;     /* its width */
    uint32_t *first; /* side^2 + 1: cell i holds the points first[i] to first[i + 1] - 1 */
};

/* What the steps of choosing a palette work on. */
struct palette_choice {
    struct palette_point *points; /* the different normals, by cell */
    size_t count;
    struct palette_grid of_points;
    double least_weight;
    struct palette_point *centers;
    uint32_t entries;
    uint32_t *nearest; /* of each point, the center */
    double *off;       /* and the weighted distance to it */
};

/* For about so many points: some cells a point. The caller frees `first`. */
struct palette_grid palette_grid_new(uint32_t points);
/* The number of the cell that a place lies in. */
uint32_t palette_grid_cell(const struct palette_grid *grid, const double at[3]);

/* The cells whose points may lie within `reach` of a place: columns x0 to x1 of lines y0 to y1. */
struct palette_window {
    int x0, x1, y0, y1;
};
struct palette_window palette_grid_window(const struct palette_grid *grid, const double at[3], double reach);

static inline double palette_distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* The column or the line that a coordinate lies in; beyond the grid, the nearest one. */
static inline int palette_column(const struct palette_grid *grid, double x)
{
    return (int)fmax(0, fmin(grid->side - 1, floor((x + 32768) / grid->cell)));
}

#endif
