/* SPDX-License-Identifier: MIT
 * Pictures for meshes: PNG, and JPEG by libjpeg where glint was built with it. They are decoded in a child process with limits. */
#ifndef GLINT_MESH_IMPORT_PICTURE_H
#define GLINT_MESH_IMPORT_PICTURE_H

#include "mesh/mesh.h"

enum { IMPORT_PICTURE_BYTES = 1 << 26 }; /* of a file: a larger one is a mistake or an attack */

/* From a file's bytes; alpha is ignored. `name`: of the picture. Returns NULL, or what is wrong, as the end of a message: the
 * picture has a size then, too, as large as what was decoded may have been, and no pixels or not all of them. */
const char *import_picture_decode(struct mesh_picture *picture, const char *name, const void *bytes, size_t len);
/* From a file that the user names. Every error ends the program through fail(). */
struct mesh_picture import_picture(const char *path);
const char *import_picture_library(void); /* "libjpeg-turbo 2.1.5", of which the headers are; NULL: built without it */

#endif
