/* SPDX-License-Identifier: MIT
 * What the steps of choosing a palette share. */
#ifndef GLINT_BAKE_PALETTE_H
#define GLINT_BAKE_PALETTE_H

#include <math.h>

#include "bake/bake.h"

struct palette_point {
    double at[3];  /* in units of 2^-15 */
    double weight; /* how much an error matters */
    uint32_t pixels;
};

/* A set of points, in order of the cells that they lie in, over x and y. */
struct palette_grid {
    int side;
    double cell;     /* its width */
    uint32_t *first; /* side^2 + 1 */
};

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

static inline double palette_distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* Of the column or the line that a coordinate lies in; beyond the grid, of the nearest. */
static inline int palette_cell(const struct palette_grid *grid, double x)
{
    return (int)fmax(0, fmin(grid->side - 1, floor((x + 32768) / grid->cell)));
}

/* Balls of about the smallest radius, below `radius`, for which the entries suffice; the centers become their middles.
 * Returns how many: 0 where none is smaller, or where it would take long. */
uint32_t palette_cover(struct palette_choice *choice, double radius);

#endif
