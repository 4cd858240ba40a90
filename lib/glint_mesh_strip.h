/* SPDX-License-Identifier: MIT
 * Internal. A strip: what a frame's memory holds, which faces a strip meets, and triangles that go on in the next strip. */
#ifndef GLINT_MESH_STRIP_H
#define GLINT_MESH_STRIP_H

#include "glint_mesh_pose.h"
#include "glint_mesh_rows.h"
#include "glint_mesh_texture.h"
#include "glint_mesh.h"
#include "glint_offsets.h"

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
    struct glint_mesh_laid laid; /* of a triangle that is not kept; behind face */
    struct glint_mesh_kept copy; /* of a triangle that has no room for it; and what is laid, behind it */
    struct glint_mesh_laid copied;
    uint8_t fan; /* of one that is clipped: vertex is the polygon's corners 0, fan - 1 and fan */
    union {      /* the mesh's colours or texture over the triangle at hand, and colours of a run */
        struct glint_mesh_across across;
        struct glint_mesh_over over;
    } of;
    uint16_t colours[(3 * GLINT_MESH_RUN + 1) / 2]; /* bytes, aligned */
};

/* A kept triangle's place has room for a struct glint_mesh_laid behind it if a mesh of the frame asks for that. */
#define GLINT_MESH_LAID_SIZE (GLINT_MESH_KEPT_SIZE + sizeof(struct glint_mesh_laid))
static inline struct glint_mesh_kept *glint_mesh_kept_at(const struct glint_mesh_frame *frame, uint16_t place)
{
    return (struct glint_mesh_kept *)(void *)((uint8_t *)frame->kept + (size_t)place * frame->kept_bytes);
}

/* ---- Outlines ---- */

/* Bytes that they take beside a mesh's. */
uint32_t glint_mesh_edges_bytes(const struct glint_mesh *mesh, uint16_t h);

/* In assembly alone: hides the cells that a triangle's face leaves out; false: the triangle is drawn. */
bool glint_mesh_hide(struct glint_mesh_triangle *triangle, const struct glint_mesh_target *strip);
/* In assembly alone: what struct glint_mesh_lines calls, with outlines. */
void glint_mesh_outlined(void);

/* What a picture with outlines does otherwise than one without. */
struct glint_use_outlines {
    /* Marks the mesh's faces, and sorts it. */
    void (*add)(const struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn);
    /* Sorts the outlines, after glint_mesh_sort. */
    void (*sort)(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y);
    /* Before the mesh's faces in a strip: sets its outlines there, and `rows`. */
    void (*begin)(struct glint_mesh_target *strip);
    /* The mesh's outlines in a strip, after the faces of all meshes. */
    void (*end)(const struct glint_mesh_target *strip);
    /* In assembly alone: after glint_mesh_part_lines, what draws a triangle's lines becomes what draws with outlines. */
    void (*lines)(const struct glint_mesh_target *strip, struct glint_mesh_lines *lines);
};

/* The number of the face of a triangle that a path draws. */
static inline unsigned glint_mesh_face_of(const struct glint_mesh_triangle *triangle)
{
    return ((const struct glint_mesh_kept *)(const void *)triangle)->face;
}

/* Of a picture; its last may be of fewer lines. */
static inline uint32_t glint_mesh_bands(uint16_t h)
{
    return (h + GLINT_MESH_BAND - 1u) / GLINT_MESH_BAND;
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

/* In assembly alone: draws a mesh's faces and keeps those that go on, where all paints have fused lines and nothing is clipped. It takes from
 * glint_mesh_part_lines what a part's lines need: from which t on nothing shines, and 2^31 where slopes are laid behind triangles; and *lines. */
void glint_mesh_strip_lines(const struct glint_mesh_target *strip);
uint32_t glint_mesh_part_lines(const struct glint_mesh_target *strip, unsigned part, struct glint_mesh_lines *lines);

/* Makes all places free. */
void glint_mesh_places(struct glint_mesh_frame *frame);

/* Frees what is kept of a mesh. */
void glint_mesh_forget(struct glint_mesh_frame *frame, struct glint_mesh_drawn *drawn);

/* Which faces a strip meets. */

/* Must it be clipped? */
static inline bool glint_mesh_face_is_out(const struct glint_mesh_drawn *drawn, const uint16_t face[3])
{
    const struct glint_mesh_vertex *v = drawn->vertices;
    return (v[face[0]].out | v[face[1]].out | v[face[2]].out) != 0;
}

/* Of a face that must be: the edge, as its first corner, whose ends need not be; 3: there is none. */
static inline unsigned glint_mesh_edge_in(const struct glint_mesh_drawn *drawn, unsigned face)
{
    const uint16_t *const of = drawn->mesh->faces + 3 * (size_t)face;
    const bool a = drawn->vertices[of[0]].out, b = drawn->vertices[of[1]].out, c = drawn->vertices[of[2]].out;
    return a + b + c > 1 ? 3 : a ? 1 : b ? 2 : 0;
}

/* Where there is such an edge: clips the face. Does its fan's largest triangle show? Then that beside the edge is on the bench as the one at
 * hand; the largest where rounding has turned that one over. */
bool glint_mesh_fan_shows(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, unsigned face);

/* Sorts the faces that show from line y on into the bands where they begin, or where y is; each list ascends. */
void glint_mesh_sort(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y);
/* Into bands that may have faces of higher numbers; in edges it marks fronts and what is clipped. Has a twin in assembly. */
void glint_mesh_sort_faces(const struct glint_mesh_frame *frame, const struct glint_mesh_drawn *drawn, int32_t y);

/* Takes the lists of the bands from line y to end - 1 as one that ascends. */
uint16_t glint_mesh_take(const struct glint_mesh_drawn *drawn, int32_t y, int32_t end);
/* Gives a list that ascends to the band of line y. */
void glint_mesh_give(const struct glint_mesh_drawn *drawn, uint16_t list, int32_t y);

#endif
