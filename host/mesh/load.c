/* SPDX-License-Identifier: MIT */
#include "mesh/load.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "mesh/import.h"
#include "mesh/order.h"
#include "mesh/soup.h"
#include "mesh/split.h"
#include "mesh/surface.h"
#include "mesh/teapot_data.h"
#include "mesh/weld.h"

const char *const mesh_names[] = {"teapot", NULL};
const char *const mesh_axes_names[] = {"y-up", "z-up", NULL};

/* A picture four times around the axis, and once from the bottom to the top. Corners of a face are on one side of the seam. */
static void wrap_around(struct soup *soup)
{
    const double times = 4, height = 14, middle = -1.070312, top = 7;
    soup->has_uv = true;
    for (size_t i = 0; i < 3 * soup->face_count; i++) {
        struct soup_face *face = &soup->faces[i / 3];
        const double *place = face->places[i % 3];
        double turn = atan2(place[0] - middle, place[2]) / (2 * M_PI);
        if (i % 3)
            turn -= round(turn - face->uv[0][0] / times);
        face->uv[i % 3][0] = times * turn;
        face->uv[i % 3][1] = (top - place[1]) / height;
    }
}

static struct soup *teapot(void)
{
    struct soup *soup = allocate(1, sizeof *soup);
    *soup = (struct soup){.name = copied(mesh_names[0]), .face_count = TEAPOT_FACES, .part_count = 1};
    soup->materials = allocate(1, sizeof *soup->materials);
    *soup->materials = (struct mesh_material){.has_color = true, .color = {196, 98, 60}};
    soup->faces = allocate(TEAPOT_FACES, sizeof *soup->faces);
    for (int i = 0; i < 3 * TEAPOT_FACES; i++)
        memcpy(soup->faces[i / 3].places[i % 3], teapot_places[teapot_faces[i / 3][i % 3]], sizeof *teapot_places);
    wrap_around(soup);
    return soup;
}

/* x right, y to the back, z up becomes x right, y up, z to the viewer. */
static void stand_up(double v[3])
{
    const double back = v[1];
    v[1] = v[2];
    v[2] = -back;
}

static void exchange(double a[3], double b[3])
{
    double held[3];
    memcpy(held, a, sizeof held);
    memcpy(a, b, sizeof held);
    memcpy(b, held, sizeof held);
}

/* The other side of every face is the outside. Where the file's normals point to the inside now, all are turned; where it is only the
 * order of the corners that was wrong, they stay. */
static void flip(struct soup *soup)
{
    double agree = 0;
    for (size_t i = 0; i < soup->face_count; i++) {
        struct soup_face *face = &soup->faces[i];
        exchange(face->places[1], face->places[2]);
        exchange(face->normals[1], face->normals[2]);
        for (int k = 0; k < 3; k++) {
            const uint8_t color = face->colors[1][k];
            face->colors[1][k] = face->colors[2][k];
            face->colors[2][k] = color;
        }
        for (int k = 0; k < 2; k++) {
            const double at = face->uv[1][k];
            face->uv[1][k] = face->uv[2][k];
            face->uv[2][k] = at;
        }
        double outside[3];
        mesh_face_normal(face->places[0], face->places[1], face->places[2], outside);
        for (int j = 0; j < 3; j++)
            agree += mesh_dot(outside, face->normals[j]);
    }
    for (size_t i = 0; agree < 0 && i < 9 * soup->face_count; i++)
        soup->faces[i / 9].normals[i / 3 % 3][i % 3] *= -1;
}

/* Whose place is taken by those of the faces, as of those without a length. */
static void forget_odd_normals(struct soup *soup)
{
    for (size_t i = 0; i < 3 * soup->face_count; i++) {
        double *normal = soup->faces[i / 3].normals[i % 3];
        if (!(mesh_dot(normal, normal) < INFINITY))
            memset(normal, 0, sizeof soup->faces->normals[0]);
    }
}

static struct soup *read_file(const struct mesh_source *source)
{
    struct soup *soup = import_soup(source->name, !source->no_textures && !source->texture, source->allowed);
    const enum mesh_axes axes = source->axes != AXES_USUAL ? source->axes : soup->is_stl ? AXES_Z_UP : AXES_Y_UP;
    soup->has_normals &= !soup->is_stl;
    forget_odd_normals(soup);
    for (size_t i = 0; axes == AXES_Z_UP && i < 3 * soup->face_count; i++) {
        stand_up(soup->faces[i / 3].places[i % 3]);
        stand_up(soup->faces[i / 3].normals[i % 3]);
    }
    if (source->flipped)
        flip(soup);
    return soup;
}

struct mesh *mesh_load(const struct mesh_source *source)
{
    struct soup *soup = source->built_in ? teapot() : read_file(source);
    mesh_surface_begin(soup, source);
    struct mesh *mesh = mesh_weld(soup, source->built_in && source->crease < 0 ? 180 : source->crease);
    mesh_surface_end(mesh, soup, source);
    mesh->has_facet_colors = soup->has_facet_colors;
    soup_free(soup);
    const double degrees = source->split > 0 ? source->split : mesh->has_own_normals ? SPLIT_OWN : SPLIT_USUAL;
    if (!source->faces_most) {
        mesh_split(mesh, degrees);
    } else if (!mesh_split_within(mesh, degrees, source->faces_most)) {
        mesh_free(mesh);
        return NULL;
    }
    mesh_order(mesh);
    return mesh;
}
