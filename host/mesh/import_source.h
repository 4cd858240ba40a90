/* SPDX-License-Identifier: MIT
 * What is imported: a file, or what standard input held. */
#ifndef GLINT_MESH_IMPORT_SOURCE_H
#define GLINT_MESH_IMPORT_SOURCE_H

#include <stdbool.h>
#include <stddef.h>

struct import_source {
    const char *name;   /* for messages */
    const char *path;   /* NULL: standard input */
    const char *ending; /* ".obj", ".stl", ".ply", ".gltf" or ".glb": the format */
    char *bytes;        /* NULL: those of the file; there is room for one more */
    size_t len;
    bool textures;       /* are its pictures wanted? */
    const char *allowed; /* a folder whose files it may name, beside its own; or NULL */
};
/* From a path, "-" for standard input, which is read to its end and known by how it begins. Errors end the program through fail(). */
struct import_source *import_source_open(const char *path);
void import_source_free(struct import_source *source);

#endif
