/* SPDX-License-Identifier: MIT
 * Internal. What a frame's memory holds: the bench, the depths of a strip, and triangles that go on in the next strip. */
#ifndef GLINT_MESH_STRIP_H
#define GLINT_MESH_STRIP_H

#include "glint_mesh_clip.h"
#include "glint_mesh_path.h"

/* A triangle at the line where the last strip ended, in its mesh's list, which ascends by face, or in that of free ones. */
struct glint_mesh_kept {
    struct glint_mesh_triangle triangle;
    uint16_t face, next; /* GLINT_MESH_NONE: the last */
};

/* What the work on one face takes, so that it is not on the stack. */
struct glint_mesh_bench {
    struct glint_mesh_polygon polygon;
    struct glint_mesh_vertex vertex[3];
    struct glint_mesh_kept face; /* where no place is left, and of a face that is clipped */
    uint8_t fan;                 /* of one that is clipped: vertex is the polygon's corners 0, fan - 1 and fan */
};

/* The number of the face of a triangle that a path draws. */
static inline unsigned glint_mesh_face_of(const struct glint_mesh_triangle *triangle)
{
    return ((const struct glint_mesh_kept *)(const void *)triangle)->face;
}

/* Bytes of depths; what follows is aligned. */
static inline uint32_t glint_mesh_depth_bytes(uint16_t w, uint16_t lines)
{
    return (((uint32_t)w * lines + 1) & ~(uint32_t)1) * 2;
}

/* Makes all depths the farthest; bytes: of glint_mesh_depth_bytes. Has a twin in assembly. */
void glint_mesh_clear(uint16_t *depth, uint32_t bytes);

/* Sets the triangle of a face in a list, which has an area and lines and is not clipped. t_end: as for glint_mesh_shine. Has a twin in
 * assembly. */
void glint_mesh_face_set(struct glint_mesh_triangle *triangle, const struct glint_mesh_drawn *drawn,
                         const uint16_t face[3], uint32_t t_end);

/* In assembly alone: draws a mesh's faces and keeps those that go on, where all paths have lines and nothing is clipped. */
void glint_mesh_strip_lines(const struct glint_mesh_target *strip);

/* Frees what is kept of a mesh. */
void glint_mesh_forget(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn);

#endif
