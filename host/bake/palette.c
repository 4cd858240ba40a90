/* SPDX-License-Identifier: MIT
 * A palette of normals that keeps the largest error small, and then the mean error, in three steps, each in a file of its
 * own: farthest points first (palette_farthest.c), fewer balls in their place where possible (palette_cover.c), and
 * rounds that move each entry among the normals it stands for (palette_rounds.c). Nothing is random: the same normals
 * give the same palette. */
#include "bake/palette.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bake/palette_cover.h"
#include "bake/palette_farthest.h"
#include "bake/palette_grid.h"
#include "bake/palette_rounds.h"
#include "bake/palette_weights.h"
#include "base/memory.h"

struct key {
    uint64_t cell_and_normal;
    uint32_t place;
};

static int by_key(const void *a, const void *b)
{
    const uint64_t x = ((const struct key *)a)->cell_and_normal, y = ((const struct key *)b)->cell_and_normal;
    return (x > y) - (x < y);
}

/* The different normals in order of their cells; which[i] becomes the point of given[i]. All are sorted by a key of cell
 * and coordinates, so that equal ones lie together and a point begins where the key changes. */
static void find_points(struct palette_choice *c, const struct glint_vec *given, size_t count, uint32_t *which)
{
    struct palette_grid *grid = &c->of_points;
    double weights[PALETTE_TILTS];
    palette_weights(weights);
    c->least_weight = weights[PALETTE_TILTS - 1];
    struct key *keys = allocate(count, sizeof *keys);
    for (size_t i = 0; i < count; i++) {
        const double at[3] = {given[i].x, given[i].y, given[i].z};
        keys[i].cell_and_normal = (uint64_t)palette_grid_cell(grid, at) << 48 | (uint64_t)(uint16_t)given[i].x << 32 |
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
    struct palette_choice c = {.points = allocate(count, sizeof *c.points), .of_points = palette_grid_new(entries)};
    uint32_t *which = allocate(count, sizeof *which);
    find_points(&c, given, count, which);
    c.entries = c.count < entries ? (uint32_t)c.count : entries;
    c.centers = allocate(c.entries, sizeof *c.centers);
    c.nearest = allocate(c.count, sizeof *c.nearest);
    c.off = allocate(c.count, sizeof *c.off);
    const double radius = palette_farthest(&c, 0);
    if (c.entries < c.count) {
        const uint32_t balls = palette_cover(&c, radius);
        if (balls)
            palette_farthest(&c, balls); /* for the entries that are left */
        palette_rounds(&c);
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
