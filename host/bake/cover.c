/* SPDX-License-Identifier: MIT
 * The fewest balls that cover the normals: the radius is a twelfth smaller than by farthest points,
 * the mean distance less than half. */
#include <stdlib.h>

#include "bake/palette.h"
#include "base/memory.h"

enum { WORK_MAX = 1 << 22 }; /* pairs of points in a ball, all together: some seconds */

/* How many open points a ball around `middle` covers: those not farther than `radius` by their weight. Closes them. */
static uint32_t covered(const struct palette_choice *c, uint32_t middle, double radius, bool *open, bool close)
{
    const struct palette_grid *grid = &c->of_points;
    const double *at = c->points[middle].at, reach = radius / c->points[middle].weight;
    const int x0 = palette_cell(grid, at[0] - reach), x1 = palette_cell(grid, at[0] + reach);
    const int y0 = palette_cell(grid, at[1] - reach), y1 = palette_cell(grid, at[1] + reach);
    uint32_t count = 0;
    for (int y = y0; y <= y1; y++) {
        const uint32_t *first = &grid->first[y * grid->side];
        for (uint32_t i = first[x0]; i < first[x1 + 1]; i++)
            if (open[i] && c->points[i].weight * palette_distance(c->points[i].at, at) <= radius) {
                count++;
                open[i] = !close;
            }
    }
    return count;
}

/* Balls of one radius, each where it covers the most that is still open. Gains only fall: a point waits under its last
 * known one, and counts again when its turn comes. Returns false where the entries do not suffice. */
static bool cover(const struct palette_choice *c, double radius, uint32_t *middles, uint32_t *used)
{
    bool *open = allocate(c->count, sizeof *open);
    uint32_t *next = allocate(c->count, sizeof *next);
    uint32_t *waiting = allocate(c->count + 1, sizeof *waiting), left = (uint32_t)c->count;
    for (size_t i = 0; i < c->count; i++)
        open[i] = true;
    for (size_t i = 0; i <= c->count; i++)
        waiting[i] = UINT32_MAX;
    for (size_t i = c->count; i-- > 0;) {
        const uint32_t gain = covered(c, (uint32_t)i, radius, open, false);
        next[i] = waiting[gain];
        waiting[gain] = (uint32_t)i;
    }
    *used = 0;
    for (size_t gain = c->count; gain > 0 && left && *used < c->entries; gain--)
        while (waiting[gain] != UINT32_MAX && left && *used < c->entries) {
            const uint32_t point = waiting[gain];
            waiting[gain] = next[point];
            const uint32_t now = covered(c, point, radius, open, false);
            if (now == gain) {
                left -= covered(c, point, radius, open, true);
                middles[(*used)++] = point;
            } else {
                next[point] = waiting[now];
                waiting[now] = point;
            }
        }
    free(open);
    free(next);
    free(waiting);
    return left == 0;
}

uint32_t palette_cover(struct palette_choice *c, double radius)
{
    if ((double)c->count * (double)c->count > (double)WORK_MAX * c->entries)
        return 0;
    uint32_t *middles = allocate(c->entries, sizeof *middles), used, best = 0;
    double low = radius / 2, high = radius;
    for (int step = 0; step < 6; step++) {
        const double middle = (low + high) / 2;
        if (!cover(c, middle, middles, &used)) {
            low = middle;
            continue;
        }
        high = middle;
        best = used;
        for (uint32_t i = 0; i < used; i++)
            c->centers[i] = c->points[middles[i]];
    }
    free(middles);
    return best;
}
