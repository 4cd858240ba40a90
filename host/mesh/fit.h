/* SPDX-License-Identifier: MIT
 * Meshes as the library reads them. */
#ifndef GLINT_MESH_FIT_H
#define GLINT_MESH_FIT_H

#include "glint_mesh.h"
#include "mesh/mesh.h"
#include "mesh/texture.h"

/* The library's mesh points into the arrays. */
struct fitted {
    struct glint_mesh mesh; /* with 16-bit normals; normals8 is set for those who want them */
    int16_t (*places)[3], (*normals)[3];
    int8_t (*normals8)[3];
    uint16_t (*faces)[3], *ends;
    uint16_t (*neighbours)[3];      /* of each face, for smooth outlines; NULL: stepped ones */
    uint8_t (*colors)[3];           /* of each vertex, of_vertices of the mesh; NULL: each part has one */
    uint16_t (*uv)[2];              /* NULL: no part has a texture */
    struct glint_texture *of_parts; /* of the mesh */
    struct texture *textures;       /* of the mesh's pictures, of which not all are used */
    unsigned texture_count;
    double middle[3]; /* of the places in double: 0, 0, 0 here */
    double unit;      /* how many units of the places here 1 there is */
};
/* unit 0: the mesh's middle becomes 0, 0, 0 and what is farthest from it 32767 away; else places are times `unit`, about their own
 * origin. Ends the program through fail() where they do not fit. */
struct fitted *mesh_fit(const struct mesh *mesh, double unit);
void fitted_forget_colors(struct fitted *fitted); /* and textures: each part has one colour */
void fitted_forget_neighbours(struct fitted *fitted);
void fitted_free(struct fitted *fitted);
size_t fitted_bytes(const struct fitted *fitted, bool normals8); /* with its textures */
/* Had no edge been split. */
size_t fitted_whole_bytes(const struct fitted *fitted, const struct mesh *mesh, bool normals8);
size_t fitted_texture_bytes(const struct fitted *fitted);

#endif
