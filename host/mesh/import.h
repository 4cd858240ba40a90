/* SPDX-License-Identifier: MIT
 * Meshes from files, by libassimp where glint was built with it. */
#ifndef GLINT_MESH_IMPORT_H
#define GLINT_MESH_IMPORT_H

#include "mesh/soup.h"

/* OBJ, STL, PLY and glTF from a path, "-" for standard input. libassimp may crash or hang on a damaged file: it runs in a child process with limits of time and memory. Every
 * error ends the program through fail(). */
/* textures: with the pictures that it names or holds. Files that it names lie in its folder or below, or in `allowed`, if that is not NULL. */
struct soup *import_soup(const char *path, bool textures, const char *allowed);
const char *import_library(void); /* "libassimp 5", of which the headers are; NULL: built without it */

#endif
