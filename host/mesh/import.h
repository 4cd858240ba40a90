/* SPDX-License-Identifier: MIT
 * Meshes from files, by libassimp where glint was built with it. */
#ifndef GLINT_MESH_IMPORT_H
#define GLINT_MESH_IMPORT_H

#include "mesh/soup.h"

/* OBJ, STL, PLY and glTF. libassimp may crash or hang on a damaged file: it runs in a child process with limits of time and memory. Every
 * error ends the program through fail(). */
struct soup *import_soup(const char *path);
/* An STL's normals are those of its facets, and its z axis points up. */
bool import_is_stl(const char *path);
const char *import_library(void); /* "libassimp 5", of which the headers are; NULL: built without it */

#endif
