/* SPDX-License-Identifier: MIT */
#include "mesh/fit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "mesh/neighbours.h"

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

/* The volume that the triangles enclose, as seen from outside, in radii of a ball around them; of a ball 4.2. */
static double volume(const struct fitted *fitted)
{
    double sum = 0;
    for (size_t i = 0; i < fitted->mesh.face_count; i++) {
        double corner[3][3], normal[3];
        for (int k = 0; k < 9; k++)
            corner[k / 3][k % 3] = fitted->places[fitted->faces[i][k / 3]][k % 3] / 32767.;
        mesh_cross(corner[1], corner[2], normal);
        sum += mesh_dot(corner[0], normal) / 6;
    }
    return sum;
}

/* After everything that may fail, since a failure is one line. */
static void say_what_looks_wrong(const struct mesh *mesh, const struct fitted *fitted, double unit)
{
    if (mesh->has_facet_colors)
        warn("%s: an STL's colours are ignored: each part has one colour", mesh->name);
    if (!(unit > 0) && volume(fitted) < -.05)
        warn("%s: most triangles seem to face inwards, and only those that face the viewer are drawn; --flip-faces "
             "turns them",
             mesh->name);
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

/* The mean of |N|^2 over a triangle: that of (1 + (i == j)) Ni.Nj / 12 over all pairs of corners. */
static double mean_square(const struct mesh *mesh, const double *length, const uint32_t face[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            sum += (i == j ? 2 : 1) * length[face[i]] * length[face[j]] *
                   mesh_dot(mesh->normals[face[i]], mesh->normals[face[j]]) / 12;
    return sum;
}

/* How much longer than 1 each vertex's normal is made: between unit normals the interpolated one is shorter, and with it the diffuse
 * light. Each is divided by the root of its triangles' mean square, again and again, which brings these to 1; it may be no
 * longer than leaves each of its three parts below 1. Peaks lose nothing: t errs by the square of what |N| does. */
static double *lengths(const struct mesh *mesh)
{
    enum { ROUNDS = 4 };
    double *length = allocate(mesh->vertex_count, sizeof *length), (*sums)[2];
    for (size_t i = 0; i < mesh->vertex_count; i++)
        length[i] = 1;
    for (int round = 0; round < ROUNDS; round++) {
        sums = allocate(mesh->vertex_count, sizeof *sums); /* of squares times areas, of areas */
        for (size_t i = 0; i < mesh->face_count; i++) {
            const uint32_t *face = mesh->faces[i];
            double normal[3];
            mesh_face_normal(mesh->places[face[0]], mesh->places[face[1]], mesh->places[face[2]], normal);
            const double area = sqrt(mesh_dot(normal, normal)), square = mean_square(mesh, length, face);
            for (int k = 0; k < 3; k++) {
                sums[face[k]][0] += area * square;
                sums[face[k]][1] += area;
            }
        }
        for (size_t i = 0; i < mesh->vertex_count; i++) {
            const double *n = mesh->normals[i], most = fmax(fabs(n[0]), fmax(fabs(n[1]), fabs(n[2])));
            if (sums[i][0] > 0)
                length[i] = fmin(length[i] * sqrt(sums[i][1] / sums[i][0]), 1 / most);
        }
        free(sums);
    }
    return length;
}

static double held(double value, double most)
{
    return fmax(-most, fmin(most, round(value)));
}

/* As fine as fits the largest of them: 1.0 is 2^uv_bits. */
static void fit_uv(const struct mesh *mesh, struct fitted *fitted)
{
    enum { BITS_MIN = 8, BITS_MAX = 15 };
    double most = 0;
    unsigned bits = BITS_MAX;
    for (size_t i = 0; i < 2 * mesh->vertex_count; i++)
        most = fmax(most, mesh->uv[i / 2][i % 2]);
    while (bits > BITS_MIN && round(ldexp(most, (int)bits)) > UINT16_MAX)
        bits--;
    if (round(ldexp(most, (int)bits)) > UINT16_MAX)
        fail("%s: a texture repeats more than 255 times over a part that hangs together; let it repeat less, or give "
             "--no-textures",
             mesh->name);
    fitted->uv = allocate(mesh->vertex_count, sizeof *fitted->uv);
    for (size_t i = 0; i < 2 * mesh->vertex_count; i++)
        fitted->uv[i / 2][i % 2] = (uint16_t)fmax(0, round(ldexp(mesh->uv[i / 2][i % 2], (int)bits)));
    fitted->mesh.uv = fitted->uv[0];
    fitted->mesh.uv_bits = (uint8_t)bits;
}

static void fit_textures(const struct mesh *mesh, struct fitted *fitted)
{
    bool *is_used = allocate(mesh->picture_count, sizeof *is_used), any = false;
    for (unsigned i = 0; i < mesh->part_count; i++)
        if (mesh->materials[i].picture)
            is_used[mesh->materials[i].picture - 1] = any = true;
    if (any) {
        fit_uv(mesh, fitted);
        fitted->texture_count = mesh->picture_count;
        fitted->textures = textures_of(mesh, is_used);
        fitted->of_parts = allocate(mesh->part_count, sizeof *fitted->of_parts);
        fitted->mesh.textures = fitted->of_parts;
    }
    for (unsigned i = 0; i < mesh->part_count && any; i++) {
        const struct mesh_material *material = &mesh->materials[i];
        if (!material->picture)
            continue;
        fitted->of_parts[i] = fitted->textures[material->picture - 1].texture;
        fitted->of_parts[i].is_smooth = mesh->wish.is_smooth || !(mesh->wish.is_nearest || material->is_nearest);
    }
    free(is_used);
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
    double *length = lengths(mesh);
    for (size_t i = 0; i < mesh->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            fitted->places[i][k] = (int16_t)held((mesh->places[i][k] - fitted->middle[k]) * fitted->unit, 32767);
            fitted->normals[i][k] = (int16_t)held(mesh->normals[i][k] * length[i] * 32768, 32767);
            fitted->normals8[i][k] = (int8_t)held(mesh->normals[i][k] * length[i] * 127, 127);
        }
    free(length);
    if (mesh->colors) {
        fitted->colors = allocate(mesh->vertex_count, sizeof *fitted->colors);
        memcpy(fitted->colors, mesh->colors, mesh->vertex_count * sizeof *fitted->colors);
    }
    for (size_t i = 0; i < 3 * mesh->face_count; i++)
        fitted->faces[i / 3][i % 3] = (uint16_t)mesh->faces[i / 3][i % 3];
    for (unsigned i = 0; i < mesh->part_count; i++)
        fitted->ends[i] = (uint16_t)mesh->ends[i];
    fitted->neighbours = mesh_neighbours(mesh);
    fitted->mesh = (struct glint_mesh){.places = fitted->places[0],
                                       .normals = fitted->normals[0],
                                       .normals8 = fitted->normals8[0],
                                       .faces = fitted->faces[0],
                                       .ends = fitted->ends,
                                       .neighbours = fitted->neighbours[0],
                                       .vertex_count = (uint16_t)mesh->vertex_count,
                                       .face_count = (uint16_t)mesh->face_count,
                                       .part_count = (uint8_t)mesh->part_count,
                                       .use = &glint_use_mesh_albedo};
    if (mesh->uv)
        fit_textures(mesh, fitted);
    if (glint_mesh_check(&fitted->mesh) != GLINT_OK)
        fail("%s: the library refused the mesh", mesh->name);
    say_what_looks_wrong(mesh, fitted, unit);
    return fitted;
}

void fitted_forget_colors(struct fitted *fitted)
{
    free(fitted->colors);
    fitted->colors = NULL;
    fitted->mesh.textures = NULL;
    fitted->mesh.uv = NULL;
    fitted->mesh.uv_bits = 0;
}

void fitted_forget_neighbours(struct fitted *fitted)
{
    free(fitted->neighbours);
    fitted->neighbours = NULL;
    fitted->mesh.neighbours = NULL;
}

void fitted_free(struct fitted *fitted)
{
    if (!fitted)
        return;
    free(fitted->neighbours);
    free(fitted->uv);
    free(fitted->of_parts);
    textures_free(fitted->textures, fitted->texture_count);
    free(fitted->colors);
    free(fitted->places);
    free(fitted->normals);
    free(fitted->normals8);
    free(fitted->faces);
    free(fitted->ends);
    free(fitted);
}

size_t fitted_texture_bytes(const struct fitted *fitted)
{
    size_t sum = 0;
    for (unsigned i = 0; i < fitted->texture_count && fitted->mesh.textures; i++)
        if (fitted->textures[i].name)
            sum += texture_bytes(&fitted->textures[i]);
    return sum;
}

static size_t bytes_of(const struct fitted *fitted, bool normals8, size_t vertices, size_t faces)
{
    const size_t vertex = sizeof *fitted->places + (normals8 ? sizeof *fitted->normals8 : sizeof *fitted->normals) +
                          (fitted->colors ? sizeof *fitted->colors : 0) +
                          (fitted->mesh.textures ? sizeof *fitted->uv : 0);
    const size_t face = sizeof *fitted->faces + (fitted->neighbours ? sizeof *fitted->neighbours : 0);
    return vertices * vertex + faces * face + (fitted->mesh.part_count > 1 ? 2u * fitted->mesh.part_count : 0) +
           fitted_texture_bytes(fitted);
}

size_t fitted_bytes(const struct fitted *fitted, bool normals8)
{
    return bytes_of(fitted, normals8, fitted->mesh.vertex_count, fitted->mesh.face_count);
}

size_t fitted_whole_bytes(const struct fitted *fitted, const struct mesh *mesh, bool normals8)
{
    return bytes_of(fitted, normals8, mesh->whole_vertex_count, mesh->whole_face_count);
}
