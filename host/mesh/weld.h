/* SPDX-License-Identifier: MIT
 * Triangles of their own corners into a mesh that shares them. */
#ifndef GLINT_MESH_WELD_H
#define GLINT_MESH_WELD_H

#include "mesh/soup.h"

/* Corners at one place (to 10^-5 of the mesh's size) are joined and triangles without area left out. Normals are the soup's where
 * crease < 0 and the corner has one; else each corner's is the mean, weighted by angle, over the faces that it is joined with
 * by edges of at most `crease` degrees. Errors end the program through fail(). */
struct mesh *mesh_weld(const struct soup *soup, double crease);

#endif
