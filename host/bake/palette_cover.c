/* SPDX-License-Identifier: MIT
 * The fewest balls that cover the normals, by greedy set cover at each of several radii: the smallest radius for which the
 * entries suffice is about a twelfth smaller than by farthest points, and the mean distance less than half. It is left out
 * where it would take long: the work grows with the square of the number of points. */
#include "bake/palette_cover.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/memory.h"

enum { WORK_MAX = 1 << 22 }; /* pairs of points in a ball, all together: some seconds */

/* How many open points a ball around `middle` covers: those not farther than `radius` by their weight. Closes them. */
static uint32_t covered(const struct palette_choice *c, uint32_t middle, double radius, bool *open, bool close)
{
    const struct palette_grid *grid = &c->of_points;
    const double *at = c->points[middle].at, reach = radius / c->points[middle].weight;
    const struct palette_window near = palette_grid_window(grid, at, reach);
    uint32_t count = 0;
    for (int y = near.y0; y <= near.y1; y++) {
        const uint32_t *first = &grid->first[(size_t)y * (size_t)grid->side];
        for (uint32_t i = first[near.x0]; i < first[near.x1 + 1]; i++)
            if (open[i] && c->points[i].weight * palette_distance(c->points[i].at, at) <= radius) {
                count++;
                open[i] = !close;
            }
    }
    return count;
}

/* Greedily: balls of one radius, each where it covers the most points that are still open. What a ball would cover, its
 * gain, only falls. So each point waits in a list for its last known gain, and the lists are taken from the largest gain
 * down: a point whose gain has fallen meanwhile moves to a later list, one whose gain still holds is the best there is.
 * Returns false where the entries do not suffice. */
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

/* The smallest radius, by six steps of bisection. Without weights no choice is below half of what farthest points left. */
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
