/* SPDX-License-Identifier: MIT */
#include "mesh/corner_normals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

static void face_direction(double (*places)[3], const uint32_t face[3], double out[3])
{
    mesh_face_normal(places[face[0]], places[face[1]], places[face[2]], out);
    mesh_normalize(out);
}

bool corner_normals_given(const struct soup *soup, const size_t *from, size_t count, double (*normals)[3][3])
{
    bool all = true;
    for (size_t i = 0; i < 3 * count; i++) {
        double normal[3];
        memcpy(normal, soup->faces[from[i / 3]].normals[i % 3], sizeof normal);
        const bool is_one = soup->has_normals && mesh_normalize(normal);
        all &= is_one;
        if (is_one)
            memcpy(normals[i / 3][i % 3], normal, sizeof normal);
    }
    return all;
}

/* ---- made ones: corners are joined over edges, and each set of joined corners has one normal ---- */

struct edge {
    uint32_t low, high; /* its places */
    uint32_t face, at;  /* from corner `at` to the next */
};

static int by_places(const void *a, const void *b)
{
    const struct edge *p = a, *q = b;
    if (p->low != q->low)
        return p->low < q->low ? -1 : 1;
    if (p->high != q->high)
        return p->high < q->high ? -1 : 1;
    return p->face < q->face ? -1 : p->face > q->face;
}

/* The set that a corner is in, named by one of them. */
static uint32_t set_of(uint32_t *sets, uint32_t corner)
{
    while (sets[corner] != corner)
        corner = sets[corner] = sets[sets[corner]];
    return corner;
}

static uint32_t corner_at(const uint32_t face[3], uint32_t number, uint32_t place)
{
    return 3 * number + (face[0] == place ? 0 : face[1] == place ? 1 : 2);
}

static void join_over_edges(uint32_t (*faces)[3], size_t count, double (*directions)[3], double crease, uint32_t *sets)
{
    struct edge *edges = allocate(3 * count, sizeof *edges);
    const double least = mesh_cosine(crease);
    for (uint32_t i = 0; i < 3 * count; i++) {
        const uint32_t *face = faces[i / 3], a = face[i % 3], b = face[(i + 1) % 3];
        edges[i] = (struct edge){a < b ? a : b, a < b ? b : a, i / 3, i % 3};
        sets[i] = i;
    }
    qsort(edges, 3 * count, sizeof *edges, by_places);
    for (size_t i = 1; i < 3 * count; i++) {
        const struct edge *a = &edges[i - 1], *b = &edges[i];
        if (a->low != b->low || a->high != b->high || mesh_dot(directions[a->face], directions[b->face]) < least)
            continue;
        for (int end = 0; end < 2; end++) {
            const uint32_t place = end ? a->high : a->low;
            sets[set_of(sets, corner_at(faces[a->face], a->face, place))] =
                set_of(sets, corner_at(faces[b->face], b->face, place));
        }
    }
    free(edges);
}

static double corner_angle(double (*places)[3], const uint32_t face[3], int k)
{
    double p[3], q[3];
    for (int j = 0; j < 3; j++) {
        p[j] = places[face[(k + 1) % 3]][j] - places[face[k]][j];
        q[j] = places[face[(k + 2) % 3]][j] - places[face[k]][j];
    }
    return mesh_normalize(p) && mesh_normalize(q) ? acos(fmax(-1, fmin(1, mesh_dot(p, q)))) : 0;
}

void corner_normals_made(double (*places)[3], uint32_t (*faces)[3], size_t count, double crease,
                         double (*normals)[3][3])
{
    double(*directions)[3] = allocate(count, sizeof *directions), (*sums)[3] = allocate(3 * count, sizeof *sums);
    uint32_t *sets = allocate(3 * count, sizeof *sets);
    for (size_t i = 0; i < count; i++)
        face_direction(places, faces[i], directions[i]);
    join_over_edges(faces, count, directions, crease, sets);
    for (uint32_t i = 0; i < 3 * count; i++) {
        const double angle = corner_angle(places, faces[i / 3], (int)(i % 3));
        for (int k = 0; k < 3; k++)
            sums[set_of(sets, i)][k] += angle * directions[i / 3][k];
    }
    for (uint32_t i = 0; i < 3 * count; i++) {
        double *normal = normals[i / 3][i % 3];
        memcpy(normal, sums[set_of(sets, i)], sizeof *sums);
        if (mesh_dot(normal, normal) < 1e-12 || !mesh_normalize(normal)) /* faces back to back */
            memcpy(normal, directions[i / 3], sizeof *directions);
    }
    free(directions);
    free(sums);
    free(sets);
}

/* ---- vertices ---- */

static bool is_vertex(const struct mesh *mesh, uint32_t vertex, const double normal[3], double same,
                      const struct soup_face *face, size_t corner)
{
    const double near = 1. / 65536; /* of a picture */
    if (mesh_dot(mesh->normals[vertex], normal) < same ||
        (mesh->colors && memcmp(mesh->colors[vertex], face->colors[corner], 3) != 0))
        return false;
    return !mesh->uv || (fabs(mesh->uv[vertex][0] - face->uv[corner][0]) < near &&
                         fabs(mesh->uv[vertex][1] - face->uv[corner][1]) < near);
}

void corner_normals_join(struct mesh *mesh, const struct soup *soup, const size_t *from, double (*places)[3],
                         uint32_t (*faces)[3], double (*normals)[3][3])
{
    const double same = mesh_cosine(.5);
    const size_t corners = 3 * mesh->face_count;
    uint32_t *first = allocate(mesh->place_count, sizeof *first), *next = allocate(corners, sizeof *next);
    mesh->places = allocate(corners, sizeof *mesh->places);
    mesh->normals = allocate(corners, sizeof *mesh->normals);
    if (soup->has_colors)
        mesh->colors = allocate(corners, sizeof *mesh->colors);
    if (soup->has_uv)
        mesh->uv = allocate(corners, sizeof *mesh->uv);
    mesh->at = allocate(corners, sizeof *mesh->at);
    mesh->faces = allocate(mesh->face_count, sizeof *mesh->faces);
    for (size_t i = 0; i < corners; i++) {
        const uint32_t place = faces[i / 3][i % 3];
        const double *normal = normals[i / 3][i % 3];
        const struct soup_face *face = &soup->faces[from[i / 3]];
        uint32_t vertex = first[place];
        while (vertex && !is_vertex(mesh, vertex - 1, normal, same, face, i % 3))
            vertex = next[vertex - 1];
        if (!vertex) {
            vertex = (uint32_t)++mesh->vertex_count;
            memcpy(mesh->places[vertex - 1], places[place], sizeof *places);
            memcpy(mesh->normals[vertex - 1], normal, sizeof *mesh->normals);
            if (mesh->colors)
                memcpy(mesh->colors[vertex - 1], face->colors[i % 3], 3);
            if (mesh->uv)
                memcpy(mesh->uv[vertex - 1], face->uv[i % 3], sizeof *mesh->uv);
            mesh->at[vertex - 1] = place;
            next[vertex - 1] = first[place];
            first[place] = vertex;
        }
        mesh->faces[i / 3][i % 3] = vertex - 1;
    }
    free(first);
    free(next);
}
