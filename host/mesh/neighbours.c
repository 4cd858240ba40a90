/* SPDX-License-Identifier: MIT */
#include "mesh/neighbours.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"
#include "glint_mesh.h"

/* Edge k of a face, from the place `from` to the place `to`. */
struct edge {
    uint32_t from, to, face;
    unsigned k;
};

static uint32_t lower_of(const struct edge *edge)
{
    return edge->from < edge->to ? edge->from : edge->to;
}

static uint32_t upper_of(const struct edge *edge)
{
    return edge->from < edge->to ? edge->to : edge->from;
}

static int by_places(const void *first, const void *second)
{
    const struct edge *a = first, *b = second;
    const uint32_t of_a[] = {lower_of(a), upper_of(a), a->face, a->k},
                   of_b[] = {lower_of(b), upper_of(b), b->face, b->k};
    for (int i = 0; i < 4; i++)
        if (of_a[i] != of_b[i])
            return of_a[i] < of_b[i] ? -1 : 1;
    return 0;
}

/* An open edge. */
struct open {
    const double *from, *to;
    double low[3], high[3]; /* the first: along the axis of the search */
    struct edge edge;
};

static int by_low(const void *first, const void *second)
{
    const struct open *a = first, *b = second;
    return a->low[0] < b->low[0] ? -1 : a->low[0] > b->low[0];
}

/* Where along an edge a place is, from 0 to 1, and how far from it. */
static double place_along(const struct open *edge, const double *place, double *distance)
{
    double along[3], to[3], rest[3];
    for (int k = 0; k < 3; k++) {
        along[k] = edge->to[k] - edge->from[k];
        to[k] = place[k] - edge->from[k];
    }
    const double s = mesh_dot(to, along) / mesh_dot(along, along);
    for (int k = 0; k < 3; k++)
        rest[k] = to[k] - s * along[k];
    *distance = sqrt(mesh_dot(rest, rest));
    return s;
}

/* Do they run the other way, with a part in common? */
static bool is_beside(const struct open *a, const struct open *b, double tolerance)
{
    double from_off, to_off;
    const double from = place_along(a, b->from, &from_off), to = place_along(a, b->to, &to_off);
    return from_off <= tolerance && to_off <= tolerance && from > to &&
           fmin(from, 1) - fmax(to, 0) > 1e-3 * (from - to);
}

static bool is_seam(const struct open *a, const struct open *b, double tolerance)
{
    return is_beside(a, b, tolerance) || is_beside(b, a, tolerance);
}

/* How far the mesh reaches along an axis, at most. */
static double size_of(const struct mesh *mesh)
{
    double size = 0;
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            low = fmin(low, mesh->places[i][k]);
            high = fmax(high, mesh->places[i][k]);
        }
        size = fmax(size, high - low);
    }
    return size;
}

/* The axis along which open edges are shortest beside the mesh. */
static int axis_of(const struct open *open, size_t count)
{
    double least = INFINITY;
    int axis = 0;
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY, sum = 0;
        for (size_t i = 0; i < count; i++) {
            low = fmin(low, fmin(open[i].from[k], open[i].to[k]));
            high = fmax(high, fmax(open[i].from[k], open[i].to[k]));
            sum += fabs(open[i].to[k] - open[i].from[k]);
        }
        if (high > low && sum / (high - low) < least) {
            least = sum / (high - low);
            axis = k;
        }
    }
    return axis;
}

static void set_boxes(struct open *open, size_t count)
{
    const int axis = axis_of(open, count);
    for (size_t i = 0; i < 3 * count; i++) {
        const size_t k = (i + (size_t)axis) % 3;
        struct open *edge = &open[i / 3];
        edge->low[i % 3] = fmin(edge->from[k], edge->to[k]);
        edge->high[i % 3] = fmax(edge->from[k], edge->to[k]);
    }
}

static bool is_apart(const struct open *a, const struct open *b, double tolerance)
{
    for (int k = 1; k < 3; k++)
        if (a->low[k] > b->high[k] + tolerance || b->low[k] > a->high[k] + tolerance)
            return true;
    return false;
}

static void find_seams(const struct mesh *mesh, struct open *open, size_t count, uint16_t (*neighbours)[3])
{
    const double tolerance = 3e-5 * size_of(mesh);
    size_t steps = 0;
    set_boxes(open, count);
    qsort(open, count, sizeof *open, by_low);
    for (size_t i = 0; i < count; i++) {
        if (steps > MESH_NEIGHBOURS_STEPS_MAX) {
            warn("%s: has too many open edges to find which lie side by side; some outlines may be drawn twice",
                 mesh->name);
            return;
        }
        for (size_t j = i + 1; j < count && open[j].low[0] <= open[i].high[0] + tolerance; j++) {
            const bool apart = is_apart(&open[i], &open[j], tolerance);
            steps += apart ? 1 : 8; /* as they take time */
            if (apart || !is_seam(&open[i], &open[j], tolerance))
                continue;
            neighbours[open[i].edge.face][open[i].edge.k] = GLINT_MESH_SEAM;
            neighbours[open[j].edge.face][open[j].edge.k] = GLINT_MESH_SEAM;
        }
    }
}

static bool is_together(const struct edge *a, const struct edge *b)
{
    return lower_of(a) == lower_of(b) && upper_of(a) == upper_of(b);
}

/* Of edges at the same two places each is joined with one that runs the other way. Those left over are open. */
static size_t join(const struct mesh *mesh, const struct edge *edges, size_t count, uint16_t (*neighbours)[3],
                   struct open *open)
{
    size_t found = 0, next[2] = {0, 0}; /* from there on edges of each way may be free */
    for (size_t i = 0; i < count; i++) {
        uint16_t *beside = &neighbours[edges[i].face][edges[i].k];
        size_t *const first = &next[edges[i].from == lower_of(&edges[i])];
        bool passed = false; /* one that is free, but for another face */
        for (size_t j = *first > i ? *first : i + 1;
             j < count && *beside == GLINT_MESH_RIM && is_together(&edges[i], &edges[j]); j++) {
            uint16_t *other = &neighbours[edges[j].face][edges[j].k];
            const bool is_free = *other == GLINT_MESH_RIM && edges[j].from == edges[i].to;
            passed |= is_free && edges[j].face == edges[i].face;
            *first = passed ? *first : j + 1;
            if (!is_free || edges[j].face == edges[i].face)
                continue;
            *beside = (uint16_t)edges[j].face;
            *other = (uint16_t)edges[i].face;
        }
        if (*beside != GLINT_MESH_RIM || edges[i].from == edges[i].to)
            continue;
        const uint32_t *face = mesh->faces[edges[i].face];
        const double *from = mesh->places[face[edges[i].k]], *to = mesh->places[face[(edges[i].k + 1) % 3]];
        open[found++] = (struct open){.from = from, .to = to, .edge = edges[i]};
    }
    return found;
}

uint16_t (*mesh_neighbours(const struct mesh *mesh))[3]
{
    const size_t count = 3 * mesh->face_count;
    struct edge *edges = allocate(count, sizeof *edges);
    struct open *open = allocate(count, sizeof *open);
    uint16_t(*neighbours)[3] = allocate(mesh->face_count, sizeof *neighbours);
    for (size_t i = 0; i < count; i++) {
        const uint32_t *face = mesh->faces[i / 3];
        edges[i] =
            (struct edge){mesh->at[face[i % 3]], mesh->at[face[(i + 1) % 3]], (uint32_t)(i / 3), (unsigned)(i % 3)};
        neighbours[i / 3][i % 3] = GLINT_MESH_RIM;
    }
    qsort(edges, count, sizeof *edges, by_places);
    find_seams(mesh, open, join(mesh, edges, count, neighbours, open), neighbours);
    free(edges);
    free(open);
    return neighbours;
}
