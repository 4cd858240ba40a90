/* SPDX-License-Identifier: MIT
 * For Eva: loops over COLOUR and ALBEDO tables as they are filled, of any colours, lights, normals and spans, for every shift. Normals of
 * INT8, and of INT10 with the viewer in front, are left to tests: their row rests on lengths.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 8 */
#include "eva.h"
#include "glint_tables_geometry.h"

enum { WIDE = 5, HIGH = 2, COLUMNS = 1 << GLINT_COLOUR_COLUMNS_LOG, SHINES = 1 << GLINT_ALBEDO_COLUMNS_LOG };
static uint16_t colours[GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS + COLUMNS / 2], albedo[WIDE * HIGH];
static uint32_t levels[GLINT_ALBEDO_LEVELS / 4 + SHINES], pixels[WIDE * HIGH], words[2 * WIDE * HIGH];

/* Columns hold t_max 2^-shift; t is at most 1. */
static uint32_t any_end(uint8_t shift, uint32_t columns)
{
    const uint32_t t_max = any % (GLINT_T_ONE + 1), most = (columns << shift) - 1;
    return t_max > most ? most : t_max;
}

static struct glint_tables of_colours(uint8_t shift)
{
    uint8_t *const columns = (uint8_t *)(colours + GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS);
    ANY_BYTES(colours);
    for (unsigned i = 0; i < COLUMNS; i++)
        columns[i] = (uint8_t)(2 * (any % GLINT_COLOUR_STEPS));
    const struct glint_tables tables = {
        columns, {colours}, any_end(shift, COLUMNS), (uint16_t)any, GLINT_TABLES_COLOUR, GLINT_RGB565, shift, false};
    return tables;
}

static struct glint_tables of_levels(uint8_t shift, uint8_t format)
{
    ANY_BYTES(levels);
    const struct glint_tables tables = {(const uint8_t *)levels + GLINT_ALBEDO_LEVELS,
                                        {.sums = levels + GLINT_ALBEDO_LEVELS / 4},
                                        any_end(shift, SHINES),
                                        (uint16_t)any,
                                        GLINT_TABLES_ALBEDO,
                                        format,
                                        shift,
                                        false};
    return tables;
}

/* As glint_tables_light_init leaves it: x is at most 128 times a component, and y half one. */
static struct glint_tables_light any_turned(uint8_t kind, bool frontal)
{
    const int32_t x = any_signed % 4210689, y = any_signed % 16385, z = any_signed % 16385;
    const struct glint_tables_light light = {any_vector(), any_vector(), x,        y,    z,      any_signed,
                                             any_signed,   any,          any % 32, kind, frontal};
    return light;
}

void eva_colour_spans(void)
{
    for (uint8_t shift = 0; shift <= 19; shift++) {
        const struct glint_tables tables = of_colours(shift);
        const struct glint_surface surface = {pixels, 0, (uint16_t)any, (uint16_t)any};
        for (uint16_t w = 1; w <= WIDE; w++) {
            const struct glint_span span = {any, any, any, any_signed, any_signed, w};
            (void)glint_tables_span(&tables, &span, &surface);
        }
    }
}

static void rect(enum glint_normals format)
{
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        words[i] = any;
    for (uint8_t shift = 0; shift <= 19; shift++) {
        const struct glint_tables tables = of_colours(shift);
        const struct glint_tables_light light = any_turned(GLINT_TABLES_COLOUR, false);
        const struct glint_surface surface = {pixels, 2 * WIDE, (uint16_t)any, (uint16_t)any};
        (void)glint_tables_rect(&tables, &light, format, words, 4 * WIDE, WIDE, HIGH, &surface);
    }
}
void eva_colour_int16(void)
{
    rect(GLINT_NORMALS_INT16);
}
void eva_colour_int10_aside(void)
{
    rect(GLINT_NORMALS_INT10);
}

void eva_albedo_spans(void)
{
    ANY_BYTES(albedo);
    for (uint8_t shift = 0; shift <= 19; shift++) {
        const struct glint_tables tables = of_levels(shift, GLINT_RGB565_SWAPPED);
        const struct glint_surface surface = {pixels, 0, (uint16_t)any, (uint16_t)any};
        const struct glint_span span = {any, any, any, any_signed, any_signed, WIDE};
        (void)glint_tables_albedo_span(&tables, &span, albedo, &surface);
    }
}

static void albedo_rect(enum glint_normals format)
{
    ANY_BYTES(albedo);
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        words[i] = any;
    for (uint8_t shift = 0; shift <= 19; shift++) {
        const struct glint_tables tables = of_levels(shift, GLINT_RGB565);
        const struct glint_tables_light light = any_turned(GLINT_TABLES_ALBEDO, true);
        const struct glint_surface surface = {pixels, 2 * WIDE, (uint16_t)any, (uint16_t)any};
        (void)glint_tables_albedo_rect(&tables, &light, format, words, 4 * WIDE, albedo, 2 * WIDE, WIDE, HIGH,
                                       &surface);
    }
}
void eva_albedo_int16(void)
{
    albedo_rect(GLINT_NORMALS_INT16);
}
void eva_albedo_int10(void)
{
    albedo_rect(GLINT_NORMALS_INT10);
}

/* The box, over tables of every kind. */
static void box(uint8_t kind, enum glint_normals format)
{
    struct glint_box highlight;
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++)
        words[i] = any;
    for (uint8_t shift = 0; shift <= 19; shift++) {
        const uint32_t columns = GLINT_SMALL_SEGMENT << GLINT_SMALL_COARSER,
                       most = kind == GLINT_TABLES_SMALL ? (columns << shift) - 1 : UINT32_MAX, end = any,
                       t_max = end > most ? most : end;
        const struct glint_tables tables = {
            (const uint8_t *)levels, {colours}, t_max, 0, kind, GLINT_RGB565, shift, any & 1};
        const struct glint_tables_light light = any_turned(kind, true), aside = any_turned(kind, false);
        (void)glint_tables_box(&tables, &light, format, words, 4 * WIDE, WIDE, HIGH, &highlight);
        (void)glint_tables_box(&tables, &aside, format, words, 4 * WIDE, WIDE, HIGH, &highlight);
    }
}
void eva_box_int8(void)
{
    for (uint8_t kind = 0; kind <= GLINT_TABLES_ALBEDO; kind++)
        box(kind, GLINT_NORMALS_INT8);
}
void eva_box_int10(void)
{
    for (uint8_t kind = 0; kind <= GLINT_TABLES_ALBEDO; kind++)
        box(kind, GLINT_NORMALS_INT10);
}
void eva_box_int16(void)
{
    for (uint8_t kind = 0; kind <= GLINT_TABLES_ALBEDO; kind++)
        box(kind, GLINT_NORMALS_INT16);
}
