/* SPDX-License-Identifier: MIT
 *
 * By which a host and a device know that they hold the same mesh. */
#ifndef MESH_CKSUM_H
#define MESH_CKSUM_H

#include "glint_mesh.h"

/* cksum's of places, 8-bit normals, which must be there, and faces, as `glint bake --as raw` writes them: little-endian. */
uint32_t mesh_cksum(const struct glint_mesh *mesh);

#endif
