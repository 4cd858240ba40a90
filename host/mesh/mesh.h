/* SPDX-License-Identifier: MIT
 * Meshes in double precision, before they are fitted to what the library reads. */
#ifndef GLINT_MESH_MESH_H
#define GLINT_MESH_MESH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a file says about a part's surface; what it does not say is left to the command. */
struct mesh_material {
    bool has_color, unlit;
    uint8_t color[3];
    unsigned n; /* 0: not said */
};

/* x right, y up, z to the viewer. Vertices of one place differ by their normals, where the surface has a crease, or by their colours. */
struct mesh {
    char *name; /* for messages */
    size_t vertex_count, face_count, place_count;
    double (*places)[3], (*normals)[3];  /* of each vertex; normals have length 1 */
    uint8_t (*colors)[3];                /* of each vertex, as encoded; NULL: each part has one */
    uint32_t *at;                        /* the number of each vertex's place */
    uint32_t (*faces)[3];                /* counterclockwise from outside; by part */
    unsigned part_count;                 /* at least 1 */
    size_t *ends;                        /* the face that each part ends before */
    struct mesh_material *materials;     /* of each part */
    bool has_textures, has_facet_colors; /* in the file: they are ignored */
};
void mesh_free(struct mesh *mesh);
unsigned mesh_part_of(const struct mesh *mesh, size_t face);

/* Vectors. */
double mesh_dot(const double a[3], const double b[3]);
void mesh_cross(const double a[3], const double b[3], double out[3]);
bool mesh_normalize(double v[3]); /* false, and v as it is, where there is no direction */
/* Of the triangle, as long as twice its area. */
void mesh_face_normal(const double a[3], const double b[3], const double c[3], double out[3]);
/* Directions of length 1 at most so many degrees apart have at least this dot product. */
double mesh_cosine(double degrees);

#endif
