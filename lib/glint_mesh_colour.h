/* SPDX-License-Identifier: MIT
 * Internal. A triangle by COLOUR tables. */
#ifndef GLINT_MESH_COLOUR_H
#define GLINT_MESH_COLOUR_H

#include "glint_mesh_path.h"

/* As glint_mesh_path's draw; the surface's pixels and stride are even. */
void glint_mesh_colour(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                       const struct glint_mesh_target *target);

/* Where a part is drawn: its first line's, and how many bytes lines are apart. */
struct glint_mesh_place_of_part {
    uint8_t *depth, *out;
    ptrdiff_t depth_stride, out_stride;
    int32_t w, lines;
};

/* Draws a part and steps the edges and values over its lines. Has a twin in assembly. */
void glint_mesh_colour_part(const struct glint_tables *tables, struct glint_mesh_triangle *triangle,
                            const struct glint_mesh_part *part, const struct glint_mesh_place_of_part *place);

#endif
