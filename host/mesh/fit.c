/* SPDX-License-Identifier: MIT */
#include "mesh/fit.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"

/* The middle of the box around the mesh, and how far from there its farthest place is. */
static double extent(const struct mesh *mesh, double middle[3])
{
    double farthest = 0;
    for (int k = 0; k < 3; k++) {
        double low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            low = fmin(low, mesh->places[i][k]);
            high = fmax(high, mesh->places[i][k]);
        }
        middle[k] = (low + high) / 2;
    }
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += (mesh->places[i][k] - middle[k]) * (mesh->places[i][k] - middle[k]);
        farthest = fmax(farthest, sqrt(sum));
    }
    return farthest;
}

static void choose_unit(const struct mesh *mesh, double unit, struct fitted *fitted)
{
    const double size = extent(mesh, fitted->middle);
    fitted->unit = unit > 0 ? unit : 32767 / size;
    for (int k = 0; unit > 0 && k < 3; k++)
        fitted->middle[k] = 0;
    for (size_t i = 0; i < 3 * mesh->vertex_count; i++)
        if (fabs(mesh->places[i / 3][i % 3] - fitted->middle[i % 3]) * fitted->unit > 32767.5)
            fail("%s: with --unit %g places are beyond 32767; leave it out, or give a smaller one", mesh->name, unit);
}

static double held(double value, double most)
{
    return fmax(-most, fmin(most, round(value)));
}

struct fitted *mesh_fit(const struct mesh *mesh, double unit)
{
    struct fitted *fitted = allocate(1, sizeof *fitted);
    if (mesh->vertex_count > UINT16_MAX || mesh->face_count > GLINT_MESH_FACES_MAX)
        fail("%s: has %zu vertices and %zu triangles; at most %u and %u can be drawn: simplify the mesh", mesh->name,
             mesh->vertex_count, mesh->face_count, UINT16_MAX, GLINT_MESH_FACES_MAX);
    choose_unit(mesh, unit, fitted);
    fitted->places = allocate(mesh->vertex_count, sizeof *fitted->places);
    fitted->normals = allocate(mesh->vertex_count, sizeof *fitted->normals);
    fitted->normals8 = allocate(mesh->vertex_count, sizeof *fitted->normals8);
    fitted->faces = allocate(mesh->face_count, sizeof *fitted->faces);
    fitted->ends = allocate(mesh->part_count, sizeof *fitted->ends);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            fitted->places[i][k] = (int16_t)held((mesh->places[i][k] - fitted->middle[k]) * fitted->unit, 32767);
            fitted->normals[i][k] = (int16_t)held(mesh->normals[i][k] * 32768, 32767);
            fitted->normals8[i][k] = (int8_t)held(mesh->normals[i][k] * 127, 127);
        }
    for (size_t i = 0; i < 3 * mesh->face_count; i++)
        fitted->faces[i / 3][i % 3] = (uint16_t)mesh->faces[i / 3][i % 3];
    for (unsigned i = 0; i < mesh->part_count; i++)
        fitted->ends[i] = (uint16_t)mesh->ends[i];
    fitted->mesh = (struct glint_mesh){.places = fitted->places[0],
                                       .normals = fitted->normals[0],
                                       .normals8 = fitted->normals8[0],
                                       .faces = fitted->faces[0],
                                       .ends = fitted->ends,
                                       .vertex_count = (uint16_t)mesh->vertex_count,
                                       .face_count = (uint16_t)mesh->face_count,
                                       .part_count = (uint8_t)mesh->part_count};
    if (glint_mesh_check(&fitted->mesh) != GLINT_OK)
        fail("%s: the library refused the mesh", mesh->name);
    if (mesh->has_textures) /* after everything that may fail, since a failure is one line */
        warn("%s: texture coordinates are ignored: each part has one colour", mesh->name);
    return fitted;
}

void fitted_free(struct fitted *fitted)
{
    free(fitted->places);
    free(fitted->normals);
    free(fitted->normals8);
    free(fitted->faces);
    free(fitted->ends);
    free(fitted);
}

size_t fitted_bytes(const struct fitted *fitted, bool normals8)
{
    const size_t vertex = sizeof *fitted->places + (normals8 ? sizeof *fitted->normals8 : sizeof *fitted->normals);
    return fitted->mesh.vertex_count * vertex + fitted->mesh.face_count * sizeof *fitted->faces +
           (fitted->mesh.part_count > 1 ? 2u * fitted->mesh.part_count : 0);
}
