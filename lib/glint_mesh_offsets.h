/* SPDX-License-Identifier: MIT
 * Internal. Where the assembly finds fields of a mesh and a triangle, in bytes; mesh_offsets.c compares these with the compiler's. Macros only. */
#ifndef GLINT_MESH_OFFSETS_H
#define GLINT_MESH_OFFSETS_H

#define GLINT_AT_TRIANGLE_Z 0 /* z, nl, t, tx, ty, zy, nly, txy, tyy */
#define GLINT_AT_TRIANGLE_NL 4
#define GLINT_AT_TRIANGLE_T 8
#define GLINT_AT_TRIANGLE_TX 12
#define GLINT_AT_TRIANGLE_TY 16
#define GLINT_AT_TRIANGLE_ZY 20
#define GLINT_AT_TRIANGLE_NLY 24
#define GLINT_AT_TRIANGLE_TXY 28
#define GLINT_AT_TRIANGLE_TYY 32
#define GLINT_AT_TRIANGLE_ZX 36
#define GLINT_AT_TRIANGLE_NLX 40
#define GLINT_AT_TRIANGLE_TXX 44
#define GLINT_AT_TRIANGLE_X 48
#define GLINT_AT_TRIANGLE_LONG 52 /* long_edge, upper, lower */
#define GLINT_AT_TRIANGLE_Y 76
#define GLINT_AT_TRIANGLE_Y_MIDDLE 78
#define GLINT_AT_TRIANGLE_Y_END 80
#define GLINT_AT_TRIANGLE_SHINE 82
#define GLINT_AT_TRIANGLE_LONG_IS_LEFT 83

#define GLINT_MESH_KEPT_SIZE 88 /* of a struct glint_mesh_kept, whose first is the triangle */
#define GLINT_AT_KEPT_FACE 84   /* face, next */

#define GLINT_AT_PATH_T_END 4
#define GLINT_AT_PATH_BEGIN 12
#define GLINT_MESH_LINES_BYTES 64 /* a struct glint_mesh_lines */
#define GLINT_AT_LINES_DRAW 0     /* draw, off_first, line_first, off, line, line_step, off_step, last */
#define GLINT_AT_LINES_COLOURS 32 /* colours, dark, shift, limit, w, end, columns, t_max */

#define GLINT_AT_TARGET_Y 12     /* y, end */
#define GLINT_AT_TARGET_FRAME 24 /* frame, drawn */
#define GLINT_AT_BENCH_FACE 436
#define GLINT_AT_FRAME_KEPT 12
#define GLINT_AT_FRAME_W 16 /* w, h */
#define GLINT_AT_FRAME_FREE 26
#define GLINT_AT_DRAWN_MESH 4 /* mesh, paints */
#define GLINT_AT_DRAWN_VERTICES 12
#define GLINT_AT_DRAWN_LINKS 16 /* links, bands */
#define GLINT_AT_DRAWN_KEPT 24
#define GLINT_AT_DRAWN_LIGHT 26 /* l, h, turn, position, scale */
#define GLINT_AT_DRAWN_SCALE 62
#define GLINT_AT_DRAWN_IS_CUT 64
#define GLINT_AT_MESH_PLACES 0
#define GLINT_AT_MESH_NORMALS 4
#define GLINT_AT_MESH_NORMALS8 8
#define GLINT_AT_MESH_FACES 12        /* faces, ends */
#define GLINT_AT_MESH_VERTEX_COUNT 20 /* and of faces, of parts */

#define GLINT_MESH_NONE 0xffff /* no face */
#define GLINT_MESH_BAND_LOG 4

/* Places are held to these, 1/16 pixel: depths and the guard band around the viewport's middle. */
#define GLINT_MESH_GUARD 16383

#define GLINT_SHINE_DARK 0
#define GLINT_SHINE_MATT 1

#endif
