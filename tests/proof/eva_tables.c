/* SPDX-License-Identifier: MIT
 * For Eva: tables of any material, and what a light makes of them.
 * eva: -eva-precision 1 -eva-min-loop-unroll 24 -eva-slevel 60 -eva-split-return auto -eva-use-spec VALUES */
#include "eva.h"
#include "glint_tables.h"

static uint32_t memory[GLINT_TABLES_DITHER_BYTES / 4];

static void fill(const struct glint_use_tables *kind, bool dither)
{
    for (uint8_t format = 0; format <= GLINT_FORMAT_COUNT; format++) {
        const struct glint_output output = {format, GLINT_GAMMA, dither};
        const struct glint_material material = any_material(GLINT_LYON);
        struct glint_paint paint;
        (void)glint_paint_tables_for(&paint, kind, &material, &output, memory,
                                     glint_tables_bytes((enum glint_tables_kind)kind->kind, dither), &glint_use_lyon,
                                     &glint_use_rgb565);
    }
}
void eva_fill_albedo(void)
{
    fill(&glint_use_albedo, false);
}
void eva_fill_colour_dithered(void)
{
    fill(&glint_use_colour_dithered, true);
}

/* Tables that were filled before: t_max is at most 1, and below what the columns of its shift hold. */
static void light(const struct glint_use_tables *kind, unsigned columns_log)
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
    }
}
void eva_light_colour(void)
{
    light(&glint_use_colour, GLINT_COLOUR_COLUMNS_LOG);
}
void eva_light_colour_dithered(void)
{
    light(&glint_use_colour_dithered, GLINT_DITHER_COLUMNS_LOG);
}
void eva_light_albedo(void)
{
    light(&glint_use_albedo, GLINT_ALBEDO_COLUMNS_LOG);
}
