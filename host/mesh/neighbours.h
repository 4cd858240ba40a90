/* SPDX-License-Identifier: MIT
 * Which faces lie beside each other, for smooth outlines. */
#ifndef GLINT_MESH_NEIGHBOURS_H
#define GLINT_MESH_NEIGHBOURS_H

#include "mesh/mesh.h"

/* Of each face the one beyond each of its edges, as struct glint_mesh has them: edges are joined by place, whatever normals and colours their
 * vertices have. An open edge is GLINT_MESH_RIM, or where it lies on another one that runs the other way (a T-junction, a seam), so that nothing
 * is seen through between them, GLINT_MESH_SEAM. malloc'd. Of so many open edges that this takes more than the steps below some stay RIM, with a warning. */
enum { MESH_NEIGHBOURS_STEPS_MAX = 1 << 29 };
uint16_t (*mesh_neighbours(const struct mesh *mesh))[3];

#endif
