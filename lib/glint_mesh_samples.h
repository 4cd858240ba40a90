/* SPDX-License-Identifier: MIT
 * Internal. Rows by the prepared shader. */
#ifndef GLINT_MESH_SAMPLES_H
#define GLINT_MESH_SAMPLES_H

#include "glint_mesh_path.h"
#include "glint_pixel.h"
#include "glint_pixel_prepared.h"

/* Can it draw? */
static inline bool glint_mesh_prepared_can(const struct glint_prepared *prepared)
{
    return prepared && !GLINT_FLASH_POINTER(prepared->model->geometry); /* Phong's t is not of this form */
}

/* The next count of them; row goes on after these. */
static inline void glint_mesh_samples(struct glint_mesh_row *row, struct glint_sample *samples, unsigned count)
{
    for (unsigned i = 0; i < count; i++, glint_mesh_step(row)) {
        const uint32_t nl = glint_sample_nl((int32_t)row->nl);
        samples[i].nl_q16 = nl;
        samples[i].t_q30 = nl == 0 ? UINT32_MAX : row->t >= GLINT_NEGATIVE_T ? 0 : row->t;
    }
}

#endif
