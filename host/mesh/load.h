/* SPDX-License-Identifier: MIT
 * Meshes as the user names them, made ready. */
#ifndef GLINT_MESH_LOAD_H
#define GLINT_MESH_LOAD_H

#include "mesh/mesh.h"

extern const char *const mesh_names[]; /* built in: "teapot"; ends with NULL */

enum mesh_axes { AXES_Y_UP, AXES_Z_UP, AXES_USUAL };
extern const char *const mesh_axes_names[]; /* ends with NULL */
/* Normals that a file has are what its author saw smooth; of those made from its faces nobody has. */
enum { SPLIT_USUAL = 30, SPLIT_OWN = 45 };

struct mesh_source {
    const char *name; /* a file, or a built-in mesh */
    bool built_in;
    double crease;       /* degrees; below 0: the file's normals, or CREASE_USUAL */
    double split;        /* degrees; 0: SPLIT_OWN with the file's own normals, else SPLIT_USUAL */
    bool flipped;        /* the file's faces are turned inside out */
    bool stepped;        /* without smooth outlines */
    enum mesh_axes axes; /* of the file; AXES_USUAL: z up in an STL */
    bool no_textures;
    const char *allowed;      /* a folder whose files it may name, beside its own and those below; or NULL */
    const char *texture;      /* the picture of all parts, in the place of those that the file names; or NULL */
    struct texture_wish wish; /* bytes 0: TEXTURE_BYTES_USUAL */
    size_t faces_most;        /* 0: GLINT_MESH_FACES_MAX, beyond which is an error; else there is no mesh beyond it */
};
/* Welded, split and ordered; NULL: more than faces_most faces. Errors end the program through fail(). */
struct mesh *mesh_load(const struct mesh_source *source);

#endif
