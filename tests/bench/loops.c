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
uint8_t bench_albedo[SCENE_W][3];
#endif

static void check(enum glint_err err)
{
    if (err && !bench_error)
        bench_error = (int16_t)err;
}

void bench_begin(const struct bench_loop *loop, uint32_t n)
{
    bench_error = 0;
    scene_shader(&bench_shader, (enum glint_model)loop->model, n, (enum glint_format)loop->format, loop->dither);
}

void bench_line_begin(uint16_t y)
{
    struct bench_line *line = &bench_line;
    line->y = y;
    line->from = line->to = 0;
    for (uint16_t x = 0; x < SCENE_W; x++) {
        const struct glint_vec *n = &line->normals[x];
        line->mask[x] = n->x || n->y || n->z ? 255 : 0;
        if (line->mask[x]) {
            line->from = line->to ? line->from : x;
            line->to = (uint16_t)(x + 1);
        }
    }
}

/* ---- the exact paths ---- */

static void exact_rect(void)
{
    const struct glint_source source = {.normals = bench_line.normals, .mask = bench_line.mask};
    const struct glint_surface surface = {bench_line.out, 0, 0, bench_line.y};
    check(glint_shade_rect(&bench_shader, &source, SCENE_W, 1, &surface, NULL));
}

enum { SPAN_W = 16 };

/* From the line's normals, by pieces of at most SPAN_W pixels. */
static void span_prepare(struct glint_span *span)
{
    for (uint16_t x = bench_line.from; x < bench_line.to; x += SPAN_W, span++) {
        const uint16_t left = (uint16_t)(bench_line.to - x), w = left < SPAN_W ? left : SPAN_W;
        check(glint_span_init(span, &bench_shader.light, &bench_line.normals[x], &bench_line.normals[x + w - 1], w));
    }
}

static void exact_span_prepare(void)
{
    span_prepare((struct glint_span *)(void *)bench_memory);
}

static void exact_span(void)
{
    const struct glint_span *span = (const struct glint_span *)(const void *)bench_memory;
    for (uint16_t x = bench_line.from; x < bench_line.to; x += SPAN_W, span++) {
        const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
        check(glint_shade_span(&bench_shader, span, &surface, NULL));
    }
}

/* ---- the table loops ---- */

static struct glint_tables tables;
static struct glint_tables_light tables_light;

static void tables_frame(void)
{
    check(glint_tables_light(&tables_light, &tables, &bench_shader.light));
}

static void small_fill(void)
{
    check(glint_tables_fill(&tables, GLINT_TABLES_SMALL, &bench_shader, bench_memory, GLINT_TABLES_SMALL_BYTES));
}

static void tables_rect(enum glint_normals format, const void *normals)
{
    const uint16_t from = bench_line.from, w = (uint16_t)(bench_line.to - from);
    const size_t bytes = format == GLINT_NORMALS_INT16 ? sizeof(struct glint_vec) : sizeof(uint32_t);
    const struct glint_surface surface = {bench_line.out + from, 0, from, bench_line.y};
    check(
        glint_tables_rect(&tables, &tables_light, format, (const uint8_t *)normals + from * bytes, 0, w, 1, &surface));
}

static void tables_int16(void)
{
    tables_rect(GLINT_NORMALS_INT16, bench_line.normals);
}

#ifndef __AVR__
/* After the largest tables: the line's normals as words, or its spans. */
#define PACKED (bench_memory + GLINT_TABLES_COLOUR_BYTES / 4)

static void colour_fill(void)
{
    check(glint_tables_fill(&tables, GLINT_TABLES_COLOUR, &bench_shader, bench_memory, GLINT_TABLES_COLOUR_BYTES));
}

static void pack(enum glint_normals format)
{
    for (uint16_t x = 0; x < SCENE_W; x++)
        PACKED[x] = glint_normals_pack(format, &bench_line.normals[x]);
}

static void int10_pack(void)
{
    pack(GLINT_NORMALS_INT10);
}

static void int8_pack(void)
{
    pack(GLINT_NORMALS_INT8);
}

static void tables_int10(void)
{
    tables_rect(GLINT_NORMALS_INT10, PACKED);
}

static void tables_int8(void)
{
    tables_rect(GLINT_NORMALS_INT8, PACKED);
}

static void tables_span_prepare(void)
{
    span_prepare((struct glint_span *)(void *)PACKED);
}

static void tables_span(void)
{
    const struct glint_span *span = (const struct glint_span *)(const void *)PACKED;
    for (uint16_t x = bench_line.from; x < bench_line.to; x += SPAN_W, span++) {
        const struct glint_surface surface = {bench_line.out + x, 0, x, bench_line.y};
        check(glint_tables_span(&tables, span, &surface));
    }
}
#endif

/* ---- the table ---- */

#define PEER .model = GLINT_BLINN, .map_bytes = sizeof(struct glint_vec)
#define WHOLE_MAP .map_bytes = sizeof(struct glint_vec)

const struct bench_loop bench_loops[] = {
    {"exact rect", "glint_shade_rect, int16 normals", .shade = exact_rect, WHOLE_MAP, .step = 4},
    {"exact span", "glint_shade_span, spans of 16", .prepare = exact_span_prepare, .shade = exact_span, .step = 4},
#ifndef __AVR__
    {"colour span", "glint_tables_span, spans of 16", .fill = colour_fill, .prepare = tables_span_prepare,
     .shade = tables_span},
    {"colour int8", "glint_tables_rect, int8 normals", .fill = colour_fill, .frame = tables_frame, .pack = int8_pack,
     .shade = tables_int8, .map_bytes = 4},
    {"colour int10", "glint_tables_rect, 10-10-10 normals", .fill = colour_fill, .frame = tables_frame,
     .pack = int10_pack, .shade = tables_int10, .map_bytes = 4},
    {"colour int16", "glint_tables_rect, int16 normals", .fill = colour_fill, .frame = tables_frame,
     .shade = tables_int16, WHOLE_MAP},
#endif
    {"small int16", "under 1 KB of RAM, int16 normals", .fill = small_fill, .frame = tables_frame,
     .shade = tables_int16, WHOLE_MAP},
    {"integer power", "int16 normals, Q15, powers by squaring", .shade = peer_integer_power, PEER},
    {"table power", "int16 normals, Q15, 256 powers, nearest below", .fill = peer_fill, .shade = peer_table_power,
     PEER},
    {"int8 table power", "int8 normals, 128 powers, nearest below", .fill = peer_int8_fill, .pack = peer_int8_pack,
     .shade = peer_int8_table_power, .model = GLINT_BLINN, .map_bytes = 3},
    {"float MSH", "float, the whole pixel", .shade = peer_float_msh, .model = GLINT_MSH, WHOLE_MAP, .step = 16},
    {"float powf", "float, the whole pixel, the C library's powf", .shade = peer_float_powf, PEER, .step = 32},
    {.name = NULL},
};
