/* SPDX-License-Identifier: MIT
 * For Eva: the cells of an outline as pixels that are blended, two lines of 18 of them: cells of any values and parts, in each column, by exact
 * paints of Lyon's model and by COLOUR tables, over any pixels. Other rows of triangles are not here.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-ilevel 64 -eva-use-spec VALUES */
#include "eva_meshes.h"
#include "glint_mesh_strip.h"

enum { WIDE = 18, HIGH = 2, GUARD = 0x5a, CORNERS = 3 };

/* Beside the pixels nothing is to be written. */
static struct {
    uint16_t depth[WIDE * HIGH];
    uint8_t between[4], pixels[4 * WIDE * HIGH], behind[4];
} strip;
static struct glint_mesh_bench bench;
static struct glint_mesh_frame frame;
static struct glint_mesh_kept places[1];
static struct glint_mesh mesh;
static struct glint_mesh_vertex vertices[CORNERS];
static uint16_t faces[3];
static struct glint_mesh_drawn drawn;
static struct glint_paint paint;

static void rows_begin(void)
{
    for (unsigned i = 0; i < 3; i++)
        faces[i] = (uint16_t)(any % CORNERS);
    mesh.faces = faces;
    mesh.face_count = 1;
    mesh.vertex_count = CORNERS;
    frame.memory = &bench;
    frame.kept = places;
    drawn.mesh = &mesh;
    drawn.paints = &paint;
    drawn.vertices = vertices;
    for (unsigned i = 0; i < 4; i++)
        strip.between[i] = strip.behind[i] = GUARD;
}

/* Nothing between or behind was written. */
static void rows_end(void)
{
    for (unsigned i = 0; i < 4; i++) {
        /*@ assert strip.between[i] == GUARD && strip.behind[i] == GUARD; */
    }
}

/* COLOUR tables as glint_paint_tables_filled and glint_paint_light leave them; every shift: eva_looks.c. */

static void tables_of(const struct glint_use_tables *use, unsigned columns_log, uint8_t format)
{
    static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
    struct glint_tables *const tables = &paint.of.tables.filled;
    const uint32_t t_max = any % (GLINT_T_ONE + 1), most = (((uint32_t)1 << columns_log) << 12) - 1;
    ANY_BYTES(memory);
    paint.format = NULL;
    paint.output.format = format;
    paint.light_count = 1;
    tables->colour.sums = memory;
    tables->columns = (const uint8_t *)memory;
    tables->t_max_q30 = t_max > most ? most : t_max;
    tables->dark = (uint16_t)any;
    tables->kind = use->kind;
    tables->format = format;
    tables->shift = 12;
    tables->dither = use->dither;
    tables->use = use;
    if (use == &glint_use_colour) {
        tables->columns += 2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS;
        for (unsigned i = 0; i < 1 << GLINT_COLOUR_COLUMNS_LOG; i++)
            ((uint8_t *)memory)[2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS + i] =
                (uint8_t)(2 * (any % GLINT_COLOUR_STEPS));
    } else if (use == &glint_use_colour_dithered) {
        tables->columns += GLINT_DITHER_SHINES;
    } else {
        tables->columns += GLINT_ALBEDO_LEVELS;
        tables->colour.sums += GLINT_ALBEDO_LEVELS / 4;
        tables->dark %= 33;
    }
}

static void exact_of(const struct glint_use_format *use, uint8_t format, uint8_t space)
{
    const struct glint_material material = any_material(GLINT_LYON);
    const struct glint_output output = {format, space, any & 1};
    (void)glint_paint_exact_for(&paint, &material, &output, &glint_use_lyon, use);
    paint.l = any_vector();
    paint.v = any_vector();
    paint.h = any_vector();
    paint.light_count = 1;
}
/* ---- What outlines blend: cells of any values, in each column ---- */

static int32_t cells_column, cells_left;
static bool cells_next(struct glint_mesh_cells *cells, struct glint_mesh_cell *cell)
{
    const struct glint_mesh_cell now = {any, any, any, any, any, any, any, cells_column, --cells_left, (uint8_t)any};
    (void)cells;
    *cell = now;
    return cells_left >= 0;
}
static void cells(unsigned bits)
{
    static struct glint_mesh_blending blending;
    const struct glint_surface surface = {strip.pixels, (ptrdiff_t)(bits * WIDE + 7) / 8, (uint16_t)any, (uint16_t)any};
    const struct glint_mesh_target target = {&surface, strip.depth, WIDE, 1, 1 + HIGH, bench.polygon.list[1].samples,
                                             &frame,   &drawn,      NULL};
    rows_begin();
    for (cells_column = 0; cells_column < WIDE; cells_column++) {
        cells_left = HIGH;
        glint_mesh_blend_cells(&paint, NULL, cells_next, &blending, &bench.face.triangle, &target);
        rows_end();
    }
}
void eva_mesh_cells(void)
{
    exact_of(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA);
    cells(16);
    exact_of(&glint_use_rgb888, GLINT_ARGB8888, GLINT_GAMMA);
    cells(32);
    exact_of(&glint_use_grey, GLINT_MONO, GLINT_GAMMA);
    cells(1);
    exact_of(&glint_use_linear, GLINT_RGB888, GLINT_LINEAR);
    cells(24);
    tables_of(&glint_use_colour, GLINT_COLOUR_COLUMNS_LOG, GLINT_RGB565);
    cells(16);
}
