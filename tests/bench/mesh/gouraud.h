/* SPDX-License-Identifier: MIT
 * Gouraud shading by the library's rasterizer, to compare: one brightness, worked out at the corners and interpolated, of a grey material.
 * Three colours would take two more gradients a triangle and two more additions a pixel. */
#ifndef GLINT_BENCH_GOURAUD_H
#define GLINT_BENCH_GOURAUD_H

#include "glint_mesh.h"

/* Exact, RGB565: its triangles are drawn so. NULL: none. Link with --wrap=glint_mesh_rows. */
extern const struct glint_paint *gouraud_paint;
/* After glint_mesh_add: shades each vertex, which has 0.2 ambient, 0.5 diffuse and 0.3 specular light (MSH) then. */
void gouraud_vertices(struct glint_mesh_drawn *drawn, uint32_t n, unsigned q);

#endif
