/* SPDX-License-Identifier: MIT
 * Normals of a mesh's corners, and the vertices that they make of places. */
#ifndef GLINT_MESH_CORNER_NORMALS_H
#define GLINT_MESH_CORNER_NORMALS_H

#include "mesh/soup.h"

enum { CREASE_USUAL = 60 }; /* degrees */

/* The soup's; one without a direction changes nothing. Returns whether there is none. `from`: where in the soup each face is. */
bool corner_normals_given(const struct soup *soup, const size_t *from, size_t count, double (*normals)[3][3]);
/* From the faces around, up to creases. */
void corner_normals_made(double (*places)[3], uint32_t (*faces)[3], size_t count, double crease,
                         double (*normals)[3][3]);
/* Fills the mesh: corners of one place, normal, colour and place in the picture become one vertex. `from` as above. */
void corner_normals_join(struct mesh *mesh, const struct soup *soup, const size_t *from, double (*places)[3],
                         uint32_t (*faces)[3], double (*normals)[3][3]);

#endif
