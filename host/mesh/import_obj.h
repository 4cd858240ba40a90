/* SPDX-License-Identifier: MIT
 * Inside the child process: an OBJ, by glint's own reader, and the files that it names. */
#ifndef GLINT_MESH_IMPORT_OBJ_H
#define GLINT_MESH_IMPORT_OBJ_H

#include "mesh/import_source.h"

/* Sends what import_child does, and returns NULL; or what is wrong with the mesh, of which nothing is sent. */
const char *import_obj(const struct import_source *source, int out);

#endif
