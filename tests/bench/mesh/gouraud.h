/* SPDX-License-Identifier: MIT
 * Gouraud shading by the library's rasterizer, to compare: one brightness, worked out at the corners and interpolated, of a grey material.
 * Three colours would take two more gradients a triangle and two more additions a pixel. */
#ifndef GLINT_BENCH_GOURAUD_H
#define GLINT_BENCH_GOURAUD_H

#include "glint.h"

/* A path of RGB565; its paint is with anything but NULL. */
extern const struct glint_mesh_path gouraud_path;
/* After glint_mesh_add: shades each vertex, which has 0.2 ambient, 0.5 diffuse and 0.3 specular light then. */
void gouraud_vertices(struct glint_mesh_drawn *drawn, const struct glint_lobe *lobe);

#endif
