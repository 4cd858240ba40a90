/* SPDX-License-Identifier: MIT
 * For Eva: tables of any material, and what a light makes of them.
 * eva: -eva-precision 1 -eva-min-loop-unroll 8 -eva-slevel 60 -eva-slevel-function colour_draw:0,colour_fill_rows:0 -eva-split-return auto -eva-use-spec VALUES */
#include "eva.h"
#include "glint_tables.h"
#include "tables_colour.c" /* in its place */

/* Each ends where its tables do. */
static uint32_t colour[GLINT_TABLES_COLOUR_BYTES / 4], dithered[GLINT_TABLES_DITHER_BYTES / 4],
    albedo[GLINT_TABLES_ALBEDO_BYTES / 4];

static void fill(const struct glint_use_tables *kind, uint32_t *memory)
{
    const struct glint_output output = {(uint8_t)(any % (GLINT_FORMAT_COUNT + 1)), GLINT_GAMMA, kind->dither};
    const struct glint_material material = any_material(GLINT_LYON);
    struct glint_paint paint;
    (void)glint_paint_tables_for(&paint, kind, &material, &output, memory, kind->bytes, &glint_use_lyon,
                                 &glint_use_rgb565);
}
void eva_fill_albedo(void)
{
    fill(&glint_use_albedo, albedo);
}
void eva_fill_colour(void)
{
    fill(&glint_use_colour, colour);
}
void eva_fill_colour_dithered(void)
{
    fill(&glint_use_colour_dithered, dithered);
}

/* In linear space a run of any row, as colour_fill_rows makes it; its loops are those above. */
void eva_fill_colour_linear(void)
{
    const struct glint_output output = {any & 1 ? GLINT_RGB565 : GLINT_RGB565_SWAPPED, GLINT_LINEAR, false};
    const struct glint_material material = any_material(GLINT_LYON);
    struct glint_paint paint;
    struct glint_sample samples[COLOUR_RUN];
    struct glint_run run = {NULL, 0, 0, 0, NULL, NULL, NULL, 0, &glint_use_linear, NULL};
    if (glint_paint_exact_for(&paint, &material, &output, &glint_use_lyon, &glint_use_linear))
        return;
    for (unsigned i = 0; i < COLOUR_RUN; i++) {
        samples[i].f_q16 = any % 67110;
        samples[i].nl_q16 = any % 65537;
    }
    run.x = COLOUR_RUN * (any % (GLINT_COLOUR_STEPS / COLOUR_RUN));
    run.y = any % GLINT_COLOUR_ROWS;
    run.line = (uint8_t *)colour + 2 * GLINT_COLOUR_STEPS * run.y;
    colour_draw(&paint, &run, samples, COLOUR_RUN);
}

/* Tables that were filled before, and how far x, y and z may reach, which eva_looks.c takes for given: t_max is at most 1, and below what the columns of its shift hold. */
static void light(const struct glint_use_tables *kind, unsigned columns_log, int32_t x, int32_t y)
{
    for (uint8_t shift = 0; shift < 32 - columns_log; shift++) {
        const uint32_t t_max = any, columns = (uint32_t)1 << columns_log,
                       most = shift < 30 - columns_log ? columns << shift : GLINT_T_ONE;
        const struct glint_tables tables = {
            NULL, {NULL}, t_max > most ? most : t_max, 0, kind->kind, GLINT_RGB565, shift, kind->dither, 60, kind};
        struct glint_paint paint;
        paint.of.tables.filled = tables;
        paint.l = any_vector();
        paint.v = any_vector();
        paint.h = any_vector();
        kind->light(&paint);
        /*@ assert -x <= paint.of.tables.x <= x && -y <= paint.of.tables.y <= y && -y <= paint.of.tables.z <= y; */
    }
}
void eva_light_colour(void)
{
    light(&glint_use_colour, GLINT_COLOUR_COLUMNS_LOG, 4210688, 16384);
}
void eva_light_colour_dithered(void)
{
    light(&glint_use_colour_dithered, GLINT_DITHER_COLUMNS_LOG, 4210688, 16384);
}
void eva_light_albedo(void)
{
    light(&glint_use_albedo, GLINT_ALBEDO_COLUMNS_LOG, 263168, 1024);
}
