/* SPDX-License-Identifier: MIT
 * A palette of normals that keeps the largest error small: farthest points first (no choice's largest distance is more
 * than twice the best), then rounds that move each entry to the middle of what it stands for. No chance in it: the same
 * normals give the same palette. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bake.h"
#include "host.h"

enum { SIDE_LIMIT = 128, ROUNDS = 12, BALL_STEPS = 40 };

struct point {
    double at[3]; /* in units of 2^-15 */
    double weight;
};

/* A set of points, in order of the cells that they lie in, over x and y. */
struct grid {
    int side;
    double cell;     /* its width */
    uint32_t *first; /* side^2 + 1 */
};

struct choice {
    struct point *points; /* the different normals, by cell */
    size_t count;
    struct grid of_points;
    double least_weight;
    struct point *centers;
    uint32_t entries;
    uint32_t *nearest; /* of each point, the center */
    double *off;       /* and the weighted distance to it */
};

static double distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

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

static int cell_at(const struct grid *grid, double x)
{
    return (int)fmax(0, fmin(grid->side - 1, floor((x + 32768) / grid->cell)));
}

static uint32_t cell_of(const struct grid *grid, const double at[3])
{
    return (uint32_t)(cell_at(grid, at[1]) * grid->side + cell_at(grid, at[0]));
}

static struct grid grid_new(uint32_t entries)
{
    const int side = (int)fmin(SIDE_LIMIT, ceil(2 * sqrt(entries)));
    struct grid grid = {side, 65536. / side, NULL};
    grid.first = allocate((size_t)side * (size_t)side + 1, sizeof *grid.first);
    return grid;
}

/* The centers by cells: their numbers into `order`. */
static void sort_centers(const struct choice *c, struct grid *grid, uint32_t *order)
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
static uint32_t nearest_center(const struct choice *c, const struct grid *grid, const uint32_t *order,
                               const double at[3], double *off)
{
    const int x0 = cell_at(grid, at[0]), y0 = cell_at(grid, at[1]);
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
                    const double d = distance(at, c->centers[order[i]].at);
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

static void update_cell(const struct choice *c, uint32_t cell, const struct point *center, uint32_t number,
                        struct farthest *farthest)
{
    *farthest = (struct farthest){-1, 0};
    for (uint32_t i = c->of_points.first[cell]; i < c->of_points.first[cell + 1]; i++) {
        const double off = c->points[i].weight * distance(c->points[i].at, center->at);
        if (off < c->off[i]) {
            c->off[i] = off;
            c->nearest[i] = number;
        }
        if (c->off[i] > farthest->off)
            *farthest = (struct farthest){c->off[i], i};
    }
}

static void choose_farthest(struct choice *c)
{
    const struct grid *grid = &c->of_points;
    const uint32_t cells = (uint32_t)(grid->side * grid->side);
    struct farthest *of_cells = allocate(cells, sizeof *of_cells);
    struct farthest next = {INFINITY, 0};
    for (size_t i = 0; i < c->count; i++) {
        c->off[i] = INFINITY;
        if (c->points[i].at[2] > c->points[next.point].at[2])
            next.point = (uint32_t)i;
    }
    for (uint32_t number = 0; number < c->entries; number++) {
        const struct point *center = &c->centers[number];
        c->centers[number] = c->points[next.point];
        const double reach = next.off / c->least_weight;
        const int x0 = cell_at(grid, center->at[0] - reach), x1 = cell_at(grid, center->at[0] + reach);
        const int y0 = cell_at(grid, center->at[1] - reach), y1 = cell_at(grid, center->at[1] + reach);
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
}

/* ---- rounds ---- */

/* Towards the middle of the smallest ball around the points, by ever smaller steps to the farthest one. */
static void move_to_middle(const struct choice *c, const uint32_t *members, uint32_t count, double at[3])
{
    for (int step = 1; step <= BALL_STEPS; step++) {
        double farthest = -1;
        uint32_t point = 0;
        for (uint32_t i = 0; i < count; i++) {
            const double off = c->points[members[i]].weight * distance(c->points[members[i]].at, at);
            if (off > farthest) {
                farthest = off;
                point = members[i];
            }
        }
        for (int k = 0; k < 3; k++)
            at[k] += (c->points[point].at[k] - at[k]) / (step + 1);
    }
}

/* Each point to its nearest center; returns the largest weighted distance. */
static double assign(struct choice *c, struct grid *grid, uint32_t *order)
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

static void move_centers(struct choice *c, uint32_t *first, uint32_t *members)
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
    for (uint32_t i = 0; i < c->entries; i++)
        move_to_middle(c, members + first[i], first[i + 1] - first[i], c->centers[i].at);
}

static void refine(struct choice *c)
{
    struct grid grid = grid_new(c->entries);
    uint32_t *order = allocate(c->entries, sizeof *order), *first = allocate(c->entries + 1, sizeof *first);
    uint32_t *members = allocate(c->count, sizeof *members);
    struct point *best = allocate(c->entries, sizeof *best);
    double least = INFINITY;
    for (int round = 0; round < ROUNDS; round++) {
        const double largest = assign(c, &grid, order);
        if (largest < least) {
            least = largest;
            memcpy(best, c->centers, c->entries * sizeof *best);
        }
        move_centers(c, first, members);
    }
    memcpy(c->centers, best, c->entries * sizeof *best);
    assign(c, &grid, order);
    free(best);
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
static void find_points(struct choice *c, const struct glint_vec *given, size_t count, uint32_t *which)
{
    struct grid *grid = &c->of_points;
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
            c->points[c->count++] = (struct point){{v->x, v->y, v->z}, weights[lround(tilt)]};
            grid->first[(keys[i].cell_and_normal >> 48) + 1]++;
        }
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
    struct choice c = {.points = allocate(count, sizeof *c.points), .of_points = grid_new(entries)};
    uint32_t *which = allocate(count, sizeof *which);
    find_points(&c, given, count, which);
    c.entries = c.count < entries ? (uint32_t)c.count : entries;
    c.centers = allocate(c.entries, sizeof *c.centers);
    c.nearest = allocate(c.count, sizeof *c.nearest);
    c.off = allocate(c.count, sizeof *c.off);
    choose_farthest(&c);
    if (c.entries < c.count)
        refine(&c);
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
