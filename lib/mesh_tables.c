/* SPDX-License-Identifier: MIT
 * A line of a triangle by tables: pixels side by side that are in front are a span. COLOUR tables have loops of their own. */
#include "glint_math_align.h"
#include "glint_math_assembly.h"
#include "glint_mesh_colour.h"
#include "glint_tables_geometry.h"
#include "glint_mesh_path.h"
#include "glint_pixel_exact.h"

/* A span starts on a byte. */
static bool tables_can(const void *with)
{
    const struct glint_tables *tables = (const struct glint_tables *)with;
    return tables && tables->format != GLINT_MONO &&
           (tables->kind == GLINT_TABLES_COLOUR || tables->kind == GLINT_TABLES_SMALL);
}

static void tables_row(const struct glint_tables *tables, struct glint_mesh_row *row)
{
    const unsigned bytes = GLINT_FLASH_U8(glint_exact_formats[tables->format].bytes);
    for (unsigned count; (count = glint_mesh_in_front(row, GLINT_SPAN_MAX)) != 0; row->x += count) {
        const struct glint_span span = {row->t,           row->dt,           row->ddt,
                                        (int32_t)row->nl, (int32_t)row->dnl, (uint16_t)count};
        const struct glint_surface surface = {row->line + bytes * row->x, 0, (uint16_t)(row->left + row->x),
                                              (uint16_t)row->y};
        glint_tables_span(tables, &span, &surface);
        for (unsigned i = 0; i < count; i++)
            glint_mesh_step(row);
    }
}

/* Alone, so that a triangle which needs none of it has no frame for a row. */
__attribute__((noinline)) void glint_mesh_tables_rows(const void *with, struct glint_mesh_triangle *triangle,
                                                      const struct glint_mesh_target *target)
{
    const struct glint_tables *tables = (const struct glint_tables *)with;
    struct glint_mesh_row row;
    while (glint_mesh_row_next(&row, triangle, target))
        tables_row(tables, &row);
}

static uint32_t tables_t_end(const void *with)
{
    return ((const struct glint_tables *)with)->t_max_q30 + 1;
}

/* Two bytes a pixel at even places, without dither. */
static bool tables_are_plain(const struct glint_tables *tables, const struct glint_mesh_target *target)
{
    return tables->kind == GLINT_TABLES_COLOUR && !tables->dither && !GLINT_MISALIGNED(target->surface->pixels, 16) &&
           !GLINT_MISALIGNED(target->surface->stride, 16);
}

void glint_mesh_tables_draw(const void *with, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target)
{
    const struct glint_tables *tables = (const struct glint_tables *)with;
    if (tables_are_plain(tables, target))
        glint_mesh_colour(tables, triangle, target);
    else
        glint_mesh_tables_rows(tables, triangle, target);
}

#if GLINT_CORTEX_M0PLUS_ASM
static bool tables_begin(const void *with, const struct glint_mesh_target *target, struct glint_mesh_lines *lines)
{
    const struct glint_tables *tables = (const struct glint_tables *)with;
    const bool can = tables_are_plain(tables, target);
    if (can && lines)
        glint_mesh_colour_begin(tables, target, lines);
    return can;
}
#define TABLES_BEGIN tables_begin
#else
#define TABLES_BEGIN NULL
#endif

const struct glint_mesh_path glint_mesh_tables GLINT_FLASH = {tables_can, tables_t_end, glint_mesh_tables_draw,
                                                              TABLES_BEGIN};
#undef TABLES_BEGIN
