/* SPDX-License-Identifier: MIT
 * Inside the child process: libassimp, but for OBJ. */
#ifndef GLINT_MESH_IMPORT_CHILD_H
#define GLINT_MESH_IMPORT_CHILD_H

#include "mesh/import_source.h"
#include "mesh/soup.h"

/* Sent first; then, where there is no message, the files that were read, the materials and the faces. */
struct import_head {
    char message[256], refused[200]; /* a file that it names, which may not be read */
    char notes[1000];                /* of what is left out: lines, each the end of a message */
    uint64_t face_count, part_count, file_count, picture_count;
    bool has_normals, has_uv, has_colors, has_facet_colors;
};
/* Of a picture that materials name, before the bytes of its file: none where there is a message. */
struct import_picture_head {
    char name[200], message[200];
    uint64_t len;
};
/* Reads the mesh and sends it to the descriptor, as a head, struct import_file's, struct mesh_material's, pictures and struct
 * soup_face's. */
void import_child(const struct import_source *source, int out);

#endif
