/* SPDX-License-Identifier: MIT
 * Edges over which the normal turns far, cut in half. */
#ifndef GLINT_MESH_SPLIT_H
#define GLINT_MESH_SPLIT_H

#include "mesh/mesh.h"

/* Until no edge's normals are more than so many degrees apart. All faces at an edge are cut where one is, so that no corner of one
 * lies on the edge of another. Places stay on the surface that there was. Ends the program through fail() where the library's limits
 * of vertices and faces are passed. */
void mesh_split(struct mesh *mesh, double degrees);
/* The same, but false where it takes more than that many faces, or than the library does. */
bool mesh_split_within(struct mesh *mesh, double degrees, size_t faces_most);

#endif
