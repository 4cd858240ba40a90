/* SPDX-License-Identifier: MIT
 * The mesh that the board turns, DEMO=teapot or MESH=FILE, baked by `glint bake`. The linker puts a small one into RAM, where it is faster
 * than in flash. */
#ifndef HELD_MESH_H
#define HELD_MESH_H

#include "light_protocol.h"

extern const struct glint_mesh held_mesh;
extern const struct light_mesh held_mesh_identity;
bool held_mesh_is_intact(void);

#endif
