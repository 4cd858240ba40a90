/* SPDX-License-Identifier: MIT
 * Places are found in a grid of cells twice the tolerance wide: what is within it lies in one of 8 cells. Those with a corner are sorted, so
 * that no file can put many into one list, and a list has no more places than lie apart in a cell. */
#include "mesh/weld.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "mesh/corner_normals.h"

enum { PARTS_MAX = 255 };
static const double tolerance = 1e-5; /* of the mesh's size */

/* The places that there are, in lists by cell. */
struct grid {
    double low[3], near; /* near: the tolerance */
    double (*places)[3];
    uint32_t count, *next, *first; /* number + 1; 0: none */
    uint64_t *cells;               /* sorted */
    size_t cell_count;
};

/* The cell of a place, and to which side the nearest others are. */
static void cell_of(const struct grid *grid, const double at[3], int64_t cell[3], int step[3])
{
    for (int k = 0; k < 3; k++) {
        const double x = (at[k] - grid->low[k]) / (2 * grid->near); /* 0..10^5 */
        cell[k] = (int64_t)floor(x);
        step[k] = x - floor(x) < .5 ? -1 : 1;
    }
}

static uint64_t key_of(const int64_t cell[3]) /* -1..10^5 each */
{
    return (uint64_t)(cell[2] + 1) << 40 | (uint64_t)(cell[1] + 1) << 20 | (uint64_t)(cell[0] + 1);
}

static int by_key(const void *a, const void *b)
{
    const uint64_t p = *(const uint64_t *)a, q = *(const uint64_t *)b;
    return p < q ? -1 : p > q;
}

/* The list of a cell; NULL: no corner is in it. */
static uint32_t *list_of(const struct grid *grid, const int64_t cell[3])
{
    const uint64_t key = key_of(cell);
    const uint64_t *found = bsearch(&key, grid->cells, grid->cell_count, sizeof key, by_key);
    return found ? &grid->first[found - grid->cells] : NULL;
}

/* The number of a place within the tolerance; a new one where there is none. */
static uint32_t grid_place(struct grid *grid, const double at[3])
{
    int64_t cell[3], other[3];
    int step[3];
    cell_of(grid, at, cell, step);
    for (int i = 0; i < 8; i++) {
        for (int k = 0; k < 3; k++)
            other[k] = cell[k] + (i >> k & 1 ? step[k] : 0);
        const uint32_t *const list = list_of(grid, other);
        for (uint32_t j = list ? *list : 0; j; j = grid->next[j - 1]) {
            const double *place = grid->places[j - 1];
            if (fabs(place[0] - at[0]) <= grid->near && fabs(place[1] - at[1]) <= grid->near &&
                fabs(place[2] - at[2]) <= grid->near)
                return j - 1;
        }
    }
    memcpy(grid->places[grid->count], at, sizeof *grid->places);
    uint32_t *const head = list_of(grid, cell);
    grid->next[grid->count] = *head;
    *head = ++grid->count;
    return grid->count - 1;
}

static void set_cells(struct grid *grid, const struct soup *soup)
{
    int64_t cell[3];
    int step[3];
    const size_t corners = 3 * soup->face_count;
    grid->cells = allocate(corners, sizeof *grid->cells);
    for (size_t i = 0; i < corners; i++) {
        cell_of(grid, soup->faces[i / 3].places[i % 3], cell, step);
        grid->cells[i] = key_of(cell);
    }
    qsort(grid->cells, corners, sizeof *grid->cells, by_key);
    for (size_t i = 0; i < corners; i++)
        if (!i || grid->cells[i] != grid->cells[grid->cell_count - 1])
            grid->cells[grid->cell_count++] = grid->cells[i];
    grid->first = allocate(grid->cell_count, sizeof *grid->first);
}

static struct grid *grid_new(const struct soup *soup)
{
    struct grid *grid = allocate(1, sizeof *grid);
    double size = 0;
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < 3 * soup->face_count; i++) {
            low = fmin(low, soup->faces[i / 3].places[i % 3][k]);
            high = fmax(high, soup->faces[i / 3].places[i % 3][k]);
        }
        grid->low[k] = low;
        size = fmax(size, high - low);
    }
    if (!(size > 0)) /* and below 2e30: soup_check_faces */
        fail("%s: has no size: all its corners are at one place; repair the mesh", soup->name);
    grid->near = tolerance * size;
    grid->places = allocate(3 * soup->face_count, sizeof *grid->places);
    grid->next = allocate(3 * soup->face_count, sizeof *grid->next);
    set_cells(grid, soup);
    return grid;
}

static void grid_free(struct grid *grid)
{
    free(grid->places);
    free(grid->next);
    free(grid->first);
    free(grid->cells);
    free(grid);
}

/* The faces that have an area, by part: their places, and where in the soup each was. Returns how many they are. */
static size_t join(const struct soup *soup, struct grid *grid, uint32_t (*faces)[3], size_t *from, struct mesh *mesh)
{
    size_t count = 0;
    mesh->ends = allocate(soup->part_count, sizeof *mesh->ends);
    mesh->materials = allocate(soup->part_count, sizeof *mesh->materials);
    for (unsigned part = 0; part < soup->part_count; part++) {
        const size_t before = count;
        for (size_t i = 0; i < soup->face_count; i++) {
            uint32_t *face = faces[count];
            double normal[3];
            if (soup->faces[i].part != part)
                continue;
            for (int k = 0; k < 3; k++)
                face[k] = grid_place(grid, soup->faces[i].places[k]);
            mesh_face_normal(grid->places[face[0]], grid->places[face[1]], grid->places[face[2]], normal);
            if (sqrt(mesh_dot(normal, normal)) > grid->near * grid->near)
                from[count++] = i;
        }
        if (count == before)
            continue;
        if (mesh->part_count == PARTS_MAX)
            fail("%s: has more than %d parts of different material; join some", soup->name, PARTS_MAX);
        mesh->ends[mesh->part_count] = count;
        mesh->materials[mesh->part_count++] = soup->materials[part];
    }
    return count;
}

struct mesh *mesh_weld(const struct soup *soup, double crease)
{
    struct mesh *mesh = allocate(1, sizeof *mesh);
    struct grid *grid = grid_new(soup);
    uint32_t(*faces)[3] = allocate(soup->face_count, sizeof *faces);
    size_t *from = allocate(soup->face_count, sizeof *from);
    mesh->name = copied(soup->name);
    mesh->face_count = join(soup, grid, faces, from, mesh);
    mesh->place_count = grid->count;
    if (!mesh->face_count)
        fail("%s: has no triangle with an area; repair the mesh", soup->name);
    double(*normals)[3][3] = allocate(mesh->face_count, sizeof *normals);
    mesh->has_own_normals =
        crease < 0 && soup->has_normals && corner_normals_given(soup, from, mesh->face_count, normals);
    if (!mesh->has_own_normals) {
        corner_normals_made(grid->places, faces, mesh->face_count, crease < 0 ? CREASE_USUAL : crease, normals);
        if (crease < 0)
            corner_normals_given(soup, from, mesh->face_count, normals);
    }
    corner_normals_join(mesh, soup, from, grid->places, faces, normals);
    free(normals);
    free(faces);
    free(from);
    grid_free(grid);
    return mesh;
}
