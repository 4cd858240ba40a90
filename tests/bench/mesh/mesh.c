/* SPDX-License-Identifier: MIT
 * The teapot, as shipped and with its edges split, and the bunny, by COLOUR tables, exactly and by Gouraud shading. */
#include "mesh.h"
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
    const struct glint_mesh *mesh;
    unsigned kept;
} drawings[] = {
    {&teapot, KEPT},
    {&teapot_split, KEPT},
    {&teapot, KEPT_FEW},
#if MESH_BUNNY
    {&bunny, KEPT},
#endif
};

/* Aligned, and enough for the larger mesh; the second strip is the one that would be sent. */
static uint32_t
    frame_memory[(2 * WIDTH * LINES + 1024 /* what glint_mesh_frame_bytes adds */ + KEPT * GLINT_MESH_KEPT_BYTES) / 4],
    mesh_memory[12000];
static uint32_t tables_memory[GLINT_TABLES_COLOUR_BYTES / 4];
uint32_t mesh_out[WIDTH * LINES / 2];

static enum mesh_way chosen;

static struct glint_paint paint;
static struct glint_mesh_frame frame;
static struct glint_mesh_drawn drawn;

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
    static const struct glint_output output = {.format = GLINT_RGB565};
    static const int32_t to_light[3] = {-4, 6, 8}, to_viewer[3] = {0, 0, 1};
    struct glint_light light;
    chosen = way;
    gouraud_paint = way == MESH_GOURAUD ? &paint : NULL;
    return (way == MESH_BY_TABLES ? glint_paint_tables_for(&paint, &glint_use_colour, &clay, &output, tables_memory,
                                                           sizeof tables_memory, &glint_use_msh, &glint_use_rgb565)
                                  : glint_paint_exact_for(&paint, &clay, &output, &glint_use_msh, &glint_use_rgb565)) |
           glint_light_directional(&light, to_light) | glint_paint_light(&paint, &light, 1, to_viewer);
}

static size_t frame_bytes(unsigned which)
{
    return glint_mesh_frame_bytes(WIDTH, LINES) + drawings[which].kept * GLINT_MESH_KEPT_BYTES;
}

int mesh_frame(unsigned which)
{
    static const struct glint_pose teapots = {{30895, 6849, -8278, -1835}, {0, 0, 0}, 2410},
                                   bunnys = {{31651, 0, 8481, 0}, {0, 0, 0}, 2230};
    if (which >= sizeof drawings / sizeof *drawings)
        return 1;
    const int error = glint_mesh_begin(&frame, WIDTH, HEIGHT, LINES, 0, frame_memory, frame_bytes(which)) |
                      glint_mesh_add(&frame, &drawn, drawings[which].mesh, which < 3 ? &teapots : &bunnys, &paint,
                                     mesh_memory, sizeof mesh_memory);
    if (chosen == MESH_GOURAUD)
        gouraud_vertices(&drawn, 60, 8);
    return error;
}

int mesh_strip(unsigned y)
{
    const struct glint_surface surface = {mesh_out, 2 * WIDTH, 0, (uint16_t)y};
    return glint_mesh_strip(&frame, (uint16_t)y, LINES, &surface);
}

uint32_t mesh_memory_bytes(enum mesh_way way, unsigned which)
{
    return (uint32_t)(frame_bytes(which) + glint_mesh_bytes(drawings[which].mesh, HEIGHT) + 2 * sizeof mesh_out +
                      sizeof frame + sizeof drawn + sizeof paint + (way == MESH_BY_TABLES ? sizeof tables_memory : 0));
}
