/* SPDX-License-Identifier: MIT */
#include "compare/mesh_scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "compare/mesh_raster.h"
#include "compare/reference.h"
#include "draw/mesh_canvas.h"
#include "image/format.h"

/* Each face's corners' normals, in the viewer's directions. */
static double (*turned_normals(const struct mesh *mesh, const struct view *view))[3]
{
    double(*normals)[3] = allocate(3 * mesh->face_count, sizeof *normals), m[3][3];
    view_rotation(view, m);
    for (size_t i = 0; i < 3 * mesh->face_count; i++)
        for (int k = 0; k < 3; k++)
            normals[i][k] = mesh_dot(m[k], mesh->normals[mesh->faces[i / 3][i % 3]]);
    return normals;
}

/* Each face's corners' places, as a scene's. */
static double (*corner_places(const struct mesh *mesh, const struct fitted *fitted, const struct view *view))[3]
{
    double(*corners)[3] = allocate(3 * mesh->face_count, sizeof *corners);
    double(*places)[3] = mesh_turned_places(mesh, fitted, view);
    for (size_t i = 0; i < 3 * mesh->face_count; i++) {
        const double *place = places[mesh->faces[i / 3][i % 3]];
        corners[i][0] = view->width / 2. + place[0];
        corners[i][1] = view->height / 2. - place[1];
        corners[i][2] = place[2];
    }
    free(places);
    return corners;
}

/* Of each pixel. */
static double (*places_of(const struct mesh *mesh, const struct fitted *fitted, const struct view *view))[3]
{
    double(*corners)[3] = corner_places(mesh, fitted, view);
    struct mesh_raster *raster = mesh_raster(mesh, fitted, view, corners);
    double(*places)[3] = raster->values;
    raster->values = NULL;
    mesh_raster_free(raster);
    free(corners);
    return places;
}

/* Each face's corners' colours, 0..1. */
static double (*corner_colors(const struct mesh *mesh))[3]
{
    double(*colors)[3] = allocate(3 * mesh->face_count, sizeof *colors);
    for (size_t i = 0; i < 3 * mesh->face_count; i++) {
        const uint8_t *color = mesh->colors[mesh->faces[i / 3][i % 3]];
        for (int k = 0; k < 3; k++)
            colors[i][k] = color[k] / 255.;
    }
    return colors;
}

/* Of each pixel. */
static uint8_t *albedo_of(const struct mesh *mesh, const struct fitted *fitted, const struct view *view)
{
    const size_t pixels = (size_t)view->width * view->height;
    uint8_t *albedo = allocate(pixels, 3);
    double(*colors)[3] = corner_colors(mesh);
    struct mesh_raster *raster = mesh_raster(mesh, fitted, view, colors);
    for (size_t i = 0; i < pixels; i++)
        for (int k = 0; k < 3; k++)
            albedo[3 * i + (size_t)k] = (uint8_t)lround(255 * raster->values[i][k]);
    mesh_raster_free(raster);
    free(colors);
    return albedo;
}

/* Each face's corners' places in its part's texture. */
static double (*corner_uv(const struct mesh *mesh))[3]
{
    double(*uv)[3] = allocate(3 * mesh->face_count, sizeof *uv);
    for (size_t i = 0; i < 3 * mesh->face_count; i++)
        memcpy(uv[i], mesh->uv[mesh->faces[i / 3][i % 3]], sizeof *mesh->uv);
    return uv;
}

/* The picture of the chain that the library takes: the first of less than two texels a pixel. */
static unsigned level_of(const struct glint_texture *texture, double (*corners)[3], double area)
{
    double p[2], q[2];
    unsigned level = 0;
    for (int k = 0; k < 2; k++) {
        p[k] = corners[1][k] - corners[0][k];
        q[k] = corners[2][k] - corners[0][k];
    }
    double texels = fabs(p[0] * q[1] - p[1] * q[0]) / 2 * texture->w * texture->h;
    while (level + 1u < texture->levels && texels >= 2 * area) {
        texels /= 4;
        level++;
    }
    return level;
}

/* In levels of 255. */
static void sample(const struct glint_texture *texture, unsigned level, const double uv[3], double rgb[3])
{
    uint32_t size[2];
    texture_size(texture, level, size);
    const double half = texture->is_smooth ? .5 : 0, x = uv[0] * size[0] - half, y = uv[1] * size[1] - half;
    const long left = (long)floor(x), top = (long)floor(y);
    if (!texture->is_smooth) {
        texture_color(texture, level, left, top, rgb);
        return;
    }
    memset(rgb, 0, 3 * sizeof *rgb);
    for (int i = 0; i < 4; i++) {
        double one[3];
        const double share =
            (i & 1 ? x - (double)left : 1 - x + (double)left) * (i & 2 ? y - (double)top : 1 - y + (double)top);
        texture_color(texture, level, left + (i & 1), top + (i >> 1), one);
        for (int k = 0; k < 3; k++)
            rgb[k] += share * one[k];
    }
}

/* Where a texture's pixel is that of a place in it; x and y of the texel. */
static uint32_t texel_at(const struct glint_texture *texture, unsigned level, const double uv[3])
{
    uint32_t size[2], at[2];
    texture_size(texture, level, size);
    for (int k = 0; k < 2; k++)
        at[k] = (uint32_t)((uv[k] - floor(uv[k])) * size[k]) % size[k];
    return mesh_texel(level, at[0], at[1]);
}

/* The albedo of each pixel; parts without a texture have the colour of their shading. Masks what shows another texel. */
static void set_textured(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                         const struct shading *shadings, struct scene *scene, struct mesh_coverage *coverage)
{
    const size_t pixels = (size_t)view->width * view->height;
    double(*corners)[3] = corner_uv(mesh);
    struct mesh_raster *raster = mesh_raster(mesh, fitted, view, corners);
    uint32_t *drawn = mesh_texels_drawn(fitted, view);
    scene->albedo = allocate(pixels, 3);
    for (size_t i = 0; i < pixels; i++) {
        if (!raster->numbers[i])
            continue;
        const size_t face = raster->numbers[i] - 1;
        const unsigned part = mesh_part_of(mesh, face);
        const struct glint_texture *texture = &fitted->mesh.textures[part];
        double rgb[3];
        for (int k = 0; k < 3; k++)
            rgb[k] = shadings[part].color[k];
        if (texture->pixels) {
            const unsigned level = level_of(texture, &corners[3 * face], raster->areas[face]);
            sample(texture, level, raster->values[i], rgb);
            if (!texture->is_smooth && scene->mask[i] && drawn[i] != texel_at(texture, level, raster->values[i])) {
                scene->mask[i] = 0;
                coverage->texels++;
            }
        }
        for (int k = 0; k < 3; k++)
            scene->albedo[3 * i + (size_t)k] = (uint8_t)lround(rgb[k]);
    }
    free(drawn);
    mesh_raster_free(raster);
    free(corners);
}

/* The axis of the grain, in the viewer's directions. */
static void set_grain(struct scene *scene, const struct fitted *fitted, const struct view *view)
{
    double m[3][3], axis[3];
    view_rotation(view, m);
    for (int k = 0; k < 3; k++)
        axis[k] = fitted->mesh.grain[k] / 32767.;
    for (int k = 0; k < 3; k++)
        scene->grain.at[k] = mesh_dot(m[k], axis);
}

struct scene *mesh_scene(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                         const struct shading *shadings, struct mesh_coverage *coverage)
{
    const size_t pixels = (size_t)view->width * view->height;
    double(*normals)[3] = turned_normals(mesh, view);
    struct mesh_raster *raster = mesh_raster(mesh, fitted, view, normals);
    uint32_t *drawn = mesh_faces_drawn(fitted, view);
    struct scene *scene = scene_new(view->width, view->height);
    scene->mask = allocate(pixels, 1);
    scene->parts = allocate(pixels, 1);
    scene->places = places_of(mesh, fitted, view);
    if (fitted->colors)
        scene->albedo = albedo_of(mesh, fitted, view);
    *coverage = (struct mesh_coverage){0};
    for (size_t i = 0; i < pixels; i++) {
        const uint32_t number = raster->numbers[i];
        coverage->drawn += number || drawn[i];
        coverage->different += number != drawn[i];
        scene->mask[i] = number && number == drawn[i] ? 255 : 0;
        if (number)
            scene->parts[i] = (uint8_t)mesh_part_of(mesh, number - 1);
        if (number && mesh_normalize(raster->values[i]))
            memcpy(scene->normals[i], raster->values[i], sizeof *scene->normals);
    }
    set_grain(scene, fitted, view);
    if (fitted->mesh.textures)
        set_textured(mesh, fitted, view, shadings, scene, coverage);
    free(drawn);
    mesh_raster_free(raster);
    free(normals);
    return scene;
}

/* The corners side by side are a scene of one line. */
struct levels *mesh_gouraud(const struct mesh *mesh, const struct fitted *fitted, const struct view *view,
                            const struct shading *shadings, const uint8_t *behind)
{
    const size_t corners = 3 * mesh->face_count, pixels = (size_t)view->width * view->height;
    const unsigned channels = format_channels(shadings->format);
    struct scene line = {.width = (uint32_t)corners,
                         .height = 1,
                         .normals = turned_normals(mesh, view),
                         .places = corner_places(mesh, fitted, view)};
    double *values = allocate(corners, channels * sizeof *values), (*colors)[3] = allocate(corners, sizeof *colors);
    uint8_t *black = behind ? NULL : allocate(view->height, format_line_bytes(shadings->format, view->width));
    struct levels *levels = levels_of_pixels(view->width, view->height, shadings->format, behind ? behind : black);
    set_grain(&line, fitted, view);
    line.parts = allocate(corners, 1);
    line.albedo = fitted->colors ? allocate(corners, 3) : NULL;
    for (size_t i = 0; i < corners; i++) {
        line.parts[i] = (uint8_t)mesh_part_of(mesh, i / 3);
        if (line.albedo)
            memcpy(&line.albedo[3 * i], fitted->colors[mesh->faces[i / 3][i % 3]], 3);
    }
    reference_line(&line, shadings, shadings->model, 0, values);
    for (size_t i = 0; i < corners * channels; i++)
        colors[i / channels][i % channels] = values[i];
    struct mesh_raster *raster = mesh_raster(mesh, fitted, view, colors);
    for (size_t i = 0; i < pixels * channels; i++) {
        const size_t at = i / channels;
        if (raster->numbers[at])
            levels->values[i] =
                (uint8_t)reference_level(fmax(0, fmin(1, raster->values[at][i % channels])), levels->max[i % channels],
                                         shadings->dither, (uint32_t)(at % view->width), (uint32_t)(at / view->width));
    }
    mesh_raster_free(raster);
    free(black);
    free(values);
    free(colors);
    free(line.normals);
    free(line.places);
    free(line.parts);
    free(line.albedo);
    return levels;
}
