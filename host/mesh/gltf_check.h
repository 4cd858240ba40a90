/* SPDX-License-Identifier: MIT
 * Does a glTF say what libassimp makes of it? It misreads numbers that are not floats, leaves out triangles, and ignores what it does not know. */
#ifndef GLINT_MESH_GLTF_CHECK_H
#define GLINT_MESH_GLTF_CHECK_H

#include <stddef.h>
#include <stdint.h>

/* Of a .gltf or a .glb. What is wrong, as the end of a message; NULL: nothing that is seen here, and *triangles is how many its scene has. */
const char *gltf_check(char *bytes, size_t len, uint64_t *triangles);

#endif
