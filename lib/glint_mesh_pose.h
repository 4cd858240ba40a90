/* SPDX-License-Identifier: MIT
 * Internal. Vertices of a mesh on the screen, its lights in its own directions, and faces that reach beyond the near plane or the guard band. */
#ifndef GLINT_MESH_POSE_H
#define GLINT_MESH_POSE_H

#include "glint_mesh_triangle.h"
#include "glint_offsets.h"
#include "glint_sample.h"

enum { GLINT_MESH_LEFT = 1, GLINT_MESH_RIGHT = 2, GLINT_MESH_ABOVE = 4, GLINT_MESH_BELOW = 8, GLINT_MESH_NEAR = 16 };

/* Turn, light and half vector from a pose; false where the quaternion is 0. */
bool glint_pose_set(struct glint_mesh_drawn *drawn, const struct glint_pose *pose, const struct glint_paint *paint);

/* A vertex before the projection: 1/16 pixel, x right, y down, z to the viewer; |.| < 2^18. */
struct glint_mesh_place {
    int32_t x, y, z;
};
struct glint_mesh_place glint_mesh_place_of(const struct glint_mesh_drawn *drawn, unsigned vertex);
void glint_mesh_normal(struct glint_vec *normal, const struct glint_mesh *mesh, unsigned vertex);

/* To Q1.15, within +-32767. */
static inline int16_t glint_mesh_held(int32_t x)
{
    return (int16_t)(x > INT16_MAX ? INT16_MAX : x < -INT16_MAX ? -INT16_MAX : x);
}
/* A component of a direction of the mesh as the mesh is turned, of which row is a row: |sum| <= 3 2^29. */
static inline int16_t glint_mesh_turned(const int16_t row[3], int32_t x, int32_t y, int32_t z)
{
    return glint_mesh_held((row[0] * x + row[1] * y + row[2] * z + 8192) >> 14);
}

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

/* Triangles that reach beyond the near plane or the guard band. */

#define GLINT_MESH_RUN 16u   /* samples that a row makes at a time, up to GLINT_RUN */
#define GLINT_MESH_POLYGON 8 /* 3 corners, and one more for each of 5 planes */

struct glint_mesh_clipped {
    struct glint_mesh_place at;
    struct glint_vec normal;
    uint16_t weight[2]; /* of the face's corners 1 and 2, Q15 */
};
/* A polygon in work: each plane clips from one list of corners to the other. The one that then is free holds the samples of a line. */
union glint_mesh_list {
    struct glint_mesh_clipped corner[GLINT_MESH_POLYGON];
    struct glint_sample samples[GLINT_MESH_RUN];
};
struct glint_mesh_polygon {
    union glint_mesh_list list[2];
    uint8_t now; /* which of them holds it */
};

/* What is clipped by all planes, the near one only under perspective, stands in list[0] after an even number of them. */
static inline struct glint_sample *glint_mesh_polygon_samples(struct glint_mesh_polygon *polygon,
                                                              const struct glint_mesh_frame *frame)
{
    return polygon->list[frame->distance ? 0 : 1].samples;
}

/* Clips a face: the count of corners of what is left, at least 3, or 0; they stand in list[now], projected. */
unsigned glint_mesh_clip(struct glint_mesh_polygon *polygon, const struct glint_mesh_frame *frame,
                         const struct glint_mesh_drawn *drawn, const uint16_t face[3]);

/* One of them as a vertex. */
void glint_mesh_clip_vertex(struct glint_mesh_vertex *vertex, const struct glint_mesh_frame *frame,
                            const struct glint_mesh_drawn *drawn, const struct glint_mesh_clipped *clipped);

#endif
