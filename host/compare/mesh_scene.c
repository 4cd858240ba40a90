/* SPDX-License-Identifier: MIT
 * Each triangle is tried at every pixel of the box around it, by the signs of three areas. Nothing of the library's rounding is in
 * it: places and normals are those before they were fitted. */
#include "compare/mesh_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "draw/mesh_canvas.h"

/* On the screen, in pixels from its middle, y up; `near` is larger for what is nearer, and linear on the screen. */
struct corner {
    double x, y, near, weight;
};

static void project(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                    struct corner *corners)
{
    const double radius = view_radius(view), distance = radius * view->distance;
    double m[3][3];
    view_rotation(view, m);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = (mesh->places[i][k] - fitted->middle[k]) * fitted->unit / 32767 * radius;
        const double x = mesh_dot(m[0], at), y = mesh_dot(m[1], at), z = mesh_dot(m[2], at);
        const double r = distance > 0 ? distance / (distance - z) : 1;
        corners[i] = (struct corner){x * r, y * r, distance > 0 ? r : z, r};
    }
}

static double area(const struct corner *a, const struct corner *b, double x, double y)
{
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

struct target {
    const struct mesh *mesh;
    const struct view *view;
    struct scene *scene;
    double *near;     /* of what each pixel shows */
    uint32_t *number; /* of its face, plus 1 */
};

/* The middle of pixel x, y, if the triangle is in front there: `part` are its shares of the corners. */
static void draw_pixel(struct target *t, uint32_t face, const struct corner *const c[3], uint32_t x, uint32_t y,
                       const double part[3])
{
    const size_t i = (size_t)y * t->view->width + x;
    const uint32_t *vertices = t->mesh->faces[face];
    double near = 0, normal[3] = {0, 0, 0};
    for (int k = 0; k < 3; k++)
        near += part[k] * c[k]->near;
    if (t->number[i] && near <= t->near[i])
        return;
    for (int k = 0; k < 3; k++)
        for (int j = 0; j < 3; j++)
            normal[j] += part[k] * c[k]->weight * t->mesh->normals[vertices[k]][j];
    t->near[i] = near;
    t->number[i] = face + 1;
    memcpy(t->scene->normals[i], normal, sizeof normal);
}

static void draw_face(struct target *t, uint32_t face, const struct corner *corners)
{
    const uint32_t *vertices = t->mesh->faces[face];
    const struct corner *const c[3] = {&corners[vertices[0]], &corners[vertices[1]], &corners[vertices[2]]};
    const double all = area(c[0], c[1], c[2]->x, c[2]->y), w = t->view->width, h = t->view->height;
    if (all <= 0)
        return; /* seen from behind */
    const double left = fmin(c[0]->x, fmin(c[1]->x, c[2]->x)), right = fmax(c[0]->x, fmax(c[1]->x, c[2]->x));
    const double low = fmin(c[0]->y, fmin(c[1]->y, c[2]->y)), high = fmax(c[0]->y, fmax(c[1]->y, c[2]->y));
    const double x_end = fmin(w, right + w / 2), y_end = fmin(h, h / 2 - low);
    for (double y = fmax(0, floor(h / 2 - high)); y < y_end; y++)
        for (double x = fmax(0, floor(left + w / 2)); x < x_end; x++) {
            const double at_x = x + .5 - w / 2, at_y = h / 2 - (y + .5);
            double part[3];
            for (int k = 0; k < 3; k++)
                part[k] = area(c[(k + 1) % 3], c[(k + 2) % 3], at_x, at_y) / all;
            if (part[0] >= 0 && part[1] >= 0 && part[2] >= 0)
                draw_pixel(t, face, c, (uint32_t)x, (uint32_t)y, part);
        }
}

/* Normals to the viewer's directions; the mask, and what of it differs from the library's picture. */
static void finish(struct target *t, const uint32_t *drawn, struct mesh_coverage *coverage)
{
    const size_t pixels = (size_t)t->view->width * t->view->height;
    double m[3][3];
    view_rotation(t->view, m);
    *coverage = (struct mesh_coverage){0, 0};
    for (size_t i = 0; i < pixels; i++) {
        double *normal = t->scene->normals[i], turned[3];
        coverage->drawn += t->number[i] || drawn[i];
        coverage->different += t->number[i] != drawn[i];
        t->scene->mask[i] = t->number[i] && t->number[i] == drawn[i];
        if (!t->number[i])
            continue;
        t->scene->parts[i] = (uint8_t)mesh_part_of(t->mesh, t->number[i] - 1);
        for (int k = 0; k < 3; k++)
            turned[k] = mesh_dot(m[k], normal);
        if (mesh_normalize(turned))
            memcpy(normal, turned, sizeof turned);
    }
}

struct scene *mesh_scene(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                         struct mesh_coverage *coverage)
{
    const size_t pixels = (size_t)view->width * view->height;
    struct target target = {mesh, view, scene_new(view->width, view->height), allocate(pixels, sizeof *target.near),
                            allocate(pixels, sizeof *target.number)};
    struct corner *corners = allocate(mesh->vertex_count, sizeof *corners);
    target.scene->mask = allocate(pixels, 1);
    target.scene->parts = allocate(pixels, 1);
    project(mesh, fitted, view, corners);
    for (uint32_t i = 0; i < mesh->face_count; i++)
        draw_face(&target, i, corners);
    uint32_t *drawn = mesh_faces_drawn(fitted, view);
    finish(&target, drawn, coverage);
    free(drawn);
    free(corners);
    free(target.near);
    free(target.number);
    return target.scene;
}
