/* SPDX-License-Identifier: MIT
 * The checks of meshes. */
#ifndef CONFORMANCE_MESHES_H
#define CONFORMANCE_MESHES_H

#include "conformance.h"
#include "glint_mesh.h"

enum { CONFORM_VERTICES = 10, CONFORM_FACES = 14, CONFORM_WIDTH = 19 }; /* of a picture */

/* What a picture of a mesh is drawn with. */
struct conform_look {
    const struct glint_paint *paint;
    struct glint_vec h;                    /* normals are about it */
    const uint8_t *of_vertices, *of_faces; /* colours */
    bool has_lights;                       /* memory for several lights */
    bool is_outlined, has_grain;
    const struct glint_texture *texture;
};
/* Adds a picture of a random mesh: 0: as random as can be; else the like of models as people have them, in perspective where kind is not a
 * multiple of 3. stride: bytes of a line, up to 4 a pixel. */
void conform_mesh(unsigned kind, const struct conform_look *look, uint8_t stride);

/* Exact, or by COLOUR tables. */
void conform_meshes(const struct conformance_size *size, bool tables);

#endif
