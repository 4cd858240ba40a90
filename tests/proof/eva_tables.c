/* SPDX-License-Identifier: MIT
 * For Eva: tables of any shader, lights for them, and the loops over SMALL tables and palettes.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 8 -eva-use-spec glint_msh_t,glint_schlick_t,glint_blinn_t,glint_gauss_t,glint_cayley_t,glint_lyon_t */
#include "eva.h"
#include "glint_loops_palette.h"
#include "glint_tables_geometry.h"

enum { WIDE = 5, HIGH = 2 };
static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];
static uint32_t pixels[WIDE * HIGH];
static uint16_t albedo[WIDE * HIGH];
static uint32_t words[2 * WIDE * HIGH];

static void fill(enum glint_tables_kind kind, uint8_t space, bool dither)
{
    for (uint8_t format = 0; format <= GLINT_FORMAT_COUNT; format++) {
        const struct glint_shader shader = any_shader(format, space, dither);
        struct glint_tables tables;
        (void)glint_tables_fill(&tables, kind, &shader, memory, glint_tables_bytes(kind) + (dither ? 128 : 0));
    }
}
void eva_fill_small(void)
{
    fill(GLINT_TABLES_SMALL, GLINT_GAMMA, any & 1);
}
void eva_fill_albedo(void)
{
    fill(GLINT_TABLES_ALBEDO, GLINT_GAMMA, false);
}

void eva_fill_colour_dithered(void)
{
    fill(GLINT_TABLES_COLOUR, GLINT_GAMMA, true);
}

/* SMALL tables as they are filled. */
static void small(struct glint_tables *tables, uint8_t format, uint8_t shift)
{
    static uint8_t columns[2 * GLINT_SMALL_SEGMENT];
    for (unsigned i = 0; i < sizeof memory / sizeof *memory; i++)
        memory[i] = any;
    for (unsigned i = 0; i < sizeof columns; i++)
        columns[i] = (uint8_t)(any % GLINT_COLOUR_STEPS);
    const uint32_t t_max = any, most = GLINT_SMALL_SEGMENT << GLINT_SMALL_COARSER; /* of t_max >> shift */
    const struct glint_tables filled = {
        columns, {.sums = memory}, shift < 21 && t_max >= most << shift ? 0 : t_max, 0, GLINT_TABLES_SMALL, format,
        shift,   any & 1};
    *tables = filled;
}

static void draw(enum glint_normals normals, uint8_t format, uint8_t shift)
{
    struct glint_tables tables;
    small(&tables, format, shift);
    const struct glint_light from = any_light();
    const struct glint_span span = {any, any, any, any_signed, any_signed, WIDE};
    const struct glint_surface surface = {pixels, 4 * WIDE, (uint16_t)any, (uint16_t)any};
    struct glint_tables_light light;
    (void)glint_tables_light_init(&light, &tables, &from);
    (void)glint_tables_rect(&tables, &light, normals, words, 4 * WIDE, WIDE, HIGH, &surface);
    (void)glint_tables_span(&tables, &span, &surface);
}

/* The shift decides the column alone, and the format the pixel. */
static void loops(enum glint_normals normals)
{
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        words[i] = any;
    for (uint8_t format = 0; format < GLINT_FORMAT_COUNT; format++)
        draw(normals, format, 0);
    for (uint8_t shift = 1; shift <= 21; shift++)
        draw(normals, GLINT_RGB565, shift);
}
void eva_small_int8(void)
{
    loops(GLINT_NORMALS_INT8);
}
void eva_small_int10(void)
{
    loops(GLINT_NORMALS_INT10);
}
void eva_small_int16(void)
{
    loops(GLINT_NORMALS_INT16);
}

/* A light for tables of every kind: t_max is at most 1, and below what the columns of its shift hold. */
void eva_tables_light_init(void)
{
    for (uint8_t kind = 0; kind <= GLINT_TABLES_ALBEDO; kind++)
        for (uint8_t shift = 0; shift < 20; shift++) {
            const uint32_t t_max = any, most = shift < 18 ? (uint32_t)4096 << shift : GLINT_T_ONE;
            const struct glint_light from = any_light();
            const struct glint_tables tables = {NULL,  {NULL}, t_max > most ? most : t_max, 0, kind, (uint8_t)any,
                                                shift, any & 1};
            struct glint_tables_light light;
            (void)glint_tables_light_init(&light, &tables, &from);
        }
}

/* Offsets even and inside, as the manual asks. */
void eva_palette(void)
{
    static uint16_t colours[32];
    ANY_BYTES(colours);
    for (unsigned i = 0; i < WIDE * HIGH; i++)
        albedo[i] = (uint16_t)(2 * (any % 32));
    const struct glint_surface surface = {pixels, 2 * WIDE, 0, 0};
    (void)glint_palette_rect(colours, albedo, 2 * WIDE, WIDE, HIGH, &surface);
}
