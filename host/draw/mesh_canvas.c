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
    struct glint_paint *paints; /* of each part */
    struct glint_light lights[GLINT_LIGHTS_MAX];
    uint32_t (*memory)[GLINT_TABLES_DITHER_BYTES / 4]; /* of each part's tables; NULL: exact */
    const uint8_t *backdrop;                           /* or NULL */
};

struct shading *mesh_shadings(const struct mesh *mesh, const struct shading *shading, struct mesh_own own)
{
    struct shading *all = allocate(mesh->part_count, sizeof *all);
    for (unsigned i = 0; i < mesh->part_count; i++) {
        const struct mesh_material *material = &mesh->materials[i];
        all[i] = *shading;
        if (material->has_color && own.color)
            memcpy(all[i].color, material->color, sizeof all[i].color);
        if (material->n && own.n)
            all[i].n = material->n;
        if (own.look || material->unlit)
            mesh_material_look(material, all[i].ambient, all[i].diffuse, all[i].specular);
    }
    return all;
}

struct mesh_canvas *mesh_canvas_new(const struct fitted *fitted, const struct shading *shadings)
{
    struct mesh_canvas *canvas = allocate(1, sizeof *canvas);
    const unsigned count = fitted->mesh.part_count;
    struct mesh_path path;
    *canvas = (struct mesh_canvas){.mesh = fitted->mesh, .shadings = shadings};
    const char *name = path_names[shadings[0].path],
               *refusal = path_of_mesh(&shadings[0], fitted->colors || fitted->mesh.textures, &path);
    if (refusal)
        fail("--path %s: %s", name, refusal);
    if (path.normals8)
        canvas->mesh.normals = NULL;
    if (fitted->colors)
        canvas->mesh.of_vertices = fitted->colors[0];
    canvas->paints = allocate(count, sizeof *canvas->paints);
    if (path.by_tables)
        canvas->memory = allocate(count, sizeof *canvas->memory);
    for (unsigned i = 0; i < count; i++) {
        const struct glint_material material = shading_material(&shadings[i]);
        const struct glint_output output = shading_output(&shadings[i]);
        /* Of a textured mesh the other parts have one colour. */
        const bool is_plain = fitted->mesh.textures && !fitted->mesh.textures[i].pixels;
        const enum glint_tables_kind kind = is_plain ? GLINT_TABLES_COLOUR : path.kind;
        const enum glint_err error = path.by_tables ? glint_paint_tables(&canvas->paints[i], kind, &material, &output,
                                                                         canvas->memory[i], sizeof *canvas->memory)
                                                    : glint_paint_exact(&canvas->paints[i], &material, &output);
        if (error == GLINT_ERR_ARG && path.by_tables && path.kind == GLINT_TABLES_ALBEDO)
            fail("--path %s: %s", name, path_needs_grey);
        if (error != GLINT_OK)
            fail("--path %s: the library refused the material (error %d)", name, error);
    }
    return canvas;
}

void mesh_canvas_free(struct mesh_canvas *canvas)
{
    if (!canvas)
        return;
    free(canvas->paints);
    free(canvas->memory);
    free(canvas);
}

/* Some meshes, in one strip of the whole picture. */
static void draw(const struct glint_mesh *meshes, const struct glint_paint *const *paints, size_t count,
                 const struct view *view, uint8_t *pixels, size_t line_bytes)
{
    const uint16_t w = (uint16_t)view->width, h = (uint16_t)view->height;
    const size_t bytes = glint_mesh_frame_bytes(w, h) + GLINT_MESH_LIGHTS_BYTES;
    const struct glint_pose pose = view_pose(view);
    const struct glint_surface target = {pixels, (ptrdiff_t)line_bytes, 0, 0};
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn *drawn = allocate(count, sizeof *drawn);
    void *memory = allocate(bytes, 1), **works = allocate(count, sizeof *works);
    enum glint_err error = glint_mesh_begin(&frame, w, h, h, view_distance(view), memory, bytes);
    frame.outlines = &glint_outlines; /* of meshes that have neighbours */
    for (size_t i = 0; i < count && error == GLINT_OK; i++) {
        const size_t work = glint_mesh_bytes(&meshes[i], h);
        works[i] = allocate(work, 1);
        error = glint_mesh_add(&frame, &drawn[i], &meshes[i], &pose, paints[i], works[i], work);
    }
    if (error == GLINT_OK)
        error = glint_mesh_strip(&frame, 0, h, &target);
    for (size_t i = 0; i < count; i++)
        free(works[i]);
    free(works);
    free(memory);
    free(drawn);
    if (error != GLINT_OK)
        fail("the library refused the mesh (error %d)", error);
}

void mesh_canvas_set_backdrop(struct mesh_canvas *canvas, const uint8_t *pixels)
{
    canvas->backdrop = pixels;
}

void mesh_canvas_draw(struct mesh_canvas *canvas, const struct view *view, const struct shading *light, uint8_t *pixels)
{
    const struct shading *shading = &canvas->shadings[0];
    const struct glint_paint *paints = canvas->paints;
    const size_t line_bytes = format_line_bytes(shading->format, view->width);
    for (unsigned i = 0; i < canvas->mesh.part_count; i++)
        shading_light_paint(light ? light : shading, &canvas->paints[i], canvas->lights);
    if (canvas->backdrop)
        memcpy(pixels, canvas->backdrop, line_bytes * view->height);
    else
        memset(pixels, 0, line_bytes * view->height);
    draw(&canvas->mesh, &paints, 1, view, pixels, line_bytes);
}

void mesh_canvas_draw_stepped(struct mesh_canvas *canvas, const struct view *view, uint8_t *pixels)
{
    const uint16_t *const neighbours = canvas->mesh.neighbours;
    canvas->mesh.neighbours = NULL;
    mesh_canvas_draw(canvas, view, NULL, pixels);
    canvas->mesh.neighbours = neighbours;
}

/* Flat, in a colour that is the number. */
static void paint_number(struct glint_paint *paint, size_t number)
{
    static const struct glint_output output = {.format = GLINT_RGB888};
    static const int32_t to_viewer[3] = {0, 0, 1};
    struct glint_material material = {.model = GLINT_MSH, .n = 1};
    for (unsigned k = 0; k < 3; k++) {
        material.ambient_q16[k] = 65536;
        material.albedo[k] = (uint8_t)(number >> 8 * k);
    }
    enum glint_err error = glint_paint_exact(paint, &material, &output);
    if (error == GLINT_OK)
        error = glint_paint_light(paint, NULL, 0, to_viewer);
    if (error != GLINT_OK)
        fail("the library refused the numbers of faces (error %d)", error);
}

/* Each face is a part of its own, whose colour, drawn flat, is its number: 255 parts are a mesh. */
uint32_t *mesh_faces_drawn(const struct fitted *fitted, const struct view *view)
{
    enum { PARTS = 255 };
    const size_t faces = fitted->mesh.face_count, count = (faces + PARTS - 1) / PARTS,
                 pixels = (size_t)view->width * view->height;
    struct glint_mesh *meshes = allocate(count, sizeof *meshes);
    struct glint_paint *paints = allocate(faces, sizeof *paints);
    const struct glint_paint **first = allocate(count, sizeof *first);
    uint8_t *rgb = allocate(pixels, 3);
    uint32_t *numbers = allocate(pixels, sizeof *numbers);
    uint16_t ends[PARTS];
    for (unsigned i = 0; i < PARTS; i++)
        ends[i] = (uint16_t)(i + 1);
    for (size_t i = 0; i < count; i++) {
        const size_t left = faces - i * PARTS;
        first[i] = &paints[i * PARTS];
        meshes[i] = fitted->mesh;
        meshes[i].neighbours = NULL;
        meshes[i].faces = fitted->faces[i * PARTS];
        meshes[i].face_count = meshes[i].part_count = (uint8_t)(left < PARTS ? left : PARTS);
        meshes[i].ends = ends;
        meshes[i].textures = NULL;
    }
    for (size_t i = 0; i < faces; i++)
        paint_number(&paints[i], i + 1);
    draw(meshes, first, count, view, rgb, (size_t)3 * view->width);
    for (size_t i = 0; i < pixels; i++)
        numbers[i] = (uint32_t)(rgb[3 * i] | rgb[3 * i + 1] << 8 | rgb[3 * i + 2] << 16);
    free(meshes);
    free(paints);
    free(first);
    free(rgb);
    return numbers;
}

/* The texture's chain, where each pixel is the picture's number and its own x or y. */
static uint16_t *numbered(const struct glint_texture *texture, bool by_y)
{
    size_t count = 0;
    uint32_t size[2];
    for (unsigned level = 0; level < texture->levels; level++) {
        texture_size(texture, level, size);
        count += (size_t)size[0] * size[1];
    }
    uint16_t *numbers = allocate(count, sizeof *numbers), *to = numbers;
    for (unsigned level = 0; level < texture->levels; level++) {
        texture_size(texture, level, size);
        for (uint32_t i = 0; i < size[0] * size[1]; i++)
            *to++ = (uint16_t)(level << 11 | (by_y ? i / size[0] : i % size[0]));
    }
    return numbers;
}

/* The texture's place in the colour of each pixel: RGB565 has 16 bits, of which a light from everywhere changes none. */
static uint16_t *draw_numbers(const struct fitted *fitted, const struct view *view, bool by_y)
{
    static const struct glint_material flat = {.model = GLINT_MSH, .n = 1, .ambient_q16 = {65536, 65536, 65536}};
    static const struct glint_output output = {.format = GLINT_RGB565};
    static const int32_t to_viewer[3] = {0, 0, 1};
    const unsigned parts = fitted->mesh.part_count;
    struct glint_mesh mesh = fitted->mesh;
    struct glint_texture *textures = allocate(parts, sizeof *textures);
    struct glint_paint *paints = allocate(parts, sizeof *paints);
    uint16_t **numbers = allocate(parts, sizeof *numbers);
    uint16_t *pixels = allocate((size_t)view->width * view->height, sizeof *pixels);
    enum glint_err error = GLINT_OK;
    for (unsigned i = 0; i < parts; i++) {
        textures[i] = mesh.textures[i];
        textures[i].palette = NULL;
        textures[i].is_smooth = false;
        if (textures[i].pixels)
            textures[i].pixels = numbers[i] = numbered(&textures[i], by_y);
        if (error == GLINT_OK)
            error = glint_paint_exact(&paints[i], &flat, &output);
        if (error == GLINT_OK)
            error = glint_paint_light(&paints[i], NULL, 0, to_viewer);
    }
    if (error != GLINT_OK)
        fail("the library refused the numbers of texels (error %d)", error);
    mesh.textures = textures;
    mesh.neighbours = NULL; /* outlines blend */
    draw(&mesh, (const struct glint_paint *const[]){paints}, 1, view, (uint8_t *)pixels,
         (size_t)view->width * sizeof *pixels);
    for (unsigned i = 0; i < parts; i++)
        free(numbers[i]);
    free(numbers);
    free(textures);
    free(paints);
    return pixels;
}

uint32_t *mesh_texels_drawn(const struct fitted *fitted, const struct view *view)
{
    const size_t pixels = (size_t)view->width * view->height;
    uint16_t *xs = draw_numbers(fitted, view, false), *ys = draw_numbers(fitted, view, true);
    uint32_t *texels = allocate(pixels, sizeof *texels);
    for (size_t i = 0; i < pixels; i++)
        texels[i] = mesh_texel(xs[i] >> 11, xs[i] & 2047, ys[i] & 2047);
    free(xs);
    free(ys);
    return texels;
}
