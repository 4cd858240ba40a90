/* SPDX-License-Identifier: MIT
 * Inside the child process: the files that libassimp reads, which are more than the one that the user names: an OBJ has its
 * materials elsewhere, a glTF its numbers. The parent is told of each, so that no output replaces it. */
#ifndef GLINT_MESH_IMPORT_FILES_H
#define GLINT_MESH_IMPORT_FILES_H

#include <stdint.h>
#include <stdio.h>

#include "mesh/import_source.h"

enum { IMPORT_FILES_MAX = 1024 };

struct import_file {
    uint64_t device, number; /* as stat() has them */
};

struct aiFileIO; /* libassimp's */
/* Opens regular files to read, at most IMPORT_FILES_MAX different ones; of the mesh the source's bytes, if it has them. */
struct aiFileIO *import_files(const struct import_source *source);
extern const char import_files_input[]; /* how libassimp's name of standard input begins; the format's ending follows */
/* A regular file that the mesh names, in its folder or in the one that the user allows, or below them; a mesh from standard input names none. It is
 * counted among those opened. NULL: *wrong is what is wrong, as the end of a message. */
FILE *import_files_open(const char *path, size_t *len, const char **wrong);
/* The same by how the mesh names it: in its folder, with the other system's separators and %20, too. */
FILE *import_files_open_named(const struct import_source *source, const char *name, size_t *len, const char **wrong);
/* At most *len bytes, which is how many they are then, with room for one more; closes the stream. */
char *import_files_read_all(FILE *stream, size_t *len);
/* One such message: it lies elsewhere. */
const char *import_files_outside(const struct import_source *source);
/* The first file elsewhere that libassimp asked for; NULL: none. */
const char *import_files_refused(void);
/* Those opened so far. */
unsigned import_files_read(const struct import_file **files);

#endif
