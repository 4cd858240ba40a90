/* SPDX-License-Identifier: MIT
 * Sander, Nehab, Barczak, "Fast triangle reordering for vertex locality" (2007): all faces around a vertex one after the other, then
 * those around the vertex that was used last and has some left; where there is none, an earlier one, or the next in the file. */
#include "mesh/order.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

enum { NONE = UINT32_MAX };

struct work {
    const struct mesh *mesh;
    size_t *starts;   /* of each vertex its faces in `around`; one more at the end */
    uint32_t *around; /* faces */
    uint32_t *left;   /* of each vertex, faces not yet taken */
    bool *taken;      /* of each face */
    uint32_t *stack;  /* vertices used, the latest on top */
    size_t depth;
    uint32_t (*out)[3];
    size_t count;
};

/* The faces first..end - 1 of a part around each vertex. */
static void begin_part(struct work *work, size_t first, size_t end)
{
    const struct mesh *mesh = work->mesh;
    size_t at = 0;
    memset(work->left, 0, mesh->vertex_count * sizeof *work->left);
    for (size_t i = 3 * first; i < 3 * end; i++)
        work->left[mesh->faces[i / 3][i % 3]]++;
    for (size_t i = 0; i <= mesh->vertex_count; i++) {
        work->starts[i] = at;
        at += i < mesh->vertex_count ? work->left[i] : 0;
    }
    memset(work->left, 0, mesh->vertex_count * sizeof *work->left);
    for (size_t i = 3 * first; i < 3 * end; i++) {
        const uint32_t vertex = mesh->faces[i / 3][i % 3];
        work->around[work->starts[vertex] + work->left[vertex]++] = (uint32_t)(i / 3);
    }
    work->depth = 0;
}

static void take_around(struct work *work, uint32_t vertex)
{
    for (size_t i = work->starts[vertex]; i < work->starts[vertex + 1]; i++) {
        const uint32_t face = work->around[i];
        if (work->taken[face])
            continue;
        work->taken[face] = true;
        memcpy(work->out[work->count++], work->mesh->faces[face], sizeof *work->out);
        for (int k = 0; k < 3; k++) {
            const uint32_t corner = work->mesh->faces[face][k];
            work->left[corner]--;
            work->stack[work->depth++] = corner; /* 3 a face: the stack has room for all */
        }
    }
}

static uint32_t latest(struct work *work)
{
    while (work->depth)
        if (work->left[work->stack[--work->depth]])
            return work->stack[work->depth];
    return NONE;
}

static void order_part(struct work *work, size_t first, size_t end)
{
    begin_part(work, first, end);
    for (size_t i = 3 * first; i < 3 * end; i++) {
        uint32_t vertex = work->mesh->faces[i / 3][i % 3];
        while (vertex != NONE) {
            if (work->left[vertex])
                take_around(work, vertex);
            vertex = latest(work);
        }
    }
}

static void *moved(void *array, const uint32_t *to, size_t count, size_t size)
{
    uint8_t *out = allocate(count, size);
    for (size_t i = 0; i < count; i++)
        memcpy(out + size * to[i], (const uint8_t *)array + size * i, size);
    free(array);
    return out;
}

/* A vertex that no face has goes last. */
static void order_vertices(struct mesh *mesh)
{
    uint32_t *to = allocate(mesh->vertex_count, sizeof *to), count = 0;
    memset(to, 0xff, mesh->vertex_count * sizeof *to);
    for (size_t i = 0; i < 3 * mesh->face_count; i++) {
        uint32_t *corner = &mesh->faces[i / 3][i % 3];
        if (to[*corner] == NONE)
            to[*corner] = count++;
        *corner = to[*corner];
    }
    for (size_t i = 0; i < mesh->vertex_count; i++)
        if (to[i] == NONE)
            to[i] = count++;
    mesh->places = moved(mesh->places, to, mesh->vertex_count, sizeof *mesh->places);
    mesh->normals = moved(mesh->normals, to, mesh->vertex_count, sizeof *mesh->normals);
    if (mesh->colors)
        mesh->colors = moved(mesh->colors, to, mesh->vertex_count, sizeof *mesh->colors);
    if (mesh->uv)
        mesh->uv = moved(mesh->uv, to, mesh->vertex_count, sizeof *mesh->uv);
    mesh->at = moved(mesh->at, to, mesh->vertex_count, sizeof *mesh->at);
    free(to);
}

void mesh_order(struct mesh *mesh)
{
    const size_t corners = 3 * mesh->face_count;
    struct work work = {.mesh = mesh,
                        .starts = allocate(mesh->vertex_count + 1, sizeof *work.starts),
                        .around = allocate(corners, sizeof *work.around),
                        .left = allocate(mesh->vertex_count, sizeof *work.left),
                        .taken = allocate(mesh->face_count, sizeof *work.taken),
                        .stack = allocate(corners, sizeof *work.stack),
                        .out = allocate(mesh->face_count, sizeof *work.out)};
    for (unsigned part = 0; part < mesh->part_count; part++)
        order_part(&work, part ? mesh->ends[part - 1] : 0, mesh->ends[part]);
    free(mesh->faces);
    mesh->faces = work.out;
    free(work.starts);
    free(work.around);
    free(work.left);
    free(work.taken);
    free(work.stack);
    order_vertices(mesh);
}
