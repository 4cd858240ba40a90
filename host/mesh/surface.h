/* SPDX-License-Identifier: MIT
 * What a mesh wears: which of its pictures and colours are drawn. */
#ifndef GLINT_MESH_SURFACE_H
#define GLINT_MESH_SURFACE_H

#include "mesh/load.h"
#include "mesh/soup.h"

/* Before corners are joined: reads the picture that the user names, and leaves out what is not drawn, with a word. Errors end the program
 * through fail(). */
void mesh_surface_begin(struct soup *soup, const struct mesh_source *source);
/* After that: the mesh takes the soup's pictures, and its places in them become 0 and more, by whole repeats. */
void mesh_surface_end(struct mesh *mesh, struct soup *soup, const struct mesh_source *source);

#endif
