/* SPDX-License-Identifier: MIT
 * Inside the child process: libassimp. */
#ifndef GLINT_MESH_IMPORT_CHILD_H
#define GLINT_MESH_IMPORT_CHILD_H

#include "mesh/import_source.h"
#include "mesh/soup.h"

/* Sent first; then, where there is no message, the files that were read, the materials and the faces. */
struct import_head {
    char message[256];
    uint64_t face_count, part_count, file_count;
    bool has_normals, has_textures, has_colors, has_facet_colors;
};
/* Reads the mesh and sends it to the descriptor, as a head, struct import_file's, struct mesh_material's and struct soup_face's. */
void import_child(const struct import_source *source, int out);

#endif
