/* SPDX-License-Identifier: MIT
 * The loops that are measured. A loop is a row of bench_loops and the functions it names: they take bench_line and
 * bench_shader, keep what they need in bench_memory, and leave pixels in bench_line.out. */
#include "loops.h"

#include "peers.h"

/* Aligned as the library wants it of 8-bit machines, too, whose compilers do not care. */
__attribute__((aligned(4))) struct bench_line bench_line;
struct glint_shader bench_shader;
__attribute__((aligned(4))) uint32_t bench_memory[BENCH_MEMORY / 4];
int16_t bench_error;
const struct bench_loop *bench_loop;
#ifndef __AVR__
uint32_t bench_map[SPHERE_W];
struct glint_vec bench_palette[SPHERE_PALETTE];
uint8_t bench_albedo[SPHERE_W][3], bench_gloss[SPHERE_W];
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
    sphere_shader(&bench_shader, &loop->look, n);
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
#ifndef __AVR__
        bench_albedo_565[x] = sphere_albedo(x, y);
#endif
    }
}

/* ---- table loops ---- */

static struct glint_tables tables;
static struct glint_tables_light tables_light;

static void small_fill(void)
{
    bench_check(glint_tables_fill(&tables, GLINT_TABLES_SMALL, &bench_shader, bench_memory, GLINT_TABLES_SMALL_BYTES));
}

static void tables_frame(void)
{
    bench_check(glint_tables_light_init(&tables_light, &tables, &bench_shader.light));
}

static void tables_rect(enum glint_normals format, const void *normals)
{
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    bench_check(glint_tables_rect(&tables, &tables_light, format, normals, 0, SPHERE_W, 1, &surface));
}

static void tables_int16(void)
{
    tables_rect(GLINT_NORMALS_INT16, bench_line.normals);
}

#ifndef __AVR__
static void colour_fill(void)
{
    bench_check(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &bench_shader, bench_memory, BENCH_TABLES));
}

static void tables_int10(void)
{
    tables_rect(GLINT_NORMALS_INT10, bench_map);
}

static void tables_int8(void)
{
    tables_rect(GLINT_NORMALS_INT8, bench_map);
}

/* A line's box alone; over a rectangle fewer normals are looked at, since its box is known from the lines above. */
static void tables_int8_box(void)
{
    struct glint_box highlight;
    bench_check(glint_tables_box(&tables, &tables_light, GLINT_NORMALS_INT8, bench_map, 0, SPHERE_W, 1, &highlight));
}

static void tables_span(void)
{
    const struct glint_span *span = bench_spans;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
        bench_check(glint_tables_span(&tables, span, &surface));
    }
}

static void albedo_fill(void)
{
    bench_check(
        glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &bench_shader, bench_memory, GLINT_TABLES_ALBEDO_BYTES));
}

static void albedo_rect(enum glint_normals format, const void *normals)
{
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    bench_check(glint_tables_albedo_rect(&tables, &tables_light, format, normals, 0, bench_albedo_565, 0, SPHERE_W, 1,
                                         &surface));
}

static void albedo_int8(void)
{
    albedo_rect(GLINT_NORMALS_INT8, bench_map);
}

static void albedo_int16(void)
{
    albedo_rect(GLINT_NORMALS_INT16, bench_line.normals);
}

static void albedo_span(void)
{
    const struct glint_span *span = bench_spans;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
        bench_check(glint_tables_albedo_span(&tables, span, bench_albedo_565 + x, &surface));
    }
}

/* After the tables. */
#define COLOURS ((uint16_t *)BENCH_AFTER_TABLES)

static void palette_frame(void)
{
    const struct glint_surface colours = {COLOURS, 0, 0, 0};
    tables_frame();
    bench_check(
        glint_tables_rect(&tables, &tables_light, GLINT_NORMALS_INT16, bench_palette, 0, SPHERE_PALETTE, 1, &colours));
}

static void palette(void)
{
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    bench_check(glint_palette_rect(COLOURS, (const uint16_t *)(const void *)bench_map, 0, SPHERE_W, 1, &surface));
}
#endif

/* ---- the table ---- */

#ifdef __AVR__
#define WHAT(text) NULL /* constants take RAM */
#else
#define WHAT(text) text
#endif
#define INT16 .map_bytes = sizeof(struct glint_vec)
#define INT10 .map = MAP_INT10, .map_bytes = 4
#define INT8 .map = MAP_INT8, .map_bytes = 4
#define PALETTE .map = MAP_PALETTE, .map_bytes = 2
#define EXACT exact_fill, exact_frame, .shade = exact_rect, .step = 4
#define LIGHTS .frame = exact_lights_frame, .shade = exact_lights, INT16, .step = 48, .once = true

/* clang-format off */
const struct bench_loop bench_loops[] = {
    {"exact rect", WHAT("glint_shade_prepared_rect, int16 normals"), EXACT, INT16},
    {"small int16", WHAT("under 1 KB of RAM, int16 normals"), small_fill, tables_frame, .shade = tables_int16, INT16},
    {"exact dither", WHAT("exact rect, dithered"), EXACT, INT16, .look = {.dither = true}, .once = true},
    {"exact rgb888", WHAT("exact rect"), EXACT, INT16, .look = {.format = GLINT_RGB888}, .once = true},
    {"exact grey", WHAT("exact rect"), EXACT, INT16, .look = {.format = GLINT_GREY8}, .once = true},
    {"exact mono", WHAT("exact rect"), EXACT, INT16, .look = {.format = GLINT_MONO}, .once = true},
    {"exact linear", WHAT("exact rect, linear space"), EXACT, INT16, .look = {.space = GLINT_LINEAR}, .once = true},
    {"exact linear 888", WHAT("the same, RGB888"), EXACT, INT16, .look = {.format = GLINT_RGB888, .space = GLINT_LINEAR}, .once = true},
    {"exact linear grey", WHAT("the same, GREY8"), EXACT, INT16, .look = {.format = GLINT_GREY8, .space = GLINT_LINEAR}, .once = true},
    {"exact schlick", WHAT("exact rect"), EXACT, INT16, .look = {.model = GLINT_SCHLICK}, .once = true},
    {"exact cayley", WHAT("exact rect"), EXACT, INT16, .look = {.model = GLINT_CAYLEY}, .once = true},
    {"exact lyon", WHAT("exact rect"), EXACT, INT16, .look = {.model = GLINT_LYON}, .once = true},
    {"exact blinn", WHAT("exact rect"), EXACT, INT16, .look = {.model = GLINT_BLINN}, .once = true},
    {"exact gauss", WHAT("exact rect"), EXACT, INT16, .look = {.model = GLINT_GAUSS}, .once = true},
    {"exact phong", WHAT("exact rect"), EXACT, INT16, .look = {.model = GLINT_PHONG}, .once = true},
    {"exact rect, call", WHAT("glint_shade_rect, which prepares: a line a call"), .shade = exact_call, INT16, .step = 4, .once = true},
    {"exact albedo", WHAT("exact rect, albedo in RGB888, white light"), EXACT, .look = {.albedo = true}, .map_bytes = 9},
    {"exact albedo 888", WHAT("the same, RGB888"), EXACT, .look = {.format = GLINT_RGB888, .albedo = true}, .map_bytes = 9, .once = true},
    {"exact gloss", WHAT("exact rect, gloss"), EXACT, .look = {.gloss = true}, .map_bytes = 7, .once = true},
    {"exact span 16", WHAT("glint_shade_prepared_span, spans of 16"),
     exact_fill, exact_frame, .prepare = bench_spans_16, .shade = exact_span, .step = 4},
    {"exact span 64", WHAT("the same, spans of 64"),
     exact_fill, exact_frame, .prepare = bench_spans_64, .shade = exact_span, .step = 4},
    {"exact span 16, call", WHAT("glint_shade_span, which prepares"), .prepare = bench_spans_16, .shade = exact_span_call, .step = 4, .once = true},
    {"exact directional", WHAT("glint_shade_lights, one directional light"), LIGHTS, .look = {.lamps = LAMPS_DIRECTIONAL}},
    {"exact point", WHAT("the same, one white point"), LIGHTS, .look = {.lamps = LAMPS_POINT}},
    {"exact point coloured", WHAT("the same, one coloured point"), LIGHTS, .look = {.lamps = LAMPS_COLOURED}},
    {"exact spot", WHAT("the same, one white spot"), LIGHTS, .look = {.lamps = LAMPS_SPOT}},
    {"exact narrow spot", WHAT("the same, a spot so narrow that most of its edge is drawn in 64 bits"), LIGHTS, .look = {.lamps = LAMPS_NARROW}},
    {"exact four points", WHAT("the same, four white points, near"), LIGHTS, .look = {.lamps = LAMPS_FOUR}},
#ifndef __AVR__
    {"colour span 16", WHAT("glint_tables_span, spans of 16"), colour_fill, .prepare = bench_spans_16, .shade = tables_span},
    {"colour span 64", WHAT("the same, spans of 64"), colour_fill, .prepare = bench_spans_64, .shade = tables_span},
    {"colour int8", WHAT("glint_tables_rect, int8 normals"), colour_fill, tables_frame, .shade = tables_int8, INT8},
    {"colour int10", WHAT("the same, 10-10-10 normals"), colour_fill, tables_frame, .shade = tables_int10, INT10},
    {"colour int16", WHAT("the same, int16 normals"), colour_fill, tables_frame, .shade = tables_int16, INT16},
    {"colour int8 dither", WHAT("colour int8, dithered"), colour_fill, tables_frame, .shade = tables_int8, INT8, .look = {.dither = true}, .once = true},
    {"colour int8 box", WHAT("colour int8, and glint_tables_box for each line"), colour_fill, tables_frame, .prepare = tables_int8_box, .shade = tables_int8, INT8, .once = true},
    {"colour int10 dither", WHAT("colour int10, dithered"), colour_fill, tables_frame, .shade = tables_int10, INT10, .look = {.dither = true}, .once = true},
    {"colour int16 dither", WHAT("colour int16, dithered"), colour_fill, tables_frame, .shade = tables_int16, INT16, .look = {.dither = true}, .once = true},
    {"colour span 16 dither", WHAT("colour span 16, dithered"), colour_fill, .prepare = bench_spans_16, .shade = tables_span, .look = {.dither = true}, .once = true},
    {"albedo int8", WHAT("glint_tables_albedo_rect, int8 normals, RGB565 albedo"),
     albedo_fill, tables_frame, .shade = albedo_int8, .look = {.albedo = true}, .map = MAP_INT8, .map_bytes = 6},
    {"albedo int16", WHAT("the same, int16 normals"),
     albedo_fill, tables_frame, .shade = albedo_int16, .look = {.albedo = true}, .map_bytes = 8},
    {"albedo span 16", WHAT("glint_tables_albedo_span, spans of 16"),
     albedo_fill, .prepare = bench_spans_16, .shade = albedo_span, .look = {.albedo = true}, .map_bytes = 2},
    {"palette", WHAT("glint_palette_rect, 4096 entries by colour int16"), colour_fill, palette_frame, .shade = palette, PALETTE},
#endif
    {"integer power", WHAT("int16 normals, Q15, powers by squaring"),
     .shade = peer_integer_power, INT16, .look = {.model = GLINT_BLINN}},
    {"table power", WHAT("int16 normals, Q15, 256 powers, nearest below"),
     peer_fill, .shade = peer_table_power, INT16, .look = {.model = GLINT_BLINN}},
    {"int8 table power", WHAT("int8 normals, 128 powers, nearest below"),
     peer_int8_fill, .pack = peer_int8_pack, .shade = peer_int8_table_power, .map_bytes = 3, .look = {.model = GLINT_BLINN}},
    {"float MSH", WHAT("float, the whole pixel"), .shade = peer_float_msh, INT16, .step = 16},
    {"float powf", WHAT("float, the whole pixel, the C library's powf"),
     .shade = peer_float_powf, INT16, .look = {.model = GLINT_BLINN}, .step = 32},
    {.name = NULL},
};
/* clang-format on */
