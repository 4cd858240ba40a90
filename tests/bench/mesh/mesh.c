/* SPDX-License-Identifier: MIT
 * The teapot, as shipped and with its edges split, and the bunny, by COLOUR tables, exactly and by Gouraud shading. */
#include "mesh.h"
#include "glint.h"
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

static struct glint_shader shader;
static struct glint_tables tables;
static struct glint_prepared prepared;
static struct glint_paint paint;
static struct glint_mesh_frame frame;
static struct glint_mesh_drawn drawn;

int mesh_begin(enum mesh_way way)
{
    static const struct glint_material clay = {.ambient_q16 = {6554, 3932, 2621},
                                               .diffuse_q16 = {40632, 22282, 9175},
                                               .specular_q16 = {52429, 52429, 52429},
                                               .albedo = {255, 255, 255}};
    const int32_t to_light[3] = {-4, 6, 8}, to_viewer[3] = {0, 0, 1};
    shader.material = clay;
    shader.format = GLINT_RGB565;
    shader.clamp_peak = true;
    glint_lobe_init(&shader.lobe, GLINT_MSH, 60, 8);
    chosen = way;
    paint.path = way == MESH_GOURAUD ? &gouraud_path : way == MESH_EXACT ? &glint_mesh_exact : &glint_mesh_tables;
    paint.with = way == MESH_BY_TABLES ? (const void *)&tables : (const void *)&prepared;
    return glint_light_init(&shader.light, to_light, to_viewer) |
           glint_shade_prepare_for(&prepared, &shader, &glint_shade_msh, &glint_shade_rgb565) |
           glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &shader, tables_memory, sizeof tables_memory);
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
                      glint_mesh_add(&frame, &drawn, drawings[which].mesh, which < 3 ? &teapots : &bunnys,
                                     &shader.light, &paint, mesh_memory, sizeof mesh_memory);
    if (chosen == MESH_GOURAUD)
        gouraud_vertices(&drawn, &shader.lobe);
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
                      sizeof frame + sizeof drawn +
                      (way == MESH_BY_TABLES ? sizeof tables + sizeof tables_memory : sizeof prepared));
}
