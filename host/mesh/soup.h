/* SPDX-License-Identifier: MIT
 * Triangles as files have them: each with its own corners. */
#ifndef GLINT_MESH_SOUP_H
#define GLINT_MESH_SOUP_H

#include "mesh/mesh.h"

struct soup_face {
    double places[3][3], normals[3][3];
    double uv[3][2];      /* of its part's picture; v down */
    uint8_t colors[3][3]; /* as encoded */
    uint32_t part;
};
struct soup {
    char *name; /* for messages */
    size_t face_count;
    struct soup_face *faces;
    bool has_normals; /* a corner without one has none of a length */
    bool has_colors, has_uv;
    bool has_facet_colors; /* which nothing here reads */
    bool is_stl;           /* its normals are those of its facets, and its z axis points up */
    unsigned part_count;
    struct mesh_material *materials; /* of each part */
    unsigned picture_count;
    struct mesh_picture *pictures; /* rgb NULL: it could not be read */
};
void soup_free(struct soup *soup);

/* Of what was read: these end the program through fail() where no mesh is made of it. */
void soup_check_count(const char *name, uint64_t face_count);
void soup_check_faces(const struct soup *soup);
void soup_check_uv(const struct soup *soup);

#endif
