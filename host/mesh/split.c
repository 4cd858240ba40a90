/* SPDX-License-Identifier: MIT
 * Pass by pass: the faces' edges are sorted by the two places that they join, so that those of one edge lie side by side, also where
 * a crease gives each side vertices of its own. What is decided for one of them holds for all. */
#include "mesh/split.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "glint_mesh.h"

enum { NONE = UINT32_MAX, PASSES = 10 };

struct edge {
    uint32_t low, high; /* places */
    uint32_t from, to;  /* vertices, at low and at high */
    uint32_t face, at;  /* from corner `at` to the next */
};

static int by_ends(const void *a, const void *b)
{
    const struct edge *p = a, *q = b;
    const uint32_t of_p[5] = {p->low, p->high, p->from, p->to, p->face},
                   of_q[5] = {q->low, q->high, q->from, q->to, q->face};
    for (int i = 0; i < 5; i++)
        if (of_p[i] != of_q[i])
            return of_p[i] < of_q[i] ? -1 : 1;
    return 0;
}

static struct edge *sorted_edges(const struct mesh *mesh)
{
    struct edge *edges = allocate(3 * mesh->face_count, sizeof *edges);
    for (uint32_t i = 0; i < 3 * mesh->face_count; i++) {
        const uint32_t *face = mesh->faces[i / 3], a = face[i % 3], b = face[(i + 1) % 3];
        const bool up = mesh->at[a] < mesh->at[b];
        edges[i] = (struct edge){mesh->at[up ? a : b], mesh->at[up ? b : a], up ? a : b, up ? b : a, i / 3, i % 3};
    }
    qsort(edges, 3 * mesh->face_count, sizeof *edges, by_ends);
    return edges;
}

/* The vertex in the middle of an edge. */
static uint32_t middle(struct mesh *mesh, const struct edge *edge, uint32_t place)
{
    const size_t i = mesh->vertex_count++;
    const double *a = mesh->normals[edge->from], *b = mesh->normals[edge->to];
    double *normal = mesh->normals[i];
    for (int k = 0; k < 3; k++) {
        mesh->places[i][k] = (mesh->places[edge->from][k] + mesh->places[edge->to][k]) / 2;
        normal[k] = a[k] + b[k];
    }
    if (mesh_dot(normal, normal) < 1e-6) { /* opposite: the face's own, which is between them */
        const uint32_t *face = mesh->faces[edge->face];
        mesh_face_normal(mesh->places[face[0]], mesh->places[face[1]], mesh->places[face[2]], normal);
    }
    if (!mesh_normalize(normal))
        memcpy(normal, a, sizeof *mesh->normals);
    for (int k = 0; mesh->colors && k < 3; k++)
        mesh->colors[i][k] = (uint8_t)((mesh->colors[edge->from][k] + mesh->colors[edge->to][k] + 1) / 2);
    for (int k = 0; mesh->uv && k < 2; k++)
        mesh->uv[i][k] = (mesh->uv[edge->from][k] + mesh->uv[edge->to][k]) / 2;
    mesh->at[i] = place;
    return (uint32_t)i;
}

/* Each face's edges' middles, NONE where an edge stays. Returns how many faces there will be. */
static size_t choose(struct mesh *mesh, double least, uint32_t (*middles)[3])
{
    const size_t count = 3 * mesh->face_count;
    struct edge *edges = sorted_edges(mesh);
    size_t added = 0;
    memset(middles, 0xff, mesh->face_count * sizeof *middles);
    mesh->places = enlarge(mesh->places, mesh->vertex_count + count, sizeof *mesh->places);
    mesh->normals = enlarge(mesh->normals, mesh->vertex_count + count, sizeof *mesh->normals);
    if (mesh->colors)
        mesh->colors = enlarge(mesh->colors, mesh->vertex_count + count, sizeof *mesh->colors);
    if (mesh->uv)
        mesh->uv = enlarge(mesh->uv, mesh->vertex_count + count, sizeof *mesh->uv);
    mesh->at = enlarge(mesh->at, mesh->vertex_count + count, sizeof *mesh->at);
    for (size_t i = 0, end; i < count; i = end) {
        bool cut = false;
        for (end = i; end < count && edges[end].low == edges[i].low && edges[end].high == edges[i].high; end++)
            cut |= mesh_dot(mesh->normals[edges[end].from], mesh->normals[edges[end].to]) < least;
        if (!cut)
            continue;
        const uint32_t place = (uint32_t)mesh->place_count++;
        for (size_t j = i; j < end; j++) {
            const bool same = j > i && edges[j].from == edges[j - 1].from && edges[j].to == edges[j - 1].to;
            const uint32_t vertex = same ? (uint32_t)mesh->vertex_count - 1 : middle(mesh, &edges[j], place);
            middles[edges[j].face][edges[j].at] = vertex;
        }
        added += end - i;
    }
    free(edges);
    return mesh->face_count + added;
}

static double distance(const struct mesh *mesh, uint32_t a, uint32_t b)
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += (mesh->places[a][k] - mesh->places[b][k]) * (mesh->places[a][k] - mesh->places[b][k]);
    return sum;
}

/* The face in pieces; returns how many. */
static size_t cut_face(const struct mesh *mesh, const uint32_t face[3], const uint32_t middles[3], uint32_t (*out)[3])
{
    const int cuts = (middles[0] != NONE) + (middles[1] != NONE) + (middles[2] != NONE);
    int turn = 0; /* until a-b is the only edge cut, or c-a the only one that is not */
    while (cuts && cuts < 3 && (cuts == 1 ? middles[turn] == NONE : middles[(turn + 2) % 3] != NONE))
        turn++;
    const uint32_t a = face[turn], b = face[(turn + 1) % 3], c = face[(turn + 2) % 3];
    const uint32_t ab = middles[turn], bc = middles[(turn + 1) % 3], ca = middles[(turn + 2) % 3];
    if (cuts == 0) {
        memcpy(out[0], face, sizeof *out);
        return 1;
    }
    if (cuts == 1) {
        const uint32_t two[2][3] = {{a, ab, c}, {ab, b, c}};
        memcpy(out, two, sizeof two);
        return 2;
    }
    if (cuts == 3) {
        const uint32_t four[4][3] = {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}};
        memcpy(out, four, sizeof four);
        return 4;
    }
    const bool from_a = distance(mesh, a, bc) < distance(mesh, ab, c); /* the shorter of the two diagonals */
    const uint32_t three[3][3] = {{ab, b, bc}, {a, ab, from_a ? bc : c}, {from_a ? a : ab, bc, c}};
    memcpy(out, three, sizeof three);
    return 3;
}

static void cut_faces(struct mesh *mesh, uint32_t (*middles)[3], size_t most)
{
    uint32_t(*faces)[3] = allocate(most, sizeof *faces);
    size_t count = 0, part = 0;
    for (size_t i = 0; i < mesh->face_count; i++) {
        count += cut_face(mesh, mesh->faces[i], middles[i], faces + count);
        while (part < mesh->part_count && mesh->ends[part] == i + 1)
            mesh->ends[part++] = count;
    }
    free(mesh->faces);
    mesh->faces = faces;
    mesh->face_count = count;
}

/* The most that the normal turns over any edge, in degrees. */
static double largest_turn(const struct mesh *mesh)
{
    double least = 1;
    for (size_t i = 0; i < 3 * mesh->face_count; i++)
        least = fmin(
            least, mesh_dot(mesh->normals[mesh->faces[i / 3][i % 3]], mesh->normals[mesh->faces[i / 3][(i + 1) % 3]]));
    return acos(fmax(-1, least)) * 180 / M_PI;
}

bool mesh_split_within(struct mesh *mesh, double degrees, size_t faces_most)
{
    const double least = mesh_cosine(degrees);
    mesh->whole_vertex_count = mesh->vertex_count;
    mesh->whole_face_count = mesh->face_count;
    mesh->split = degrees;
    mesh->whole_turn = largest_turn(mesh);
    for (int pass = 0; pass < PASSES; pass++) {
        uint32_t(*middles)[3] = allocate(mesh->face_count, sizeof *middles);
        const size_t before = mesh->face_count, count = choose(mesh, least, middles);
        const bool fits = count <= faces_most && count <= GLINT_MESH_FACES_MAX && mesh->vertex_count <= UINT16_MAX;
        if (fits)
            cut_faces(mesh, middles, count);
        free(middles);
        if (!fits || count == before)
            return fits;
    }
    return true;
}

void mesh_split(struct mesh *mesh, double degrees)
{
    if (!mesh_split_within(mesh, degrees, GLINT_MESH_FACES_MAX))
        fail("%s: --split %g makes more than %u triangles or %u vertices of it; give a larger angle, or simplify "
             "the mesh",
             mesh->name, degrees, GLINT_MESH_FACES_MAX, UINT16_MAX);
}
