/* SPDX-License-Identifier: MIT
 * Frames of the teapot and the bunny, a strip at a time. Steps return an error, 0 for none. */
#ifndef GLINT_BENCH_MESH_H
#define GLINT_BENCH_MESH_H

#include <stdint.h>

enum { MESH_WIDTH = 240, MESH_HEIGHT = 240, MESH_LINES = 16 };
/* 1: with the bunny, which npm installs. */
#ifndef MESH_BUNNY
#define MESH_BUNNY 0
#endif

/* From MESH_DARK on exactly: under no light, one white point to four. With a texture, by ALBEDO tables: nearest, bilinear; exactly; under perspective
 * by tables. By colours of vertices, by ALBEDO tables. */
enum mesh_way {
    MESH_BY_TABLES,
    MESH_EXACT,
    MESH_GOURAUD,
    MESH_DARK,
    MESH_POINT,
    MESH_TWO_POINTS,
    MESH_THREE_POINTS,
    MESH_FOUR_POINTS,
    MESH_TEXTURED,
    MESH_SMOOTH,
    MESH_TEXTURED_EXACT,
    MESH_TEXTURED_FAR,
    MESH_COLOURED
};

extern uint32_t mesh_out[MESH_WIDTH * MESH_LINES / 2]; /* a strip, RGB565 */

int mesh_begin(enum mesh_way way); /* the material; not counted */
/* 0: the teapot as shipped; 1: split at 30 degrees; 2: as 0, with fewer places; 3: the bunny, of MESH_BUNNY; 4: as 0, with smooth
 * outlines. Before a frame it gets its texture or
 * colours, where it has some; not counted. */
int mesh_clothe(unsigned which);
int mesh_frame(unsigned which);
int mesh_strip(unsigned y);
/* Under points, in the place of mesh_strip: keeps the strip's normals, as they are drawn, and which pixels have one; not counted. Then draws
 * them, as a rectangle. */
int mesh_normals(unsigned y);
int mesh_rect(unsigned y);
/* Bytes that a picture takes: the frame's and the mesh's memory, two strips, the paint and its tables. */
uint32_t mesh_memory_bytes(enum mesh_way way, unsigned which);

#endif
