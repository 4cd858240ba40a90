/* SPDX-License-Identifier: MIT
 * A line of a triangle by the prepared shader: every format and space. */
#include "glint_math_flash.h"
#include "glint_mesh_path.h"
#include "glint_pixel.h"
#include "glint_pixel_prepared.h"

static bool exact_can(const void *with, const struct glint_surface *surface)
{
    const struct glint_prepared *prepared = (const struct glint_prepared *)with;
    return prepared && surface->pixels &&
           !GLINT_FLASH_POINTER(prepared->model->geometry); /* Phong's t is not of this form */
}

static void exact_row(const void *with, struct glint_mesh_row *row)
{
    const struct glint_prepared *prepared = (const struct glint_prepared *)with;
    struct glint_run run = {row->line, 0, row->left, row->y, NULL, NULL};
    struct glint_sample *samples = row->samples;
    for (unsigned count; (count = glint_mesh_in_front(row, GLINT_RUN)) != 0; row->x += count) {
        for (unsigned i = 0; i < count; i++, glint_mesh_step(row)) {
            const uint32_t nl = glint_sample_nl((int32_t)row->nl);
            samples[i].nl_q16 = nl;
            samples[i].t_q30 = nl == 0 ? UINT32_MAX : row->t >= GLINT_NEGATIVE_T ? 0 : row->t;
        }
        run.x = row->x;
        glint_prepared_run(prepared, &run, samples, count);
    }
}

const struct glint_mesh_path glint_mesh_exact = {exact_can, exact_row};
