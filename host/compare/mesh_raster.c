/* SPDX-License-Identifier: MIT
 * Each triangle is tried at every pixel of the box around it, by the signs of three areas. */
#include "compare/mesh_raster.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"

/* On the screen, in pixels from its middle, y up; `near` is larger for what is nearer, and linear on the screen. */
struct corner {
    double x, y, near, weight;
};

double (*mesh_turned_places(const struct mesh *mesh, const struct fitted *fitted, const struct view *view))[3]
{
    double(*places)[3] = allocate(mesh->vertex_count, sizeof *places), m[3][3];
    view_rotation(view, m);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = (mesh->places[i][k] - fitted->middle[k]) * fitted->unit / 32767 * view_radius(view);
        for (int k = 0; k < 3; k++)
            places[i][k] = mesh_dot(m[k], at);
    }
    return places;
}

static void project(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                    struct corner *corners)
{
    const double distance = view_radius(view) * view->distance;
    double(*places)[3] = mesh_turned_places(mesh, fitted, view);
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        const double *at = places[i], r = distance > 0 ? distance / (distance - at[2]) : 1;
        corners[i] = (struct corner){at[0] * r, at[1] * r, distance > 0 ? r : at[2], r};
    }
    free(places);
}

static double area(const struct corner *a, const struct corner *b, double x, double y)
{
    return (b->x - a->x) * (y - a->y) - (b->y - a->y) * (x - a->x);
}

struct target {
    const struct mesh *mesh;
    const struct view *view;
    double (*corners)[3]; /* of each face three */
    struct mesh_raster *raster;
    double *near; /* of what each pixel shows */
};

/* The middle of pixel x, y, if the triangle is in front there: `part` are its shares of the corners. */
static void draw_pixel(struct target *t, uint32_t face, const struct corner *const c[3], uint32_t x, uint32_t y,
                       const double part[3])
{
    const size_t i = (size_t)y * t->view->width + x;
    double near = 0, weight = 0, *value = t->raster->values[i];
    for (int k = 0; k < 3; k++) {
        near += part[k] * c[k]->near;
        weight += part[k] * c[k]->weight;
    }
    if (t->raster->numbers[i] && near <= t->near[i])
        return;
    t->near[i] = near;
    t->raster->numbers[i] = face + 1;
    for (int j = 0; j < 3; j++) {
        value[j] = 0;
        for (int k = 0; k < 3; k++)
            value[j] += part[k] * c[k]->weight / weight * t->corners[3 * face + (uint32_t)k][j];
    }
}

static void draw_face(struct target *t, uint32_t face, const struct corner *corners)
{
    const uint32_t *vertices = t->mesh->faces[face];
    const struct corner *const c[3] = {&corners[vertices[0]], &corners[vertices[1]], &corners[vertices[2]]};
    const double all = area(c[0], c[1], c[2]->x, c[2]->y), w = t->view->width, h = t->view->height;
    t->raster->areas[face] = fabs(all) / 2;
    if (all <= 0)
        return; /* seen from behind */
    const double left = fmin(c[0]->x, fmin(c[1]->x, c[2]->x)), right = fmax(c[0]->x, fmax(c[1]->x, c[2]->x));
    const double low = fmin(c[0]->y, fmin(c[1]->y, c[2]->y)), high = fmax(c[0]->y, fmax(c[1]->y, c[2]->y));
    const double x_end = fmin(w, right + w / 2), y_end = fmin(h, h / 2 - low);
    const size_t pixels_before = t->raster->pixels;
    for (double y = fmax(0, floor(h / 2 - high)); y < y_end; y++) {
        const size_t line_before = t->raster->pixels;
        for (double x = fmax(0, floor(left + w / 2)); x < x_end; x++) {
            const double at_x = x + .5 - w / 2, at_y = h / 2 - (y + .5);
            double part[3];
            for (int k = 0; k < 3; k++)
                part[k] = area(c[(k + 1) % 3], c[(k + 2) % 3], at_x, at_y) / all;
            if (part[0] < 0 || part[1] < 0 || part[2] < 0)
                continue;
            t->raster->pixels++;
            draw_pixel(t, face, c, (uint32_t)x, (uint32_t)y, part);
        }
        t->raster->lines += t->raster->pixels > line_before;
    }
    t->raster->faces += t->raster->pixels > pixels_before;
}

struct mesh_raster *mesh_raster(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                                double (*corners)[3])
{
    const size_t pixels = (size_t)view->width * view->height;
    struct mesh_raster *raster = allocate(1, sizeof *raster);
    raster->values = allocate(pixels, sizeof *raster->values);
    raster->numbers = allocate(pixels, sizeof *raster->numbers);
    raster->areas = allocate(mesh->face_count, sizeof *raster->areas);
    struct corner *projected = allocate(mesh->vertex_count, sizeof *projected);
    struct target target = {mesh, view, corners, raster, allocate(pixels, sizeof *target.near)};
    project(mesh, fitted, view, projected);
    for (uint32_t i = 0; i < mesh->face_count; i++)
        draw_face(&target, i, projected);
    free(projected);
    free(target.near);
    return raster;
}

void mesh_raster_free(struct mesh_raster *raster)
{
    free(raster->values);
    free(raster->numbers);
    free(raster->areas);
    free(raster);
}
