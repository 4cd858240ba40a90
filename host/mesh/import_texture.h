/* SPDX-License-Identifier: MIT
 * Inside the child process: the pictures that a mesh's materials name, as the bytes of their files. */
#ifndef GLINT_MESH_IMPORT_TEXTURE_H
#define GLINT_MESH_IMPORT_TEXTURE_H

#include "mesh/import_child.h"

/* One of them. */
struct import_found {
    char *key; /* as the material names it */
    struct import_picture_head head;
    const void *bytes;
};
struct aiScene; /* libassimp's */
struct import_pictures {
    const struct aiScene *scene;
    const struct import_source *source;
    unsigned count;
    struct import_found *of; /* room for two a material */
};
/* The number of the picture of this name: one that the mesh holds, or a regular file in the mesh's folder or below it. */
unsigned import_pictures_find(struct import_pictures *pictures, const char *name);
/* A struct import_picture_head and its bytes for each. */
void import_pictures_send(const struct import_pictures *pictures, int out);

#endif
