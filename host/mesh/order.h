/* SPDX-License-Identifier: MIT
 * Faces and vertices in the order in which a small cache serves them best. */
#ifndef GLINT_MESH_ORDER_H
#define GLINT_MESH_ORDER_H

#include "mesh/mesh.h"

/* Faces that share vertices one after the other, within each part; vertices in the order of their first use. */
void mesh_order(struct mesh *mesh);

#endif
