/* SPDX-License-Identifier: MIT
 * Meshes for tests of the host: soups, and what must hold for any mesh. */
#ifndef GLINT_UNIT_SOLIDS_H
#define GLINT_UNIT_SOLIDS_H

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "mesh/soup.h"
#include "unit.h"

static inline struct soup *soup_made(double (*places)[3], const int (*faces)[3], size_t count)
{
    struct soup *soup = calloc(1, sizeof *soup);
    assert_non_null(soup);
    soup->name = strdup("made");
    soup->face_count = count;
    soup->faces = calloc(count, sizeof *soup->faces);
    soup->part_count = 1;
    soup->materials = calloc(1, sizeof *soup->materials);
    for (size_t i = 0; i < 3 * count; i++)
        memcpy(soup->faces[i / 3].places[i % 3], places[faces[i / 3][i % 3]], sizeof *places);
    return soup;
}

/* Of side 2, counterclockwise from outside; corner i at the signs of i's bits x, y, z. */
static inline struct soup *soup_cube(void)
{
    static const int quads[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    double places[8][3];
    int faces[12][3];
    for (int i = 0; i < 8; i++)
        for (int k = 0; k < 3; k++)
            places[i][k] = i >> k & 1 ? 1 : -1;
    for (int i = 0; i < 12; i++)
        for (int k = 0; k < 3; k++)
            faces[i][k] = quads[i / 2][k == 0 ? 0 : k + i % 2];
    return soup_made(places, (const int(*)[3])faces, 12);
}

/* Every edge from a place to another is met by one in the other direction: a closed surface without a T-junction. */
static inline void assert_closed(const struct mesh *mesh)
{
    const size_t places = mesh->place_count;
    signed char *edges = calloc(places * places, 1);
    assert_non_null(edges);
    for (size_t i = 0; i < 3 * mesh->face_count; i++) {
        const uint32_t *face = mesh->faces[i / 3];
        const uint32_t a = mesh->at[face[i % 3]], b = mesh->at[face[(i + 1) % 3]];
        assert_true(a != b && a < places && b < places);
        edges[a * places + b]++;
        edges[b * places + a]--;
    }
    for (size_t i = 0; i < places * places; i++)
        assert_int_equal(edges[i], 0);
    free(edges);
}

/* The largest angle between two corners' normals of one triangle, in degrees. */
static inline double widest_turn(const struct mesh *mesh)
{
    double least = 1;
    for (size_t i = 0; i < 3 * mesh->face_count; i++) {
        const uint32_t *face = mesh->faces[i / 3];
        least = fmin(least, mesh_dot(mesh->normals[face[i % 3]], mesh->normals[face[(i + 1) % 3]]));
    }
    return acos(least) * 180 / M_PI;
}

static inline double area_of(const struct mesh *mesh)
{
    double sum = 0;
    for (size_t i = 0; i < mesh->face_count; i++) {
        double normal[3];
        const uint32_t *face = mesh->faces[i];
        mesh_face_normal(mesh->places[face[0]], mesh->places[face[1]], mesh->places[face[2]], normal);
        sum += sqrt(mesh_dot(normal, normal)) / 2;
    }
    return sum;
}

/* How many vertices a face fetches on average through a cache of the last `size` ones. */
static inline double misses_of(const struct mesh *mesh, unsigned size)
{
    size_t *entered = calloc(mesh->vertex_count, sizeof *entered), misses = 0; /* the miss that fetched it; 0: none */
    assert_non_null(entered);
    for (size_t i = 0; i < 3 * mesh->face_count; i++) {
        size_t *when = &entered[mesh->faces[i / 3][i % 3]];
        if (*when == 0 || misses - *when >= size)
            *when = ++misses;
    }
    free(entered);
    return (double)misses / (double)mesh->face_count;
}

#endif
