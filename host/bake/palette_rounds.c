/* SPDX-License-Identifier: MIT
 * Rounds, as in Lloyd's algorithm: each point goes to its nearest center, then each center moves among its own points. In
 * the first rounds it moves to the middle of the smallest ball around them, which makes the largest error smaller; in the
 * later ones towards their mean, as far as the largest error allows, which makes the mean error smaller. Points and
 * centers are handled in order, so the same normals always give the same palette. */
#include "bake/palette_rounds.h"

#include <stdlib.h>
#include <string.h>

#include "bake/palette_nearest.h"
#include "base/memory.h"
#include "base/stop.h"

enum { ROUNDS = 4, BALL_STEPS = 60 };

/* The largest weighted distance of some points from a place, and whose it is. */
static double farthest_member(const struct palette_choice *c, const uint32_t *members, uint32_t count,
                              const double at[3], uint32_t *point)
{
    double farthest = -1;
    for (uint32_t i = 0; i < count; i++) {
        const struct palette_point *member = &c->points[members[i]];
        const double off = member->weight * palette_distance(member->at, at);
        if (off > farthest) {
            farthest = off;
            *point = members[i];
        }
    }
    return farthest;
}

/* Towards the middle of the smallest ball around the points, by ever smaller steps to the farthest one (Badoiu and
 * Clarkson 2003). The best place of all steps is kept, and the start is one of them: no round makes the largest distance
 * larger. */
static void move_to_middle(const struct palette_choice *c, const uint32_t *members, uint32_t count, double at[3])
{
    uint32_t point = 0;
    double middle[3] = {at[0], at[1], at[2]}, least = farthest_member(c, members, count, at, &point);
    for (int step = 1; step <= BALL_STEPS && count; step++) {
        for (int k = 0; k < 3; k++)
            middle[k] += (c->points[point].at[k] - middle[k]) / (step + 1);
        const double off = farthest_member(c, members, count, middle, &point);
        if (off < least) {
            least = off;
            memcpy(at, middle, sizeof middle);
        }
    }
}

/* To the mean over the pixels, or as far towards it as leaves none of the points farther than `limit`. */
static void move_to_mean(const struct palette_choice *c, const uint32_t *members, uint32_t count, double limit,
                         double at[3])
{
    double mean[3] = {0, 0, 0}, pixels = 0;
    for (uint32_t i = 0; i < count; i++) {
        const struct palette_point *member = &c->points[members[i]];
        for (int k = 0; k < 3; k++)
            mean[k] += member->pixels * member->at[k];
        pixels += member->pixels;
    }
    for (double part = 1; count && part > .1; part /= 2) {
        double place[3];
        uint32_t point;
        for (int k = 0; k < 3; k++)
            place[k] = at[k] + part * (mean[k] / pixels - at[k]);
        if (farthest_member(c, members, count, place, &point) <= limit) {
            memcpy(at, place, sizeof place);
            return;
        }
    }
}

/* Each point to its nearest center; returns the largest weighted distance. */
static double assign(struct palette_choice *c, struct palette_grid *grid, uint32_t *order)
{
    sigset_t before;
    palette_sort_centers(c, grid, order);
    signals_hold_but_faults(&before); /* the first thread alone takes them, at once: of a large map this takes long */
#pragma omp parallel
    {
#pragma omp master
        signals_release(&before);
#pragma omp for schedule(static)
        for (size_t i = 0; i < c->count; i++) {
            double off;
            c->nearest[i] = palette_nearest(c, grid, order, c->points[i].at, &off);
            c->off[i] = off * c->points[i].weight;
        }
    }
    double largest = 0;
    for (size_t i = 0; i < c->count; i++)
        largest = fmax(largest, c->off[i]);
    return largest;
}

/* Each center to the middle of its points; or to their mean, where there is a limit. `members` holds the points of
 * center i from first[i] on, by the same counting sort as the centers' cells. */
static void move_centers(struct palette_choice *c, uint32_t *first, uint32_t *members, double limit)
{
    memset(first, 0, (c->entries + 1) * sizeof *first);
    for (size_t i = 0; i < c->count; i++)
        first[c->nearest[i] + 1]++;
    for (uint32_t i = 0; i < c->entries; i++)
        first[i + 1] += first[i];
    for (size_t i = 0; i < c->count; i++)
        members[first[c->nearest[i]]++] = (uint32_t)i;
    memmove(first + 1, first, c->entries * sizeof *first);
    first[0] = 0;
    sigset_t before;
    signals_hold_but_faults(&before);
#pragma omp parallel
    {
#pragma omp master
        signals_release(&before);
#pragma omp for schedule(dynamic, 64)
        for (uint32_t i = 0; i < c->entries; i++) {
            const uint32_t *own = members + first[i], count = first[i + 1] - first[i];
            if (limit > 0)
                move_to_mean(c, own, count, limit, c->centers[i].at);
            else
                move_to_middle(c, own, count, c->centers[i].at);
        }
    }
}

void palette_rounds(struct palette_choice *c)
{
    struct palette_grid grid = palette_grid_new(c->entries);
    uint32_t *order = allocate(c->entries, sizeof *order), *first = allocate(c->entries + 1, sizeof *first);
    uint32_t *members = allocate(c->count, sizeof *members);
    double largest = assign(c, &grid, order);
    for (int round = 0; round < ROUNDS; round++) {
        move_centers(c, first, members, 0);
        largest = assign(c, &grid, order);
    }
    for (int round = 0; round < ROUNDS; round++) {
        move_centers(c, first, members, largest);
        assign(c, &grid, order);
    }
    free(members);
    free(first);
    free(order);
    free(grid.first);
}
