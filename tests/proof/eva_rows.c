/* SPDX-License-Identifier: MIT
 * For Eva: what draws a mesh's pixels in general: a run of one to four pixels at each column of a strip of four columns and two lines, by exact paints
 * of Lyon's model, from the mesh's t, by Phong's normals, with grain and for several lights, without albedo and with colours, with textures, also in
 * perspective; by dithered COLOUR tables and by ALBEDO tables. Values, tables and colours are any. Which pixels of a row are in front, and rows in the
 * strip: eva_strips.c; steps across a triangle: eva_across.c; several lights: eva_lights.c; textures set: eva_textures.c; fused loops: eva_looks.c.
 * eva: -eva-precision 1 -eva-min-loop-unroll 8 -eva-slevel 40 -eva-slevel-function over_off:200,over_part:200 -split-zeros -eva-use-spec glint_mesh_inverse,VALUES,glint_mesh_across_set,glint_mesh_corners_of,glint_mesh_corners_weigh */
#include "eva_meshes.h"
#include "glint_mesh_strip.h"

/* What eva_across.c shows of them. */
/*@ assigns across->of[0 .. 2], across->x, across->y \from of[0 .. 2][0 .. 2];
    ensures \initialized(&across->of[0 .. 2].at) && \initialized(&across->of[0 .. 2].x) && \initialized(&across->of[0 .. 2].y) &&
            \initialized(&across->of[0 .. 2].least) && \initialized(&across->of[0 .. 2].most) && \initialized(&across->x) && \initialized(&across->y);
    ensures \forall integer k; 0 <= k <= 2 ==> -32767 <= across->of[k].least && -32767 <= across->of[k].most;
    ensures -2048 <= across->x <= 2048 && -2048 <= across->y <= 2048; */
void glint_mesh_across_set(struct glint_mesh_across *across, const struct glint_mesh_corners *corners,
                           int16_t of[3][3]);
/*@ assigns corners->clipped[0 .. 2], corners->at[0 .. 2] \from face;
    ensures \initialized(&corners->clipped[0 .. 2]);
    ensures corners->clipped[0] == \null && corners->clipped[1] == \null && corners->clipped[2] == \null; */
void glint_mesh_corners_of(struct glint_mesh_corners *corners, const struct glint_mesh_target *target, unsigned face);
/*@ assigns of[0 .. 2][0 .. 2] \from of[0 .. 2][0 .. 2]; */
void glint_mesh_corners_weigh(const struct glint_mesh_corners *corners, int16_t of[3][3]);

enum { WIDE = 4, HIGH = 2, CORNERS = 3 };

/* Each run, in the place of row_next and row_in_front, which the source's definitions have under other names. */
#define row_next(row, triangle, target) next_##row, triangle, target)
#define next_struct real_next(struct
#define next_row runs_next(row
#define row_in_front(row, most) front_##row, most)
#define front_struct real_in_front(struct
#define front_row runs_in_front(row
struct glint_mesh_row;
struct glint_mesh_triangle;
struct glint_mesh_target;
static bool runs_next(struct glint_mesh_row *row, struct glint_mesh_triangle *triangle,
                      const struct glint_mesh_target *target);
static unsigned runs_in_front(struct glint_mesh_row *row, unsigned most);
#define glint_mesh_lit_begin of_lit_begin
#define glint_mesh_is_lit of_is_lit
#define glint_mesh_t_end of_t_end
#define glint_mesh_is_colour of_is_colour
#define glint_mesh_is_albedo of_is_albedo
#define glint_mesh_blend_cells of_blend_cells
#define glint_mesh_piece of_piece
#define glint_mesh_rows of_rows
#include "mesh_rows.c"

static uint8_t pixels[4 * WIDE * HIGH];
static uint16_t depth[WIDE * HIGH], faces[3];
static struct glint_mesh_bench bench;
static uint32_t lit_memory[GLINT_MESH_LIGHTS_BYTES / 4];
static struct glint_mesh_frame frame;
static struct glint_mesh_kept kept;
static struct glint_mesh mesh;
static struct glint_mesh_vertex vertices[CORNERS];
static struct glint_mesh_drawn drawn;
static struct glint_paint paint;
static int8_t normals8[3 * CORNERS];
static uint8_t colours[3 * CORNERS];
static int32_t line_now;
static uint32_t at, end;
static bool is_there;

static bool runs_next(struct glint_mesh_row *row, struct glint_mesh_triangle *triangle,
                      const struct glint_mesh_target *target)
{
    const struct glint_span span = {any, any, any, any_signed, any_signed, 0, {{0, 0}, {0, 0}}};
    const bool was = is_there;
    is_there = false;
    row->run.line = (uint8_t *)target->surface->pixels + target->surface->stride * line_now;
    row->depth = target->depth + target->w * line_now;
    row->run.x = at;
    row->end = end;
    row->run.left = target->surface->x;
    row->run.y = (uint32_t)target->surface->y + (uint32_t)line_now;
    row->at = span;
    row->z = any;
    row->dz = any;
    triangle->y = (int16_t)(line_now + 1);
    return was;
}

static unsigned runs_in_front(struct glint_mesh_row *row, unsigned most)
{
    const unsigned count = row->end - row->run.x;
    /*@ assert most >= 4 || most >= count; */
    return count;
}

/* What sums lights: it sees what it is given. */
static void several_begin(struct glint_lights *lights, const struct glint_paint *of, bool is_boxed)
{
    (void)is_boxed;
    lights->paint = of;
    lights->channels = 1;
    lights->length = WIDE;
}
static void several_run(struct glint_lights *lights, unsigned count)
{
    volatile int32_t seen;
    for (unsigned i = 0; i < count; i++) {
        seen = lights->normals[i].x + lights->normals[i].y + lights->normals[i].z;
        seen = lights->places[i][0] ^ lights->places[i][1] ^ lights->places[i][2];
        if (lights->run->albedo)
            seen = lights->run->albedo[3 * i + 2];
    }
}

static void mesh_begin(void)
{
    for (unsigned i = 0; i < 3; i++)
        faces[i] = (uint16_t)(any % CORNERS);
    ANY_BYTES(normals8);
    ANY_BYTES(colours);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            drawn.turn[i][j] = (int16_t)(any_signed % 16385);
    mesh.faces = faces;
    mesh.normals8 = normals8;
    mesh.face_count = 1;
    mesh.vertex_count = CORNERS;
    frame.memory = &bench;
    frame.lit = lit_memory;
    frame.w = (uint16_t)(1 + any % GLINT_MESH_SIZE_MAX);
    frame.h = (uint16_t)(1 + any % GLINT_MESH_SIZE_MAX);
    drawn.mesh = &mesh;
    drawn.paints = &paint;
    drawn.vertices = vertices;
}

/* Every run of every line. */
static void rows(unsigned bits)
{
    const struct glint_surface surface = {pixels, (ptrdiff_t)(bits * WIDE + 7) / 8, (uint16_t)any, (uint16_t)any};
    const struct glint_mesh_target target = {&surface, depth,  WIDE, 0, HIGH, bench.polygon.list[1].samples,
                                             &frame,   &drawn, NULL};
    for (line_now = 0; line_now < HIGH; line_now++)
        for (at = 0; at < WIDE; at++)
            for (end = at + 1; end <= WIDE; end++) {
                struct glint_mesh_row row;
                is_there = true;
                kept.face = 0;
                rows_of(&paint, &kept.triangle, &target, &row, NULL, NULL, NULL, NULL);
            }
}

static void exact_by(const struct glint_use_model *model, uint16_t n_across, const struct glint_use_format *use,
                     uint8_t format, uint8_t space, bool dither)
{
    struct glint_material material = any_material(GLINT_LYON);
    const struct glint_output output = {format, space, dither};
    if (n_across)
        material.n = (uint16_t)(n_across + 1 + any % 999);
    material.n_across = n_across;
    mesh_begin();
    (void)glint_paint_exact_for(&paint, &material, &output, model, use);
    paint.l = any_vector();
    paint.v = any_vector();
    paint.h = any_vector();
    paint.light_count = 1;
}

static void exact_of(const struct glint_use_format *use, uint8_t format, uint8_t space, bool dither)
{
    exact_by(&glint_use_lyon, 0, use, format, space, dither);
}

/* By each group of formats, with colours and without. */
static void mapped(unsigned bits)
{
    mesh.of_faces = mesh.of_vertices = NULL;
    rows(bits);
    mesh.of_vertices = colours;
    rows(bits);
}
void eva_rows_rgb565(void)
{
    exact_of(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, any & 1);
    mapped(16);
}
void eva_rows_rgb888(void)
{
    exact_of(&glint_use_rgb888, GLINT_RGB888, GLINT_GAMMA, false);
    mapped(24);
}
void eva_rows_rgb888_dithered(void)
{
    exact_of(&glint_use_rgb888, GLINT_RGB888, GLINT_GAMMA, true);
    mapped(24);
}
void eva_rows_grey(void)
{
    exact_of(&glint_use_grey, GLINT_MONO, GLINT_GAMMA, any & 1);
    mapped(1);
}
void eva_rows_linear(void)
{
    exact_of(&glint_use_linear, GLINT_RGB565, GLINT_LINEAR, any & 1);
    mapped(16);
}

/* Normals and places, of both perspectives, for several lights. */
void eva_rows_lights(void)
{
    static const struct glint_use_lights several = {.begin = several_begin, .run = several_run};
    exact_of(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, any & 1);
    paint.several = &several;
    frame.distance = 0;
    mapped(16);
    frame.distance = (uint16_t)(1 + any % 65535);
    mapped(16);
}

/* Normals by Phong's geometry, and with grain along any axis. */
void eva_rows_phong(void)
{
    struct glint_use_model model = glint_use_lyon;
    model.geometry = glint_samples_phong;
    exact_by(&model, 0, &glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, any & 1);
    mapped(16);
}
void eva_rows_grain(void)
{
    exact_by(&glint_use_lyon_grain, 7, &glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, any & 1);
    mesh.use_grain = &glint_use_mesh_grain;
    for (unsigned i = 0; i < 3; i++)
        mesh.grain[i] = (int16_t)any;
    mapped(16);
}

/* ---- Textures ---- */

enum { TEXTURE_WIDE = 3, TEXTURE_HIGH = 2 };
static uint16_t texels[TEXTURE_WIDE * TEXTURE_HIGH], palette[256];
static uint8_t numbers[TEXTURE_WIDE * TEXTURE_HIGH];
static struct glint_texture texture;
static struct glint_use_mesh use;

static bool is_far;
/* As eva_textures.c shows that a triangle leaves it. */
static void over_any(struct glint_mesh_over *over, const struct glint_mesh_target *target, unsigned face,
                     const struct glint_texture *of)
{
    (void)target, (void)face;
    for (unsigned k = 0; k < 3; k++) {
        const struct glint_mesh_linear linear = {any, any, any};
        over->of[k] = linear;
    }
    over->x = any_signed % 2048;
    over->y = any_signed % 2048;
    over->picture.pixels = of ? (const uint8_t *)of->pixels : NULL;
    over->picture.palette = of ? of->palette : NULL;
    over->picture.w = TEXTURE_WIDE;
    over->picture.h = TEXTURE_HIGH;
    over->count = of ? 2 : 3;
    over->is_smooth = of && of->is_smooth;
    over->is_far = is_far;
    over->up = any % 17;
    for (unsigned k = 0; k < 2; k++) {
        over->down[k] = (uint8_t)(16 + any % 18);
        over->base[k] = any;
    }
}

/* Each kind of texture. */
static void textured(unsigned bits)
{
    use = glint_use_mesh_albedo;
    use.set = over_any;
    mesh.use = &use;
    mesh.textures = &texture;
    mesh.of_faces = mesh.of_vertices = NULL;
    ANY_BYTES(texels);
    ANY_BYTES(numbers);
    ANY_BYTES(palette);
    for (unsigned kind = 0; kind < 4; kind++) {
        texture.pixels = kind & 1 ? (const void *)numbers : (const void *)texels;
        texture.palette = kind & 1 ? palette : NULL;
        texture.w = TEXTURE_WIDE;
        texture.h = TEXTURE_HIGH;
        texture.levels = 1;
        texture.is_smooth = kind & 2;
        rows(bits);
    }
}
void eva_rows_textures(void)
{
    exact_of(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, any & 1);
    textured(16);
}

void eva_rows_far(void)
{
    is_far = true;
    exact_of(&glint_use_rgb565, GLINT_RGB565, GLINT_GAMMA, any & 1);
    textured(16);
}

/* ---- Tables, as they are filled and lit; every shift: eva_looks.c ---- */

static void tables_of(const struct glint_use_tables *of, unsigned columns_log)
{
    static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
    struct glint_tables *const tables = &paint.of.tables.filled;
    const uint32_t t_max = any % (GLINT_T_ONE + 1), most = (((uint32_t)1 << columns_log) << 12) - 1;
    mesh_begin();
    ANY_BYTES(memory);
    paint.format = NULL;
    paint.output.format = GLINT_RGB565;
    paint.light_count = 1;
    tables->colour.sums = memory;
    tables->columns = (const uint8_t *)memory;
    tables->t_max_q30 = t_max > most ? most : t_max;
    tables->dark = (uint16_t)any;
    tables->kind = of->kind;
    tables->format = GLINT_RGB565;
    tables->shift = 12;
    tables->dither = of->dither;
    tables->use = of;
    if (of == &glint_use_colour) {
        tables->columns += 2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS;
        for (unsigned i = 0; i < 1 << GLINT_COLOUR_COLUMNS_LOG; i++)
            ((uint8_t *)memory)[2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS + i] =
                (uint8_t)(2 * (any % GLINT_COLOUR_STEPS));
    } else if (of == &glint_use_colour_dithered) {
        tables->columns += GLINT_DITHER_SHINES;
    } else {
        tables->columns += GLINT_ALBEDO_LEVELS;
        tables->colour.sums += GLINT_ALBEDO_LEVELS / 4;
        tables->dark %= 33;
    }
}

void eva_rows_dithered(void)
{
    tables_of(&glint_use_colour_dithered, GLINT_DITHER_COLUMNS_LOG);
    rows(16);
}
/* What has no loop. */
void eva_rows_albedo(void)
{
    tables_of(&glint_use_albedo, GLINT_ALBEDO_COLUMNS_LOG);
    textured(16);
    mesh.textures = NULL;
    mesh.of_vertices = colours;
    rows(16);
}
