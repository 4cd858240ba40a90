/* SPDX-License-Identifier: MIT
 * Meshes of random faces, most of which are in the picture: parallel and in perspective, clipped, in strips. */
#include "conformance_meshes.h"

#include "conformance_random.h"
#include "conformance_scenes.h"
#include "conformance_tables.h"

#if !CONFORMANCE_MODELS_ONLY

enum {
    VERTICES = CONFORM_VERTICES,
    FACES = CONFORM_FACES,
    WIDTH = CONFORM_WIDTH,
    HEIGHT = 9,
    STRIP = 5,
    MEMORY = 1320 /* four triangles that go on have places */
};
typedef char conform_mesh_fits[CONFORM_PIXELS == WIDTH * HEIGHT ? 1 : -1];
static int16_t places[3 * VERTICES], normals[3 * VERTICES];
static uint16_t faces[3 * FACES], neighbours[3 * FACES], uv[2 * VERTICES];

static int16_t any_q15(int32_t limit)
{
    return (int16_t)conform_random_within(limit);
}

/* 0: as random as can be; else normals and a size as people have them. */
static void random_mesh(struct glint_pose *pose, unsigned kind, const struct glint_vec *h)
{
    for (uint8_t i = 0; i < VERTICES; i++) {
        struct glint_vec normal;
        conform_random_normal(&normal, h);
        normals[3 * i] = normal.x;
        normals[3 * i + 1] = normal.y;
        normals[3 * i + 2] = normal.z;
        for (uint8_t k = 0; k < 3; k++)
            places[3 * i + k] = any_q15(32767);
    }
    for (uint8_t i = 0; i < 3 * FACES; i++)
        faces[i] = (uint16_t)(conform_random_bits() % VERTICES);
    for (uint8_t k = 0; k < 4; k++)
        pose->turn[k] = any_q15(32767);
    pose->turn[0] |= 1;
    for (uint8_t k = 0; k < 3; k++)
        pose->position[k] = any_q15(kind ? 60 : 32767);
    pose->scale = (uint16_t)(conform_random_bits() % (kind ? 500u : 65536u));
}

/* Of faces that do not meet: any, rims and seams. */
static void random_neighbours(void)
{
    for (uint8_t i = 0; i < 3 * FACES; i++) {
        const uint16_t number = (uint16_t)(conform_random_bits() % (FACES + 5));
        neighbours[i] = (uint16_t)(number < FACES ? number : number < FACES + 4 ? GLINT_MESH_RIM : GLINT_MESH_SEAM);
    }
}

/* Draws it in strips over numbers, lines of `stride` bytes. */
static void add_picture(const struct glint_mesh *mesh, const struct glint_pose *pose, const struct conform_look *look,
                        uint16_t distance, uint8_t stride)
{
    static union {
        uint32_t words[(MEMORY + GLINT_MESH_LIGHTS_BYTES) / 4];
        void *aligned;
    } memory;
    uint8_t *const bytes = (uint8_t *)conform_pixels;
    struct glint_mesh_frame frame;
    struct glint_mesh_drawn drawn;
    for (uint16_t i = 0; i < sizeof conform_pixels; i++)
        bytes[i] = (uint8_t)i;
    conform_add((uint32_t)glint_mesh_check(mesh));
    conform_add((uint32_t)glint_mesh_begin(&frame, WIDTH, HEIGHT, STRIP, distance, &memory,
                                           look->has_lights ? sizeof memory : (size_t)MEMORY));
    frame.outlines = mesh->neighbours && !CONFORMANCE_ALBEDO_ONLY ? &glint_outlines : NULL;
    conform_add((uint32_t)glint_mesh_add(&frame, &drawn, mesh, pose, look->paint, conform_words, sizeof conform_words));
    for (uint16_t y = 0; y < HEIGHT; y += STRIP) {
        const struct glint_surface surface = {bytes + stride * y, stride, 0, y};
        conform_add(
            (uint32_t)glint_mesh_strip(&frame, y, (uint16_t)(HEIGHT - y < STRIP ? HEIGHT - y : STRIP), &surface));
    }
    conform_add_bytes(bytes, 4 * WIDTH * HEIGHT);
}

void conform_mesh(unsigned kind, const struct conform_look *look, uint8_t stride)
{
    struct glint_pose pose;
    struct glint_mesh mesh = {.places = places,
                              .normals = normals,
                              .faces = faces,
                              .vertex_count = VERTICES,
                              .face_count = FACES,
                              .of_vertices = look->of_vertices,
                              .of_faces = look->of_faces,
                              .use = &glint_use_mesh_albedo,
                              .neighbours = look->is_outlined ? neighbours : NULL};
    random_mesh(&pose, kind, &look->h);
    if (look->is_outlined)
        random_neighbours();
    if (look->texture) {
        mesh.textures = look->texture;
        mesh.uv = uv;
        mesh.uv_bits = (uint8_t)(8 + kind % 8);
        for (uint8_t i = 0; i < 2 * VERTICES; i++)
            uv[i] = (uint16_t)conform_random_bits();
    }
    if (look->has_grain && !CONFORMANCE_ALBEDO_ONLY) {
        mesh.use_grain = &glint_use_mesh_grain;
        for (uint8_t k = 0; k < 3; k++)
            mesh.grain[k] = any_q15(32767);
    }
    const uint32_t distance = conform_random_bits() % 1000;
    add_picture(&mesh, &pose, look, (uint16_t)(kind % 3 ? distance : 0), stride);
}

/* tables: COLOUR, at an even address or not. Phong's geometry takes the lights' memory; every second time it has none, and is refused. */
static void add_mesh(unsigned model, unsigned format, unsigned kind, bool tables)
{
    struct glint_material material;
    struct glint_light light;
    const struct glint_output output = {(uint8_t)format, tables ? 0 : kind & 1, tables ? kind % 5 == 4 : kind >> 1 & 1};
    conform_random_material(&material, &light, model);
    material.clamp_peak = kind >> 2 & 1;
    if (tables && !conform_fill(&conform_paint, GLINT_TABLES_COLOUR, &material, &output))
        return;
    if (!tables)
        conform_add((uint32_t)glint_paint_exact(&conform_paint, &material, &output));
    conform_light(&conform_paint, &light);
    const struct conform_look look = {
        .paint = &conform_paint, .h = conform_paint.h, .has_lights = model == GLINT_PHONG && kind & 1};
    conform_mesh(kind, &look, tables && kind % 4 ? 2 * WIDTH + 2 : 4 * WIDTH);
}

void conform_meshes(const struct conformance_size *size, bool tables)
{
    unsigned kind = 0;
    for (unsigned model = 0; model < GLINT_MODEL_COUNT; model++)
        for (unsigned format = GLINT_RGB565; format < GLINT_FORMAT_COUNT; format++)
            for (uint8_t scene = 0; scene < size->scenes; scene++) {
                if (!tables || format <= GLINT_RGB565_SWAPPED)
                    add_mesh(model, format, kind, tables);
                kind++;
            }
}

#endif
