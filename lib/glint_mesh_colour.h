/* SPDX-License-Identifier: MIT
 * Internal. A triangle by COLOUR tables. */
#ifndef GLINT_MESH_COLOUR_H
#define GLINT_MESH_COLOUR_H

#include "glint_mesh_path.h"

/* As glint_mesh_path's draw; the surface's pixels and stride are even. Has a twin in assembly. */
void glint_mesh_colour(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *target);

/* In assembly alone: its routine, and what that needs of a strip; the latter by itself, in C. */
void glint_mesh_colour_begin(const struct glint_tables *tables, const struct glint_mesh_target *target,
                             struct glint_mesh_lines *lines);
void glint_mesh_colour_set(const struct glint_tables *tables, const struct glint_mesh_target *target,
                           struct glint_mesh_lines *lines);

/* A triangle by tables: as above where that is possible, else by glint_mesh_tables_rows, line by line. */
void glint_mesh_tables_draw(const void *with, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target);
void glint_mesh_tables_rows(const void *with, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_target *target);

#endif
