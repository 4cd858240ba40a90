/* SPDX-License-Identifier: MIT
 * A line of a triangle by tables: pixels side by side that are in front are a span. Triangles' lines are short, so that COLOUR tables
 * have a loop of their own, which asks each pixel for its depth and draws it at once. */
#include "glint_loops_look.h"
#include "glint_math_align.h"
#include "glint_mesh_path.h"

/* A span starts on a byte. */
static bool tables_can(const void *with, const struct glint_surface *surface)
{
    const struct glint_tables *tables = (const struct glint_tables *)with;
    return tables && surface->pixels && tables->format != GLINT_MONO &&
           (tables->kind == GLINT_TABLES_COLOUR || tables->kind == GLINT_TABLES_SMALL);
}

/* A span's pixels, those in front. */
static void tables_colour_row(const struct glint_tables *tables, const struct glint_mesh_row *row)
{
    const struct glint_look look = glint_look_up(tables);
    const uint32_t ddt = row->ddt, dnl = row->dnl, dz = row->dz;
    uint32_t back = look.t_max - row->t, dt = row->dt, nl = row->nl, z = row->z;
    uint16_t *depth = row->depth + row->x, *out = (uint16_t *)(void *)(row->line + 2 * row->x);
    for (const uint16_t *const end = row->depth + row->end; depth != end; depth++, out++) {
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            glint_look_store(&look, back, nl, out);
        }
        z += dz;
        back -= dt;
        dt += ddt;
        nl += dnl;
    }
}

static void tables_row(const void *with, struct glint_mesh_row *row)
{
    const struct glint_tables *tables = (const struct glint_tables *)with;
    const unsigned bytes = tables->format <= GLINT_RGB565_SWAPPED ? 2 : tables->format == GLINT_RGB888 ? 3 : 1;
    if (tables->kind == GLINT_TABLES_COLOUR && !tables->dither && !GLINT_MISALIGNED(row->line, 16)) {
        tables_colour_row(tables, row);
        return;
    }
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

const struct glint_mesh_path glint_mesh_tables = {tables_can, tables_row};
