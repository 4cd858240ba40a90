/* SPDX-License-Identifier: MIT
 * Internal. Vertices of a mesh on the screen, and its lights in its own directions. */
#ifndef GLINT_MESH_POSE_H
#define GLINT_MESH_POSE_H

#include "glint_mesh_gradient.h"
#include "glint_mesh_offsets.h"

enum { GLINT_MESH_LEFT = 1, GLINT_MESH_RIGHT = 2, GLINT_MESH_ABOVE = 4, GLINT_MESH_BELOW = 8, GLINT_MESH_NEAR = 16 };

/* Turn, light and half vector from a pose; false where the quaternion is 0. */
bool glint_pose_set(struct glint_mesh_drawn *drawn, const struct glint_pose *pose, const struct glint_light *light);

/* A vertex before the projection: 1/16 pixel, x right, y down, z to the viewer; |.| < 2^18. */
struct glint_mesh_place {
    int32_t x, y, z;
};
struct glint_mesh_place glint_mesh_place_of(const struct glint_mesh_drawn *drawn, unsigned vertex);
void glint_mesh_normal(struct glint_vec *normal, const struct glint_mesh *mesh, unsigned vertex);

/* What glint_mesh_corner calls a side, of two normals. */
uint32_t glint_mesh_side(const struct glint_vec *a, const struct glint_vec *b);
/* Of a face's three, the one opposite each corner. */
void glint_mesh_sides16(struct glint_mesh_corner corner[3], const struct glint_mesh *mesh, const uint16_t face[3]);
void glint_mesh_sides8(struct glint_mesh_corner corner[3], const int8_t *normals, const uint16_t face[3]);
static inline void glint_mesh_sides(struct glint_mesh_corner corner[3], const struct glint_mesh *mesh,
                                    const uint16_t face[3])
{
    if (mesh->normals)
        glint_mesh_sides16(corner, mesh, face);
    else
        glint_mesh_sides8(corner, mesh->normals8, face);
}

/* Beyond the near plane? */
bool glint_mesh_is_near(const struct glint_mesh_frame *frame, int32_t z);

/* A projected place: x, y from the viewport's middle, |.| < 2^22; z the depth, 0 nearest. */
struct glint_mesh_place glint_mesh_project(const struct glint_mesh_frame *frame, struct glint_mesh_place place);

/* t and nl of a normal. */
void glint_mesh_light(struct glint_mesh_vertex *vertex, const struct glint_mesh_drawn *drawn,
                      const struct glint_vec *normal);

/* All vertices; `out` says by which planes they must be clipped. Is there one? */
bool glint_mesh_vertices(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn);

/* The same without perspective for normals of 8 bits, in assembly alone. */
bool glint_mesh_vertices_parallel(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn);

#endif
