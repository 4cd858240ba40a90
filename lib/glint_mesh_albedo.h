/* SPDX-License-Identifier: MIT
 * Internal. A mesh's colours at the pixels of a triangle. */
#ifndef GLINT_MESH_ALBEDO_H
#define GLINT_MESH_ALBEDO_H

#include "glint_mesh_across.h"

/* Is there one array of colours? */
static inline bool glint_mesh_albedo_can(const struct glint_mesh_albedo *albedo)
{
    return albedo && albedo->with && !albedo->of_vertices != !albedo->of_faces;
}

/* The colours of a triangle. */
void glint_mesh_albedo_set(struct glint_mesh_across *across, const uint8_t *of_vertices, const uint8_t *of_faces,
                           const struct glint_mesh_target *target, const struct glint_mesh_triangle *triangle);

/* Those of count pixels from x on: red, green, blue. */
void glint_mesh_albedo_get(const struct glint_mesh_across *across, int32_t x, int32_t y, uint8_t *out, unsigned count);

#endif
