/* SPDX-License-Identifier: MIT
 * The loops that are measured. A loop is a row of bench_loops and the functions it names: they take bench_line and
 * bench_paint, keep what they need in bench_memory, and leave pixels in bench_line.out. */
#include "loops.h"

#include "peers.h"

/* Aligned as the library wants it of 8-bit machines, too, whose compilers do not care. */
__attribute__((aligned(4))) struct bench_line bench_line;
struct glint_material bench_material;
struct glint_output bench_output;
struct glint_light bench_lights[GLINT_LIGHTS_MAX];
struct glint_paint bench_paint;
__attribute__((aligned(4))) uint32_t bench_memory[BENCH_MEMORY / 4];
int16_t bench_error;
const struct bench_loop *bench_loop;
#ifndef __AVR__
uint32_t bench_map[SPHERE_W];
struct glint_vec bench_palette[SPHERE_PALETTE];
uint8_t bench_albedo[SPHERE_W][3], bench_gloss[SPHERE_W], bench_grain[SPHERE_W];
uint16_t bench_albedo_565[SPHERE_W];
#endif

void bench_check(enum glint_err err)
{
    if (err && !bench_error)
        bench_error = (int16_t)err;
}

void bench_begin(const struct bench_loop *loop, uint32_t n)
{
    bench_error = 0;
    bench_loop = loop;
    sphere_material(&bench_material, &bench_output, &loop->look, n);
    exact_fill();
    bench_light();
}

void bench_line_begin(uint16_t y)
{
    struct bench_line *line = &bench_line;
    line->y = y;
    line->from = line->to = 0;
    for (uint16_t x = 0; x < SPHERE_W; x++) {
        const struct glint_vec *n = &line->normals[x];
        line->mask[x] = n->x || n->y || n->z ? 255 : 0;
        if (line->mask[x]) {
            line->from = line->to ? line->from : x;
            line->to = (uint16_t)(x + 1);
        }
        if (bench_loop->look.albedo)
            sphere_expand(bench_albedo[x], sphere_albedo(x, y));
        if (bench_loop->look.gloss)
            bench_gloss[x] = sphere_gloss(x, y);
        if (bench_loop->look.grain >= GRAIN_MAP)
            bench_grain[x] = sphere_grain_byte(&bench_loop->look, x, y);
#ifndef __AVR__
        bench_albedo_565[x] = sphere_albedo(x, y);
#endif
    }
}

#ifndef __AVR__
static void steps_light(void)
{
    bench_light();
    bench_check(glint_paint_steps(&bench_paint, bench_memory, sizeof bench_memory));
}
#endif

static void exact_box(void)
{
    struct glint_box highlight;
    bench_rect_by(&bench_paint, MAP_INT16, &highlight);
}

/* ---- table loops ---- */

#ifndef __AVR__
static void colour_fill(void)
{
    bench_check(glint_paint_tables(&bench_paint, GLINT_TABLES_COLOUR, &bench_material, &bench_output, bench_memory,
                                   BENCH_TABLES));
    bench_light();
}

static void albedo_fill(void)
{
    bench_check(glint_paint_tables(&bench_paint, GLINT_TABLES_ALBEDO, &bench_material, &bench_output, bench_memory,
                                   GLINT_TABLES_ALBEDO_BYTES));
    bench_light();
}

/* With the line's box; over a rectangle fewer normals are looked at, since its box is known from the lines above. */
static void box_rect(void)
{
    struct glint_box highlight;
    bench_rect_by(&bench_paint, MAP_INT8, &highlight);
}

/* After the tables. */
#define COLOURS ((uint16_t *)BENCH_AFTER_TABLES)

static void palette_frame(void)
{
    const struct glint_surface colours = {COLOURS, 0, 0, 0};
    const struct glint_maps maps = {.normals = bench_palette};
    bench_light();
    bench_check(glint_draw_rect(&bench_paint, &maps, SPHERE_PALETTE, 1, &colours, NULL));
}

static void palette(void)
{
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    bench_check(glint_draw_palette(COLOURS, (const uint16_t *)(const void *)bench_map, 0, SPHERE_W, 1, &surface));
}
#endif

/* ---- the table ---- */

#ifdef __AVR__
#define WHAT(text) NULL /* constants take RAM */
#else
#define WHAT(text) text
#endif
#define INT16 .map_bytes = sizeof(struct glint_vec)
#define INT8 .map = MAP_INT8, .map_bytes = 4
#define PALETTE .map = MAP_PALETTE, .map_bytes = 2
#define EXACT exact_fill, bench_light, .shade = bench_rect, .step = 4
#define LIGHTS exact_fill, bench_light, .shade = bench_rect, INT16, .step = 48, .once = true
/* A row for each model; but MSH is "exact rect". */
#define ROW_YES(number, name)                                                                                          \
    {"exact " #name, WHAT("exact rect"), EXACT, INT16, .look = {.model = number}, .once = true},
#define ROW_NO(number, name)
#define IS_RECT_msh ,
#define THIRD(a, b, third, ...) third
#define CHOOSE(...) THIRD(__VA_ARGS__, )
#define MODEL_ROW(number, name, function, use, grain) CHOOSE(IS_RECT_##name, ROW_NO, ROW_YES)(number, name)

/* clang-format off */
const struct bench_loop bench_loops[] = {
    {"exact rect", WHAT("glint_draw_rect by an exact paint, int16 normals"), EXACT, INT16},
    {"exact rect swapped", WHAT("the same, in the panel's byte order"), EXACT, INT16, .look = {.format = GLINT_RGB565_SWAPPED}},
    {"exact rect box", WHAT("exact rect, with the highlight's box of each line"), exact_fill, bench_light, .shade = exact_box, .step = 4, INT16},
    {"exact dither", WHAT("exact rect, dithered"), EXACT, INT16, .look = {.dither = true}, .once = true},
    {"exact rgb888", WHAT("exact rect"), EXACT, INT16, .look = {.format = GLINT_RGB888}, .once = true},
    {"exact grey", WHAT("exact rect"), EXACT, INT16, .look = {.format = GLINT_GREY8}, .once = true},
    {"exact mono", WHAT("exact rect"), EXACT, INT16, .look = {.format = GLINT_MONO}, .once = true},
    {"exact linear", WHAT("exact rect, linear space"), EXACT, INT16, .look = {.space = GLINT_LINEAR}, .once = true},
    {"exact linear 888", WHAT("the same, RGB888"), EXACT, INT16, .look = {.format = GLINT_RGB888, .space = GLINT_LINEAR}, .once = true},
    {"exact linear grey", WHAT("the same, GREY8"), EXACT, INT16, .look = {.format = GLINT_GREY8, .space = GLINT_LINEAR}, .once = true},
    GLINT_MODELS(MODEL_ROW)
    {"exact albedo", WHAT("exact rect, albedo in RGB888, white light"), EXACT, .look = {.albedo = true}, .map_bytes = 9},
    {"exact albedo 888", WHAT("the same, RGB888"), EXACT, .look = {.format = GLINT_RGB888, .albedo = true}, .map_bytes = 9, .once = true},
    {"exact gloss", WHAT("exact rect, gloss"), EXACT, .look = {.gloss = true}, .map_bytes = 7, .once = true},
#ifndef __AVR__
    {"exact rect steps", WHAT("exact rect, with glint_paint_steps"), exact_fill, steps_light, .shade = bench_rect, .step = 4, INT16},
    {"exact linear steps", WHAT("exact linear, the same"), exact_fill, steps_light, .shade = bench_rect, .step = 4, INT16, .look = {.space = GLINT_LINEAR}, .once = true},
    {"exact span 64 steps", WHAT("exact span 64, the same"), exact_fill, steps_light, .prepare = bench_spans_64, .shade = bench_span, .step = 4, .once = true},
#endif
    {"exact span 16", WHAT("glint_draw_span by an exact paint, spans of 16"),
     exact_fill, bench_light, .prepare = bench_spans_16, .shade = bench_span, .step = 4},
    {"exact span 64", WHAT("the same, spans of 64"),
     exact_fill, bench_light, .prepare = bench_spans_64, .shade = bench_span, .step = 4},
    {"exact directional coloured", WHAT("exact rect, one coloured directional light"), LIGHTS, .look = {.lights = LIGHTS_DIRECTIONAL_COLOURED}},
    {"exact point", WHAT("the same, one white point"), LIGHTS, .look = {.lights = LIGHTS_POINT}},
    {"exact point coloured", WHAT("the same, one coloured point"), LIGHTS, .look = {.lights = LIGHTS_COLOURED}},
    {"exact spot", WHAT("the same, one white spot"), LIGHTS, .look = {.lights = LIGHTS_SPOT}},
    {"exact narrow spot", WHAT("the same, a spot so narrow that most of its edge is drawn in 64 bits"), LIGHTS, .look = {.lights = LIGHTS_NARROW}},
    {"exact four points", WHAT("the same, four white points, near"), LIGHTS, .look = {.lights = LIGHTS_FOUR}},
    {"exact four points 2", WHAT("the same, of colour 2 over a material half as bright"), LIGHTS, .look = {.lights = LIGHTS_FOUR_2}},
    {"exact four points 4", WHAT("the same, 4"), LIGHTS, .look = {.lights = LIGHTS_FOUR_4}},
    {"exact four points 16", WHAT("the same, 16"), LIGHTS, .look = {.lights = LIGHTS_FOUR_16}},
#ifndef __AVR__
    {"exact grey4", WHAT("exact rect, GREY4, dithered"), EXACT, INT16, .look = {.format = GLINT_GREY4, .dither = true}, .once = true},
    {"exact coverage", WHAT("exact rect, two pixels at each end of a line covered in part"), EXACT, INT16, .pack = bench_soft_edges, .once = true},
    {"exact coverage all", WHAT("exact rect, every pixel covered in part"), EXACT, INT16, .pack = bench_soft_all, .once = true},
    {"exact coverage all dither", WHAT("the same, dithered"), EXACT, INT16, .look = {.dither = true}, .pack = bench_soft_all, .once = true},
    {"exact coverage all 888", WHAT("the same, RGB888"), EXACT, INT16, .look = {.format = GLINT_RGB888}, .pack = bench_soft_all, .once = true},
    {"exact coverage all grey", WHAT("the same, GREY8"), EXACT, INT16, .look = {.format = GLINT_GREY8}, .pack = bench_soft_all, .once = true},
    {"exact coverage all linear", WHAT("the same, RGB565 in linear space"), EXACT, INT16, .look = {.space = GLINT_LINEAR}, .pack = bench_soft_all, .once = true},
    {"exact brushed", WHAT("exact rect, n_across 8, brushed"), EXACT, INT16, .look = {.grain = GRAIN_BRUSHED}, .once = true},
    {"exact spun", WHAT("the same, spun"), EXACT, INT16, .look = {.grain = GRAIN_SPUN}, .once = true},
    {"exact grain map", WHAT("the same, a map of grain"), EXACT, .look = {.grain = GRAIN_MAP}, .map_bytes = 7, .once = true},
    {"exact shininess", WHAT("exact rect, a map of shininess"), EXACT, .look = {.grain = GRAIN_SHININESS}, .map_bytes = 7, .once = true},
    {"exact filtered", WHAT("exact rect, maps of albedo, gloss and shininess"), EXACT, .look = {.albedo = true, .gloss = true, .grain = GRAIN_SHININESS}, .map_bytes = 11, .once = true},
    {"exact int8", WHAT("exact rect, int8 normals"), EXACT, INT8},
    {"colour span 16", WHAT("glint_draw_span by COLOUR tables, spans of 16"), colour_fill, .prepare = bench_spans_16, .shade = bench_span},
    {"colour span 64", WHAT("the same, spans of 64"), colour_fill, .prepare = bench_spans_64, .shade = bench_span},
    {"colour int8", WHAT("glint_draw_rect by COLOUR tables, int8 normals"), colour_fill, bench_light, .shade = bench_rect, INT8},
    {"colour int16", WHAT("the same, int16 normals"), colour_fill, bench_light, .shade = bench_rect, INT16},
    {"colour int8 dither", WHAT("colour int8, dithered"), colour_fill, bench_light, .shade = bench_rect, INT8, .look = {.dither = true}, .once = true},
    {"colour int8 box", WHAT("colour int8, with the highlight's box of each line"), colour_fill, bench_light, .shade = box_rect, INT8, .once = true},
    {"colour int16 dither", WHAT("colour int16, dithered"), colour_fill, bench_light, .shade = bench_rect, INT16, .look = {.dither = true}, .once = true},
    {"colour span 16 dither", WHAT("colour span 16, dithered"), colour_fill, .prepare = bench_spans_16, .shade = bench_span, .look = {.dither = true}, .once = true},
    {"albedo int8", WHAT("glint_draw_rect by ALBEDO tables, int8 normals, RGB565 albedo"),
     albedo_fill, bench_light, .shade = bench_rect, .look = {.albedo = true}, .map = MAP_INT8, .map_bytes = 6},
    {"albedo int16", WHAT("the same, int16 normals"),
     albedo_fill, bench_light, .shade = bench_rect, .look = {.albedo = true}, .map_bytes = 8},
    {"albedo span 16", WHAT("glint_draw_span by ALBEDO tables, spans of 16"),
     albedo_fill, .prepare = bench_spans_16, .shade = bench_span, .look = {.albedo = true}, .map_bytes = 2},
    {"colour int8 coverage", WHAT("colour int8, two pixels at each end of a line covered in part"), colour_fill, bench_light, .shade = bench_rect, INT8, .pack = bench_soft_edges, .once = true},
    {"colour int8 coverage all", WHAT("colour int8, every pixel covered in part"), colour_fill, bench_light, .shade = bench_rect, INT8, .pack = bench_soft_all, .once = true},
    {"albedo int8 coverage all", WHAT("albedo int8, every pixel covered in part"),
     albedo_fill, bench_light, .shade = bench_rect, .look = {.albedo = true}, .map = MAP_INT8, .map_bytes = 6, .pack = bench_soft_all, .once = true},
    {"colour int16 filtered", WHAT("colour int16, maps of gloss and shininess"), colour_fill, bench_light, .shade = bench_rect, .map_bytes = 8, .look = {.gloss = true, .grain = GRAIN_SHININESS}, .once = true},
    {"albedo int8 gloss", WHAT("albedo int8, a map of gloss"),
     albedo_fill, bench_light, .shade = bench_rect, .look = {.albedo = true, .gloss = true}, .map = MAP_INT8, .map_bytes = 7, .once = true},
    {"albedo int8 filtered", WHAT("the same, and one of shininess"),
     albedo_fill, bench_light, .shade = bench_rect, .look = {.albedo = true, .gloss = true, .grain = GRAIN_SHININESS}, .map = MAP_INT8, .map_bytes = 8, .once = true},
    {"palette", WHAT("glint_draw_palette, 4096 entries by colour int16"), colour_fill, palette_frame, .shade = palette, PALETTE},
#endif
    {"integer power", WHAT("int16 normals, Q15, powers by squaring"),
     .shade = peer_integer_power, INT16, .look = {.model = GLINT_BLINN}},
    {"table power", WHAT("int16 normals, Q15, 256 powers, nearest below"),
     peer_fill, .shade = peer_table_power, INT16, .look = {.model = GLINT_BLINN}},
    {"int8 table power", WHAT("int8 normals, 128 powers, nearest below"),
     peer_int8_fill, .pack = peer_int8_pack, .shade = peer_int8_table_power, .map_bytes = 3, .look = {.model = GLINT_BLINN}},
    {"float MSH", WHAT("float, the whole pixel"), .shade = peer_float_msh, INT16, .step = 16},
    {"float folded", WHAT("the same by an expert: constants folded, cutoff, one division"), .frame = peer_float_fold, .shade = peer_float_folded, INT16, .step = 16},
    {"float powf", WHAT("float, the whole pixel, the C library's powf"),
     .shade = peer_float_powf, INT16, .look = {.model = GLINT_BLINN}, .step = 32},
    {.name = NULL},
};
/* clang-format on */
