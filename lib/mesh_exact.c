/* SPDX-License-Identifier: MIT
 * A line of a triangle by the prepared shader: every format and space. */
#include "glint_mesh_samples.h"

static bool exact_can(const void *with)
{
    return glint_mesh_prepared_can((const struct glint_prepared *)with);
}

static uint32_t exact_t_end(const void *with)
{
    return ((const struct glint_prepared *)with)->near.t_end;
}

static void exact_row(const struct glint_prepared *prepared, struct glint_mesh_row *row, struct glint_sample *samples)
{
    struct glint_run run = {row->line, 0, row->left, row->y, NULL, NULL, NULL};
    for (unsigned count; (count = glint_mesh_in_front(row, GLINT_RUN)) != 0; row->x += count) {
        glint_mesh_samples(row, samples, count);
        run.x = row->x;
        glint_prepared_run(prepared, &run, samples, count);
    }
}

static void exact_draw(const void *with, struct glint_mesh_triangle *triangle, const struct glint_mesh_target *target)
{
    struct glint_mesh_row row;
    while (glint_mesh_row_next(&row, triangle, target))
        exact_row((const struct glint_prepared *)with, &row, target->samples);
}

const struct glint_mesh_path glint_mesh_exact GLINT_FLASH = {exact_can, exact_t_end, exact_draw, NULL};
