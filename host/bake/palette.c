/* SPDX-License-Identifier: MIT
 * A palette of normals that keeps the largest error small, and then the mean: farthest points first (the largest distance
 * is at most twice the best there is), fewer balls in their place where that can be, then rounds that move each entry to
 * the middle of what it stands for, and at last towards the mean. No chance in it: the same normals, the same palette. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bake/palette.h"
#include "base/memory.h"
#include "models/models.h"

enum { SIDE_LIMIT = 128, ROUNDS = 4, BALL_STEPS = 60 };

/* ---- how much an error matters ---- */

static double slope(double angle)
{
    static const double step = 1e-3;
    const double n = 60;
    return fabs(model_double(GLINT_MSH, n, cos(angle + step)) - model_double(GLINT_MSH, n, cos(angle - step))) /
           (2 * step);
}

/* The half vector of a light before the screen lies within 45 degrees of the viewer: on steeper normals the highlight
 * is seen only by its flank, down to where the diffuse part's slope, at most 1, counts as much. By whole degrees. */
static void fill_weights(double weights[181])
{
    const double degree = M_PI / 180;
    double steepest = 0;
    for (int tilt = 180; tilt >= 0; tilt--) {
        const double angle = fmax(0, tilt - 45) * degree;
        if (angle < M_PI / 2)
            steepest = fmax(steepest, slope(fmax(angle, degree / 2)));
        weights[tilt] = fmax(1, steepest);
    }
    for (int tilt = 180; tilt >= 0; tilt--)
        weights[tilt] /= weights[0];
}

/* ---- the grid ---- */

static uint32_t cell_of(const struct palette_grid *grid, const double at[3])
{
    return (uint32_t)(palette_cell(grid, at[1]) * grid->side + palette_cell(grid, at[0]));
}

static struct palette_grid grid_new(uint32_t entries)
{
    const int side = (int)fmin(SIDE_LIMIT, ceil(2 * sqrt(entries)));
    struct palette_grid grid = {side, 65536. / side, NULL};
    grid.first = allocate((size_t)side * (size_t)side + 1, sizeof *grid.first);
    return grid;
}

/* The centers by cells: their numbers into `order`. */
static void sort_centers(const struct palette_choice *c, struct palette_grid *grid, uint32_t *order)
{
    const size_t cells = (size_t)grid->side * (size_t)grid->side;
    memset(grid->first, 0, (cells + 1) * sizeof *grid->first);
    for (uint32_t i = 0; i < c->entries; i++)
        grid->first[cell_of(grid, c->centers[i].at) + 1]++;
    for (size_t i = 0; i < cells; i++)
        grid->first[i + 1] += grid->first[i];
    for (uint32_t i = 0; i < c->entries; i++)
        order[grid->first[cell_of(grid, c->centers[i].at)]++] = i;
    memmove(grid->first + 1, grid->first, cells * sizeof *grid->first); /* each start had become the next one's */
    grid->first[0] = 0;
}

/* The cells in rings around the point's own, until none farther can hold a nearer one. */
static uint32_t nearest_center(const struct palette_choice *c, const struct palette_grid *grid, const uint32_t *order,
                               const double at[3], double *off)
{
    const int x0 = palette_cell(grid, at[0]), y0 = palette_cell(grid, at[1]);
    uint32_t best = 0;
    *off = INFINITY;
    for (int ring = 0; ring<grid->side && * off>(ring - 1) * grid->cell; ring++)
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

/* ---- farthest points first ---- */

struct farthest {
    double off;
    uint32_t point;
};

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

static double choose_farthest(struct palette_choice *c, uint32_t given)
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
        const int x0 = palette_cell(grid, center->at[0] - reach), x1 = palette_cell(grid, center->at[0] + reach);
        const int y0 = palette_cell(grid, center->at[1] - reach), y1 = palette_cell(grid, center->at[1] + reach);
        for (int y = y0; y <= y1; y++)
            for (int x = x0; x <= x1; x++) {
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

/* ---- rounds ---- */

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

/* Towards the middle of the smallest ball around the points, by ever smaller steps to the farthest one; where that was
 * nearer than before, so that no round makes the largest distance larger. */
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
    sort_centers(c, grid, order);
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < c->count; i++) {
        double off;
        c->nearest[i] = nearest_center(c, grid, order, c->points[i].at, &off);
        c->off[i] = off * c->points[i].weight;
    }
    double largest = 0;
    for (size_t i = 0; i < c->count; i++)
        largest = fmax(largest, c->off[i]);
    return largest;
}

/* To the middles; or to the means, where there is a limit. */
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
#pragma omp parallel for schedule(dynamic, 64)
    for (uint32_t i = 0; i < c->entries; i++) {
        const uint32_t *own = members + first[i], count = first[i + 1] - first[i];
        if (limit > 0)
            move_to_mean(c, own, count, limit, c->centers[i].at);
        else
            move_to_middle(c, own, count, c->centers[i].at);
    }
}

static void refine(struct palette_choice *c)
{
    struct palette_grid grid = grid_new(c->entries);
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

/* ---- from normals and to them ---- */

struct key {
    uint64_t cell_and_normal;
    uint32_t place;
};

static int by_key(const void *a, const void *b)
{
    const uint64_t x = ((const struct key *)a)->cell_and_normal, y = ((const struct key *)b)->cell_and_normal;
    return (x > y) - (x < y);
}

/* The different normals in order of their cells; which[i] becomes the point of given[i]. */
static void find_points(struct palette_choice *c, const struct glint_vec *given, size_t count, uint32_t *which)
{
    struct palette_grid *grid = &c->of_points;
    double weights[181];
    fill_weights(weights);
    c->least_weight = weights[180];
    struct key *keys = allocate(count, sizeof *keys);
    for (size_t i = 0; i < count; i++) {
        const double at[3] = {given[i].x, given[i].y, given[i].z};
        keys[i].cell_and_normal = (uint64_t)cell_of(grid, at) << 48 | (uint64_t)(uint16_t)given[i].x << 32 |
                                  (uint64_t)(uint16_t)given[i].y << 16 | (uint16_t)given[i].z;
        keys[i].place = (uint32_t)i;
    }
    qsort(keys, count, sizeof *keys, by_key);
    memset(grid->first, 0, ((size_t)grid->side * (size_t)grid->side + 1) * sizeof *grid->first);
    for (size_t i = 0; i < count; i++) {
        if (i == 0 || keys[i].cell_and_normal != keys[i - 1].cell_and_normal) {
            const struct glint_vec *v = &given[keys[i].place];
            const double tilt = acos(fmax(-1, fmin(1, v->z / 32768.))) * 180 / M_PI;
            c->points[c->count++] = (struct palette_point){{v->x, v->y, v->z}, weights[lround(tilt)], 0};
            grid->first[(keys[i].cell_and_normal >> 48) + 1]++;
        }
        c->points[c->count - 1].pixels++;
        which[keys[i].place] = (uint32_t)(c->count - 1);
    }
    for (int i = 0; i < grid->side * grid->side; i++)
        grid->first[i + 1] += grid->first[i];
    free(keys);
}

static struct glint_vec to_vec(const double at[3])
{
    const int32_t v[3] = {(int32_t)lround(at[0] * 16384), (int32_t)lround(at[1] * 16384),
                          (int32_t)lround(at[2] * 16384)};
    struct glint_vec out = {0, 0, 32767};
    glint_vec_normalize(&out, v); /* of length 0 only where opposite normals share an entry */
    return out;
}

uint32_t palette_choose(const struct glint_vec *given, size_t count, uint32_t entries, struct glint_vec *palette,
                        uint16_t *places)
{
    if (count == 0)
        return 0;
    struct palette_choice c = {.points = allocate(count, sizeof *c.points), .of_points = grid_new(entries)};
    uint32_t *which = allocate(count, sizeof *which);
    find_points(&c, given, count, which);
    c.entries = c.count < entries ? (uint32_t)c.count : entries;
    c.centers = allocate(c.entries, sizeof *c.centers);
    c.nearest = allocate(c.count, sizeof *c.nearest);
    c.off = allocate(c.count, sizeof *c.off);
    const double radius = choose_farthest(&c, 0);
    if (c.entries < c.count) {
        const uint32_t balls = palette_cover(&c, radius);
        if (balls)
            choose_farthest(&c, balls); /* for the entries that are left */
        refine(&c);
    }
    for (uint32_t i = 0; i < c.entries; i++)
        palette[i] = c.entries < c.count ? to_vec(c.centers[i].at)
                                         : (struct glint_vec){(int16_t)c.centers[i].at[0], (int16_t)c.centers[i].at[1],
                                                              (int16_t)c.centers[i].at[2]};
    for (size_t i = 0; i < count; i++)
        places[i] = (uint16_t)c.nearest[which[i]];
    free(c.points);
    free(c.of_points.first);
    free(c.centers);
    free(c.nearest);
    free(c.off);
    free(which);
    return c.entries;
}
