/* SPDX-License-Identifier: MIT
 * Meshes as C and C++ source, raw and UF2. */
#ifndef GLINT_BAKE_MESH_FILES_H
#define GLINT_BAKE_MESH_FILES_H

#include <stdio.h>

#include "mesh/fit.h"

/* Of each part the plain finish, in the file's colour; malloc'd. */
struct glint_material *mesh_materials(const struct mesh *mesh);

/* A mesh with its materials; normals of 8 bits or of 16. */
struct baked_mesh {
    const struct mesh *mesh;
    const struct fitted *fitted;
    const struct glint_material *materials; /* of each part */
    bool normals8;
};
size_t baked_mesh_bytes(const struct baked_mesh *baked); /* without the materials */

/* All in one file to include. */
void bake_mesh_write_c(const struct baked_mesh *baked, const char *name, FILE *out);
/* A header, whose file name is `header`, and a source to link. */
void bake_mesh_write_header(const struct baked_mesh *baked, const char *name, FILE *out);
void bake_mesh_write_definitions(const struct baked_mesh *baked, const char *name, const char *header, FILE *out);

/* Low bytes first: see glint bake --help. malloc'd. */
uint8_t *bake_mesh_raw(const struct baked_mesh *baked, size_t *len);

#endif
