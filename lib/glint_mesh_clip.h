/* SPDX-License-Identifier: MIT
 * Internal. Triangles that reach beyond the near plane or the guard band. */
#ifndef GLINT_MESH_CLIP_H
#define GLINT_MESH_CLIP_H

#include "glint_lobe_near.h"
#include "glint_mesh_gradient.h"
#include "glint_mesh_pose.h"

#define GLINT_MESH_POLYGON 8 /* 3 corners, and one more for each of 5 planes */

struct glint_mesh_clipped {
    struct glint_mesh_place at;
    struct glint_vec normal;
    uint16_t weight[2]; /* of the face's corners 1 and 2, Q15 */
};
/* A polygon in work: each plane clips from one list of corners to the other. The one that then is free holds the samples of a line. */
union glint_mesh_list {
    struct glint_mesh_clipped corner[GLINT_MESH_POLYGON];
    struct glint_sample samples[GLINT_RUN];
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
