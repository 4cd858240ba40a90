/* SPDX-License-Identifier: MIT
 * The teapot, as shipped and with its edges split, and the bunny, by COLOUR tables, exactly, by Gouraud shading and under points; and its
 * normals as a rectangle's. */
#include <string.h>

#include "mesh.h"
#include "glint_lights.h"
#include "glint_mesh.h"
#include "gouraud.h"
#include "teapot.h"
#include "teapot_split.h"
#if MESH_BUNNY
#include "bunny.h"
#endif

enum { WIDTH = MESH_WIDTH, HEIGHT = MESH_HEIGHT, LINES = MESH_LINES, KEPT = 50, KEPT_FEW = 18 };
/* And places for triangles that go on. */
static const struct {
    const struct glint_mesh *mesh; /* NULL: not there */
    unsigned kept;
    bool outlines;
} drawings[] = {
    {&teapot, KEPT, false}, {&teapot_split, KEPT, false}, {&teapot, KEPT_FEW, false},
#if MESH_BUNNY
    {&bunny, KEPT, false},
#else
    {NULL, 0, false},
#endif
    {&teapot, KEPT, true},
};
enum { BUNNY = 3 };

/* Aligned, and enough for the larger mesh; the second strip is the one that would be sent. */
static uint32_t frame_memory[(2 * WIDTH * LINES + 1024 /* what glint_mesh_frame_bytes adds */ +
                              KEPT * GLINT_MESH_KEPT_BYTES + GLINT_MESH_LIGHTS_BYTES) /
                             4],
    mesh_memory[9400];
enum { SIDE = 64, VERTICES = 600 /* as the teapot has */ };
/* Tables, with a texture or not, or the strip's normals: mesh_normals. */
static union {
    uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4];
    struct glint_vec normals[LINES][WIDTH];
    struct {
        uint32_t tables[GLINT_TABLES_ALBEDO_BYTES / 4];
        uint16_t texels[SIDE * SIDE];
    } albedo;
} either;
uint32_t mesh_out[WIDTH * LINES / 2];

static enum mesh_way chosen;

/* A texture of 64 by 64 from the front, repeated, and a colour of each vertex; the mesh that has them. They lie at the end of the memory of
 * meshes, which this one does not fill. */
static struct cloth {
    uint16_t uv[VERTICES][2];
    uint8_t colours[VERTICES][3];
} *const cloth = (struct cloth *)(void *)((uint8_t *)mesh_memory + sizeof mesh_memory - sizeof(struct cloth));
static struct glint_texture texture = {.pixels = either.albedo.texels, .w = SIDE, .h = SIDE, .levels = 1};
static struct glint_mesh clothed;

static const struct glint_mesh *clothe(const struct glint_mesh *mesh)
{
    if (chosen < MESH_TEXTURED || mesh->vertex_count > VERTICES)
        return mesh;
    clothed = *mesh;
    clothed.use = &glint_use_mesh_albedo;
    for (uint32_t i = 0; i < SIDE * SIDE; i++)
        either.albedo.texels[i] = (uint16_t)(i * 0x9e37u);
    for (unsigned i = 0; i < mesh->vertex_count; i++)
        for (unsigned k = 0; k < 3; k++) {
            cloth->colours[i][k] = (uint8_t)((mesh->places[3 * i + k] >> 8) + 128);
            if (k < 2)
                cloth->uv[i][k] = (uint16_t)(mesh->places[3 * i + k] + 32768);
        }
    texture.is_smooth = chosen == MESH_SMOOTH;
    if (chosen == MESH_COLOURED) {
        clothed.of_vertices = cloth->colours[0];
    } else {
        clothed.textures = &texture;
        clothed.uv = cloth->uv[0];
        clothed.uv_bits = 14;
    }
    return &clothed;
}

static bool is_albedo(enum mesh_way way)
{
    return way >= MESH_TEXTURED && way != MESH_TEXTURED_EXACT;
}

static struct glint_paint paint;
static struct glint_mesh mesh;
static struct glint_mesh_frame frame;
static struct glint_mesh_drawn drawn;

/* How many. A point is 512 pixels from the picture's middle in x, in y and towards the viewer; four are around it. */
static int lights_of(enum mesh_way way, struct glint_light lights[GLINT_LIGHTS_MAX])
{
    enum {
        AWAY = 8192,
        LEFT = 8 * WIDTH - AWAY,
        RIGHT = 8 * WIDTH + AWAY,
        TOP = 8 * HEIGHT - AWAY,
        BOTTOM = 8 * HEIGHT + AWAY,
        RANGE = 32768
    };
    static const int32_t to_light[3] = {-4, 6, 8};
    static const int32_t places[GLINT_LIGHTS_MAX][3] = {
        {LEFT, TOP, AWAY}, {RIGHT, TOP, AWAY}, {LEFT, BOTTOM, AWAY}, {RIGHT, BOTTOM, AWAY}};
    const int count = (int)way - MESH_DARK;
    if (way < MESH_DARK || way >= MESH_TEXTURED)
        return glint_light_directional(lights, to_light) ? -1 : 1;
    for (int i = 0; i < count; i++)
        if (glint_light_point(&lights[i], places[i], RANGE))
            return -1;
    return count;
}

int mesh_begin(enum mesh_way way)
{
    static const struct glint_material clay = {.model = GLINT_MSH,
                                               .q = 8,
                                               .n = 60,
                                               .ambient_q16 = {6554, 3932, 2621},
                                               .diffuse_q16 = {40632, 22282, 9175},
                                               .specular_q16 = {52429, 52429, 52429},
                                               .albedo = {255, 255, 255},
                                               .clamp_peak = true};
    static const struct glint_material stone = {.model = GLINT_MSH,
                                                .q = 8,
                                                .n = 60,
                                                .ambient_q16 = {6554, 6554, 6554},
                                                .diffuse_q16 = {40632, 40632, 40632},
                                                .specular_q16 = {52429, 52429, 52429},
                                                .albedo = {255, 255, 255},
                                                .clamp_peak = true};
    static const struct glint_output output = {.format = GLINT_RGB565};
    static const int32_t to_viewer[3] = {0, 0, 1};
    static struct glint_light lights[GLINT_LIGHTS_MAX];
    const int count = lights_of(way, lights);
    chosen = way;
    gouraud_paint = way == MESH_GOURAUD ? &paint : NULL;
    return count < 0 ||
           (way == MESH_BY_TABLES ? glint_paint_tables_for(&paint, &glint_use_colour, &clay, &output, either.tables,
                                                           sizeof either.tables, &glint_use_msh, &glint_use_rgb565)
            : is_albedo(way)      ? glint_paint_tables_for(&paint, &glint_use_albedo, &stone, &output, either.tables,
                                                           sizeof either.tables, &glint_use_msh, &glint_use_rgb565)
                                  : glint_paint_exact_for(&paint, &clay, &output, &glint_use_msh, &glint_use_rgb565)) ||
           glint_paint_light(&paint, lights, (unsigned)count, to_viewer);
}

static size_t frame_bytes(unsigned which)
{
    return glint_mesh_frame_bytes(WIDTH, LINES) + drawings[which].kept * GLINT_MESH_KEPT_BYTES +
           (chosen > MESH_DARK && chosen < MESH_TEXTURED ? GLINT_MESH_LIGHTS_BYTES : 0);
}

/* The mesh, clothed by mesh_clothe: that is not counted. */
static const struct glint_mesh *clothed_of(unsigned which)
{
    return chosen < MESH_TEXTURED ? drawings[which].mesh : &clothed;
}

int mesh_clothe(unsigned which)
{
    return which >= sizeof drawings / sizeof *drawings ||
           (chosen >= MESH_TEXTURED && clothe(drawings[which].mesh) != &clothed);
}

int mesh_frame(unsigned which)
{
    static const struct glint_pose teapots = {{30895, 6849, -8278, -1835}, {0, 0, 0}, 2410},
                                   bunnys = {{31651, 0, 8481, 0}, {0, 0, 0}, 2230};
    if (which >= sizeof drawings / sizeof *drawings || !drawings[which].mesh)
        return 1;
    mesh = *clothed_of(which);
    int error = glint_mesh_begin(&frame, WIDTH, HEIGHT, LINES, chosen == MESH_TEXTURED_FAR ? 8000 : 0, frame_memory,
                                 frame_bytes(which));
    if (drawings[which].outlines)
        frame.outlines = &glint_outlines;
    else
        mesh.neighbours = NULL;
    error |= glint_mesh_add(&frame, &drawn, &mesh, which == BUNNY ? &bunnys : &teapots, &paint, mesh_memory,
                            sizeof mesh_memory - (mesh.vertex_count > VERTICES ? 0 : sizeof *cloth));
    if (chosen == MESH_GOURAUD)
        gouraud_vertices(&drawn, 60, 8);
    return error;
}

int mesh_strip(unsigned y)
{
    const struct glint_surface surface = {mesh_out, 2 * WIDTH, 0, (uint16_t)y};
    return glint_mesh_strip(&frame, (uint16_t)y, LINES, &surface);
}

uint32_t mesh_memory_bytes(enum mesh_way way, unsigned which) /* after mesh_frame */
{
    return (uint32_t)(frame_bytes(which) + glint_mesh_bytes(&mesh, HEIGHT) + 2 * sizeof mesh_out + sizeof frame +
                      sizeof drawn + sizeof paint +
                      (way == MESH_BY_TABLES ? sizeof either.tables
                       : is_albedo(way)      ? (size_t)GLINT_TABLES_ALBEDO_BYTES
                                             : 0));
}

/* ---- The same normals as a rectangle's ---- */

/* Where cloth is, which is not drawn then: neither teapot fills the memory of meshes. */
static uint8_t (*const coverage)[WIDTH] = (uint8_t(*)[WIDTH])(void *)((uint8_t *)mesh_memory + sizeof mesh_memory -
                                                                      LINES * WIDTH);

/* In the place of what draws a run under points. */
static void keep_normals(struct glint_lights *lights, unsigned count)
{
    const size_t at = lights->run->y % LINES * WIDTH + lights->run->x;
    memcpy(either.normals[0] + at, lights->normals, count * sizeof *lights->normals);
    memset(coverage[0] + at, 255, count);
}

int mesh_normals(unsigned y)
{
    const struct glint_use_lights *const several = paint.several;
    struct glint_use_lights keeping = *several;
    keeping.run = keep_normals;
    memset(coverage, 0, LINES * sizeof *coverage);
    paint.several = &keeping;
    const int error = mesh_strip(y);
    paint.several = several;
    return error;
}

int mesh_rect(unsigned y)
{
    static const struct glint_maps maps = {.normals = either.normals,
                                           .normals_stride = sizeof *either.normals,
                                           .coverage = coverage[0],
                                           .coverage_stride = sizeof *coverage};
    const struct glint_surface surface = {mesh_out, 2 * WIDTH, 0, (uint16_t)y};
    return glint_draw_rect(&paint, &maps, WIDTH, LINES, &surface, NULL);
}
