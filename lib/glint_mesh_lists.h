/* SPDX-License-Identifier: MIT
 * Internal. Which faces a strip meets. */
#ifndef GLINT_MESH_LISTS_H
#define GLINT_MESH_LISTS_H

#include "glint_mesh.h"
#include "glint_mesh_offsets.h"

/* Must it be clipped? */
static inline bool glint_mesh_face_is_out(const struct glint_mesh_drawn *drawn, const uint16_t face[3])
{
    const struct glint_mesh_vertex *v = drawn->vertices;
    return (v[face[0]].out | v[face[1]].out | v[face[2]].out) != 0;
}

/* Sorts the faces that show from line y on into the bands where they begin, or where y is; each list ascends. */
void glint_mesh_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y);
/* Into bands that may have faces of higher numbers. Has a twin in assembly. */
void glint_mesh_sort_faces(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y);

/* Takes the lists of the bands from line y to end - 1 as one that ascends. */
uint16_t glint_mesh_take(const struct glint_mesh_drawn *drawn, int32_t y, int32_t end);
/* Gives a list that ascends to the band of line y. */
void glint_mesh_give(const struct glint_mesh_drawn *drawn, uint16_t list, int32_t y);

#endif
