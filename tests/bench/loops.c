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
#ifndef __AVR__
uint32_t bench_map[SPHERE_W];
struct glint_vec bench_palette[SPHERE_PALETTE];
uint8_t bench_albedo[SPHERE_W][3];
uint16_t bench_albedo_565[SPHERE_W];
#endif

static void check(enum glint_err err)
{
    if (err && !bench_error)
        bench_error = (int16_t)err;
}

void bench_begin(const struct bench_loop *loop, uint32_t n)
{
    bench_error = 0;
    sphere_shader(&bench_shader, (enum glint_model)loop->model, n, (enum glint_format)loop->format, loop->dither);
    if (loop->albedo)
        sphere_grey(&bench_shader);
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
#ifndef __AVR__
        bench_albedo_565[x] = sphere_albedo(x, y);
        sphere_expand(bench_albedo[x], bench_albedo_565[x]);
#endif
    }
}

/* ---- the exact paths ---- */

static void exact(const uint8_t *albedo)
{
    const struct glint_source source = {.normals = bench_line.normals, .albedo = albedo, .mask = bench_line.mask};
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    check(glint_shade_rect(&bench_shader, &source, SPHERE_W, 1, &surface, NULL));
}

static void exact_rect(void)
{
    exact(NULL);
}

/* ---- spans: the line's by pieces of at most so many pixels ---- */

static void spans_prepare(struct glint_span *span, uint16_t width)
{
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + width), span++) {
        const uint16_t left = (uint16_t)(bench_line.to - x), w = left < width ? left : width;
        check(glint_span_init(span, &bench_shader.light, &bench_line.normals[x], &bench_line.normals[x + w - 1], w));
    }
}

static void exact_span_prepare(void)
{
    spans_prepare((struct glint_span *)(void *)bench_memory, 16);
}

static void exact_span(void)
{
    const struct glint_span *span = (const struct glint_span *)(const void *)bench_memory;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
        check(glint_shade_span(&bench_shader, span, &surface, NULL));
    }
}

/* ---- table loops ---- */

static struct glint_tables tables;
static struct glint_tables_light tables_light;

static void small_fill(void)
{
    check(glint_tables_fill(&tables, GLINT_TABLES_SMALL, &bench_shader, bench_memory, GLINT_TABLES_SMALL_BYTES));
}

static void tables_frame(void)
{
    check(glint_tables_light_init(&tables_light, &tables, &bench_shader.light));
}

static void tables_rect(enum glint_normals format, const void *normals)
{
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    check(glint_tables_rect(&tables, &tables_light, format, normals, 0, SPHERE_W, 1, &surface));
}

static void tables_int16(void)
{
    tables_rect(GLINT_NORMALS_INT16, bench_line.normals);
}

#ifndef __AVR__
static void exact_albedo(void)
{
    exact(bench_albedo[0]);
}

/* A lamp, so far away that the picture is much the same. */
static struct glint_lamp lamp;

static void lamp_frame(void)
{
    enum { AWAY = 1 << 21 };
    static const int32_t position[3] = {16 * SPHERE_W / 2 + AWAY, 16 * SPHERE_H / 2 - AWAY, AWAY};
    check(glint_lamp_point(&lamp, position, (uint32_t)GLINT_LAMP_FAR));
    for (uint8_t k = 0; k < 3; k++)
        lamp.color_q16[k] = 99273; /* of it .66 arrive: (1 - 3 / 16)^2 */
}

static void exact_lamp(void)
{
    const struct glint_source source = {.normals = bench_line.normals, .mask = bench_line.mask};
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    check(glint_shade_lights(&bench_shader, &lamp, 1, &source, SPHERE_W, 1, &surface, NULL));
}

static void colour_fill(void)
{
    check(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &bench_shader, bench_memory, GLINT_TABLES_COLOUR_BYTES));
}

/* After the largest tables. */
#define BESIDE_TABLES ((void *)(bench_memory + GLINT_TABLES_COLOUR_BYTES / 4))

static void tables_int10(void)
{
    tables_rect(GLINT_NORMALS_INT10, bench_map);
}

static void tables_int8(void)
{
    tables_rect(GLINT_NORMALS_INT8, bench_map);
}

static void tables_span_16_prepare(void)
{
    spans_prepare(BESIDE_TABLES, 16);
}

static void tables_span_64_prepare(void)
{
    spans_prepare(BESIDE_TABLES, 64);
}

static void tables_span(void)
{
    const struct glint_span *span = BESIDE_TABLES;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
        check(glint_tables_span(&tables, span, &surface));
    }
}

static void albedo_fill(void)
{
    check(glint_tables_fill(&tables, GLINT_TABLES_ALBEDO, &bench_shader, bench_memory, GLINT_TABLES_ALBEDO_BYTES));
}

static void albedo_rect(enum glint_normals format, const void *normals)
{
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    check(glint_tables_albedo_rect(&tables, &tables_light, format, normals, 0, bench_albedo_565, 0, SPHERE_W, 1,
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
    const struct glint_span *span = BESIDE_TABLES;
    for (uint16_t x = bench_line.from; x < bench_line.to; x = (uint16_t)(x + span->w), span++) {
        const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
        check(glint_tables_albedo_span(&tables, span, bench_albedo_565 + x, &surface));
    }
}

static void palette_frame(void)
{
    const struct glint_surface colours = {BESIDE_TABLES, 0, 0, 0};
    tables_frame();
    check(
        glint_tables_rect(&tables, &tables_light, GLINT_NORMALS_INT16, bench_palette, 0, SPHERE_PALETTE, 1, &colours));
}

static void palette(void)
{
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    check(glint_palette_rect(BESIDE_TABLES, (const uint16_t *)(const void *)bench_map, 0, SPHERE_W, 1, &surface));
}
#endif

/* ---- the table ---- */

#define INT16 .map_bytes = sizeof(struct glint_vec)
#define INT10 .map = MAP_INT10, .map_bytes = 4
#define INT8 .map = MAP_INT8, .map_bytes = 4
#define PALETTE .map = MAP_PALETTE, .map_bytes = 2

/* clang-format off */
const struct bench_loop bench_loops[] = {
    {"exact rect", "glint_shade_rect, int16 normals", .shade = exact_rect, INT16, .step = 4},
    {"exact span", "glint_shade_span, spans of 16", .prepare = exact_span_prepare, .shade = exact_span, .step = 4},
    {"small int16", "under 1 KB of RAM, int16 normals", small_fill, tables_frame, .shade = tables_int16, INT16},
#ifndef __AVR__
    {"exact albedo", "exact rect, albedo in RGB888, white light", .shade = exact_albedo, INT16, .albedo = true, .step = 4},
    {"exact lights", "glint_shade_lights, one point light, far away", .frame = lamp_frame, .shade = exact_lamp, INT16, .step = 16},
    {"colour span 16", "glint_tables_span, spans of 16", colour_fill, .prepare = tables_span_16_prepare, .shade = tables_span},
    {"colour span 64", "the same, spans of 64", colour_fill, .prepare = tables_span_64_prepare, .shade = tables_span},
    {"colour int8", "glint_tables_rect, int8 normals", colour_fill, tables_frame, .shade = tables_int8, INT8},
    {"colour int10", "the same, 10-10-10 normals", colour_fill, tables_frame, .shade = tables_int10, INT10},
    {"colour int16", "the same, int16 normals", colour_fill, tables_frame, .shade = tables_int16, INT16},
    {"albedo int8", "glint_tables_albedo_rect, int8 normals, RGB565 albedo",
     albedo_fill, tables_frame, .shade = albedo_int8, .albedo = true, .map = MAP_INT8, .map_bytes = 6},
    {"albedo int16", "the same, int16 normals",
     albedo_fill, tables_frame, .shade = albedo_int16, .albedo = true, .map_bytes = 8},
    {"albedo span 16", "glint_tables_albedo_span, spans of 16",
     albedo_fill, .prepare = tables_span_16_prepare, .shade = albedo_span, .albedo = true, .map_bytes = 2},
    {"palette", "glint_palette_rect, 4096 entries by colour int16", colour_fill, palette_frame, .shade = palette, PALETTE},
#endif
    {"integer power", "int16 normals, Q15, powers by squaring",
     .shade = peer_integer_power, INT16, .model = GLINT_BLINN},
    {"table power", "int16 normals, Q15, 256 powers, nearest below",
     peer_fill, .shade = peer_table_power, INT16, .model = GLINT_BLINN},
    {"int8 table power", "int8 normals, 128 powers, nearest below",
     peer_int8_fill, .pack = peer_int8_pack, .shade = peer_int8_table_power, .map_bytes = 3, .model = GLINT_BLINN},
    {"float MSH", "float, the whole pixel", .shade = peer_float_msh, INT16, .step = 16},
    {"float powf", "float, the whole pixel, the C library's powf",
     .shade = peer_float_powf, INT16, .model = GLINT_BLINN, .step = 32},
    {.name = NULL},
};
/* clang-format on */
