/* SPDX-License-Identifier: MIT */
#include "draw/mesh_canvas.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "draw/paths.h"
#include "image/format.h"

struct mesh_canvas {
    struct glint_mesh mesh;
    const struct shading *shadings;
    struct glint_paint *paints;        /* of each part */
    struct glint_mesh_albedo *albedos; /* for colours of vertices */
    struct glint_prepared *prepared;
    struct glint_tables *tables;
    uint32_t (*memory)[GLINT_TABLES_DITHER_BYTES / 4];
};

struct shading *mesh_shadings(const struct mesh *mesh, const struct shading *shading, bool own_color, bool own_n)
{
    struct shading *all = allocate(mesh->part_count, sizeof *all);
    for (unsigned i = 0; i < mesh->part_count; i++) {
        const struct mesh_material *material = &mesh->materials[i];
        all[i] = *shading;
        if (material->has_color && own_color)
            memcpy(all[i].color, material->color, sizeof all[i].color);
        if (material->n && own_n)
            all[i].n = material->n;
        for (unsigned k = 0; material->unlit && k < 3; k++) {
            all[i].ambient[k] = 1;
            all[i].diffuse[k] = all[i].specular[k] = 0;
        }
    }
    return all;
}

struct mesh_canvas *mesh_canvas_new(const struct fitted *fitted, const struct shading *shadings)
{
    struct mesh_canvas *canvas = allocate(1, sizeof *canvas);
    const unsigned count = fitted->mesh.part_count;
    struct mesh_path path;
    *canvas = (struct mesh_canvas){.mesh = fitted->mesh, .shadings = shadings};
    canvas->paints = allocate(count, sizeof *canvas->paints);
    canvas->albedos = allocate(count, sizeof *canvas->albedos);
    canvas->prepared = allocate(count, sizeof *canvas->prepared);
    canvas->tables = allocate(count, sizeof *canvas->tables);
    canvas->memory = allocate(count, sizeof *canvas->memory);
    const char *refusal = path_of_mesh(&shadings[0], fitted->colors != NULL, &path);
    if (refusal)
        fail("--path %s: %s", path_names[shadings[0].path], refusal);
    if (path.normals8)
        canvas->mesh.normals = NULL;
    for (unsigned i = 0; i < count; i++) {
        const struct glint_shader shader = shading_shader(&shadings[i]);
        const void *with = path.by_tables ? (const void *)&canvas->tables[i] : (const void *)&canvas->prepared[i];
        const enum glint_err error = path.by_tables ? glint_tables_fill(&canvas->tables[i], path.kind, &shader,
                                                                        canvas->memory[i], sizeof *canvas->memory)
                                                    : glint_shade_prepare(&canvas->prepared[i], &shader);
        if (error == GLINT_ERR_ARG && path.kind == GLINT_TABLES_ALBEDO)
            fail("--path %s: %s", path_names[shadings[0].path], path_needs_grey);
        if (error != GLINT_OK)
            fail("--path %s: the library refused the material (error %d)", path_names[shadings[0].path], error);
        canvas->paints[i] = (struct glint_paint){path.by_tables ? &glint_mesh_tables : &glint_mesh_exact, with};
        if (!fitted->colors)
            continue;
        canvas->albedos[i] = (struct glint_mesh_albedo){with, fitted->colors[0], NULL};
        canvas->paints[i] = (struct glint_paint){path.by_tables ? &glint_mesh_tables_albedo : &glint_mesh_exact_albedo,
                                                 &canvas->albedos[i]};
    }
    return canvas;
}

void mesh_canvas_free(struct mesh_canvas *canvas)
{
    if (!canvas)
        return;
    free(canvas->paints);
    free(canvas->albedos);
    free(canvas->prepared);
    free(canvas->tables);
    free(canvas->memory);
    free(canvas);
}

/* Some meshes, in one strip of the whole picture. */
static void draw(const struct glint_mesh *meshes, const struct glint_paint *const *paints, size_t count,
                 const struct view *view, const struct glint_light *light, uint8_t *pixels, size_t line_bytes)
{
    const uint16_t w = (uint16_t)view->width, h = (uint16_t)view->height;
    const size_t bytes = glint_mesh_frame_bytes(w, h);
    const struct glint_pose pose = view_pose(view);
    const struct glint_surface surface = {pixels, (ptrdiff_t)line_bytes, 0, 0};
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn *drawn = allocate(count, sizeof *drawn);
    void *memory = allocate(bytes, 1), **works = allocate(count, sizeof *works);
    enum glint_err error = glint_mesh_begin(&frame, w, h, h, view_distance(view), memory, bytes);
    for (size_t i = 0; i < count && error == GLINT_OK; i++) {
        const size_t work = glint_mesh_bytes(&meshes[i], h);
        works[i] = allocate(work, 1);
        error = glint_mesh_add(&frame, &drawn[i], &meshes[i], &pose, light, paints[i], works[i], work);
    }
    if (error == GLINT_OK)
        error = glint_mesh_strip(&frame, 0, h, &surface);
    for (size_t i = 0; i < count; i++)
        free(works[i]);
    free(works);
    free(memory);
    free(drawn);
    if (error != GLINT_OK)
        fail("the library refused the mesh (error %d)", error);
}

void mesh_canvas_draw(const struct mesh_canvas *canvas, const struct view *view, const struct shading *light,
                      uint8_t *pixels)
{
    const struct shading *shading = &canvas->shadings[0];
    const struct glint_light towards = shading_shader(light ? light : shading).light;
    const struct glint_paint *paints = canvas->paints;
    const size_t line_bytes = format_line_bytes(shading->format, view->width);
    memset(pixels, 0, line_bytes * view->height);
    draw(&canvas->mesh, &paints, 1, view, &towards, pixels, line_bytes);
}

/* Each face is a part of its own, whose colour, drawn flat, is its number: 255 parts are a mesh. */
uint32_t *mesh_faces_drawn(const struct fitted *fitted, const struct view *view)
{
    enum { PARTS = 255 };
    const size_t faces = fitted->mesh.face_count, count = (faces + PARTS - 1) / PARTS,
                 pixels = (size_t)view->width * view->height;
    struct glint_mesh *meshes = allocate(count, sizeof *meshes);
    struct glint_prepared *prepared = allocate(faces, sizeof *prepared);
    struct glint_paint *paints = allocate(faces, sizeof *paints);
    const struct glint_paint **first = allocate(count, sizeof *first);
    static const struct glint_light light = {.l = {0, 0, 32767}, .v = {0, 0, 32767}, .h = {0, 0, 32767}};
    uint8_t *rgb = allocate(pixels, 3);
    uint32_t *numbers = allocate(pixels, sizeof *numbers);
    uint16_t ends[PARTS];
    for (unsigned i = 0; i < PARTS; i++)
        ends[i] = (uint16_t)(i + 1);
    for (size_t i = 0; i < count; i++) {
        const size_t left = faces - i * PARTS;
        first[i] = &paints[i * PARTS];
        meshes[i] = fitted->mesh;
        meshes[i].faces = fitted->faces[i * PARTS];
        meshes[i].face_count = meshes[i].part_count = (uint8_t)(left < PARTS ? left : PARTS);
        meshes[i].ends = ends;
    }
    for (size_t i = 0; i < faces; i++) {
        const size_t number = i + 1;
        struct glint_shader shader = {.light = light, .format = GLINT_RGB888, .space = GLINT_GAMMA};
        glint_lobe_init(&shader.lobe, GLINT_MSH, 1, 0);
        for (unsigned k = 0; k < 3; k++) {
            shader.material.ambient_q16[k] = 65536;
            shader.material.albedo[k] = (uint8_t)(number >> 8 * k);
        }
        if (glint_shade_prepare(&prepared[i], &shader) != GLINT_OK)
            fail("the library refused the numbers of faces");
        paints[i] = (struct glint_paint){&glint_mesh_exact, &prepared[i]};
    }
    draw(meshes, first, count, view, &light, rgb, (size_t)3 * view->width);
    for (size_t i = 0; i < pixels; i++)
        numbers[i] = (uint32_t)(rgb[3 * i] | rgb[3 * i + 1] << 8 | rgb[3 * i + 2] << 16);
    free(meshes);
    free(prepared);
    free(paints);
    free(first);
    free(rgb);
    return numbers;
}
