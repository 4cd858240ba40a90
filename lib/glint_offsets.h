/* SPDX-License-Identifier: MIT
 * Internal. Where the assembly finds fields of structs, in bytes, and numbers that it shares with C: offsets.c compares them with the compiler's. Macros
 * only: assembly includes it. */
#ifndef GLINT_OFFSETS_H
#define GLINT_OFFSETS_H

#define GLINT_AT_TABLES_COLUMNS 0
#define GLINT_AT_TABLES_COLOUR 4 /* behind columns: one load of two words has both */
#define GLINT_AT_TABLES_T_MAX 8
#define GLINT_AT_TABLES_DARK 12
#define GLINT_AT_TABLES_SHIFT 16

#define GLINT_AT_PAINT_X 24 /* of.tables, behind filled: x, y, z: one load of three words */
#define GLINT_AT_PAINT_CUT 36
#define GLINT_AT_PAINT_R 44
#define GLINT_AT_PAINT_A 48
#define GLINT_AT_PAINT_FORMAT 171 /* output.format: tests find it here */

#define GLINT_AT_SPAN_W 20 /* t, dt, ddt, nl, dnl before it, from 0 on */

#define GLINT_AT_SAMPLE_NL 4 /* nl, f */
#define GLINT_SAMPLE_SIZE 12
#define GLINT_AT_EXACT_Q 12 /* behind p, as r is */
#define GLINT_AT_EXACT_R 24
#define GLINT_AT_CHANNELS_OF 0 /* of, steps, entries, near: struct linear_channels, whose check is beside it */
#define GLINT_AT_CHANNELS_STEPS 4
#define GLINT_AT_CHANNELS_ENTRIES 8
#define GLINT_AT_CHANNELS_NEAR 12

#define GLINT_LINEAR_FRACTION 14 /* bits of Q and R below V in linear space */
#define GLINT_LINEAR_SHIFT 14 /* bits of V below its argument; fewer where a light is so bright that it would not fit */

#define GLINT_NEGATIVE_T_LOG 27 /* GLINT_NEGATIVE_T is 2^32 less 2 to this */

/* How large the tables are and by which bits they are read; for C and for assembly, so macros only. Fixed point as
 * in glint.h: nl and t are Q2.30, a lit nl is below 2^31. */

/* COLOUR: rows of colours over nl, colours of a row over F, and columns over t that tell which colour of the row. */
#define GLINT_COLOUR_ROWS 128
#define GLINT_COLOUR_ROW_SHIFT 24    /* nl_q30 >> this: the row; 2^31 >> 24 = 128 */
#define GLINT_COLOUR_STEPS 64        /* colours of a row */
#define GLINT_COLOUR_ROW_BYTES_LOG 7 /* a row's bytes, 64 x 2, as a power of two */
#define GLINT_COLOUR_COLUMNS_LOG 12  /* columns, as a power of two */

/* COLOUR, dithered: for each y mod 4 a part of rows, of a pixel for each x mod 4, the first row dark, the others over nl; parts of
 * sums for the same rows but dark; and shines over t. Bytes. Rows that normals of no unit length lead to lie within the
 * tables, too. */
#define GLINT_DITHER_ROWS 130
#define GLINT_DITHER_ROW_SHIFT 23     /* nl_q30 >> this: the row past dark; 2^31 >> 23 = 256 */
#define GLINT_DITHER_PIXELS_LOG 3     /* of a row: 4 x 2 */
#define GLINT_DITHER_SUMS_LOG 4       /* of a row: 4 x 4 */
#define GLINT_DITHER_PIXELS_PART 1040 /* 130 rows */
#define GLINT_DITHER_SUMS 4160        /* where the sums begin, behind 4 parts */
#define GLINT_DITHER_SUMS_PART 2064   /* 129 rows */
#define GLINT_DITHER_SHINES 12416     /* where the shines begin, behind 4 parts more */
#define GLINT_DITHER_COLUMNS_LOG 11   /* of shines */

/* ALBEDO: levels over nl, highlights over t. */
#define GLINT_ALBEDO_LEVEL_SHIFT 23 /* nl_q30 >> this: the level's number; 128 of them below nl = 1 */
#define GLINT_ALBEDO_LEVELS 392     /* three times 128, and some: whatever normals and lights are */
#define GLINT_ALBEDO_COLUMNS_LOG 11

/* Spans: pixels that are judged together. A store of Thumb reaches 31 pixels from its address. */
#define GLINT_SPAN_RUN_LOG 5
#define GLINT_SPAN_RUN 32

#define GLINT_AT_TEXTURE_LEVELS 12
#define GLINT_AT_TEXTURE_W 8 /* w, h */

/* Where the assembly finds fields of a mesh and a triangle, in bytes; offsets.c compares these with the compiler's. Macros only. */

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

#define GLINT_MESH_LINES_BYTES 64 /* a struct glint_mesh_lines */
#define GLINT_AT_LINES_DRAW 0     /* draw, off_first, line_first, off, line, line_step, off_step, last */
#define GLINT_AT_LINES_COLOURS 32 /* colours, dark, shift, limit, w, end, columns, t_max */

#define GLINT_AT_STRIP_INNER 148   /* in the frame of glint_mesh_strip_lines, from its lines on */
#define GLINT_AT_DRAWN_OUTLINES 68 /* outlines, rims */
#define GLINT_AT_DRAWN_EDGES 80
#define GLINT_EDGES_ASK 47  /* bits of an edge of it: its face is drawn otherwise */
#define GLINT_EDGES_NONE 32 /* or not at all */
#define GLINT_EDGES_IS_FRONT 16
#define GLINT_EDGES_IS_CLIPPED 64
#define GLINT_MESH_RIMS 56 /* outlines kept for a strip; others are set each time they are asked for */
#define GLINT_MESH_RIM_BYTES 24
#define GLINT_AT_RIM_AT 12          /* at, end; before it e, step, depth */
#define GLINT_AT_RIM_IS 16          /* is, corner, face, inverse */
#define GLINT_MESH_HIDDEN 32        /* cells that a face leaves out at a time */
#define GLINT_CELL_LEFT_OUT 124     /* it leaves a cell out where so much of 256 is inside */
#define GLINT_AT_OUTLINES_REST 1420 /* rest, hidden */
#define GLINT_AT_OUTLINES_DEPTHS 1424

#define GLINT_AT_TARGET_Y 12     /* y, end */
#define GLINT_AT_TARGET_FRAME 24 /* frame, drawn */
#define GLINT_AT_BENCH_FACE 436
#define GLINT_AT_FRAME_KEPT 12
#define GLINT_AT_FRAME_W 16 /* w, h */
#define GLINT_AT_FRAME_FREE 26
#define GLINT_AT_FRAME_KEPT_BYTES 30
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
#define GLINT_AT_MESH_OF_VERTICES 28
#define GLINT_AT_MESH_UV 40
#define GLINT_AT_MESH_UV_BITS 44
#define GLINT_AT_MESH_NEIGHBOURS 52

/* Colours of vertices over a triangle: a level of 255 in 2^-21 of RGB565's levels, and half a level of these. */
#define GLINT_MESH_OVER_RED 254952 /* and blue */
#define GLINT_MESH_OVER_GREEN 518127
#define GLINT_MESH_OVER_HALF_LOG 20
#define GLINT_MESH_SLOPED 8 /* of triangle->shine: u, v, u_x, v_x, u_y, v_y, the vertices, e - 18 are laid */
#define GLINT_MESH_LAID_LOG 2
#define GLINT_AT_PIXELS_NOW 8
#define GLINT_AT_PIXELS_DZ 28  /* z, nl, now, back, dt; dz, dnl, step */
#define GLINT_AT_PIXELS_DDT 48 /* ddt, depth, end, off; levels, sums, t_max, limit, shift, dark; picture; loop */

#define GLINT_MESH_NONE 0xffff /* no face */
#define GLINT_MESH_BAND_LOG 4

/* Places are held to these, 1/16 pixel: depths and the guard band around the viewport's middle. */
#define GLINT_MESH_GUARD 16383

#define GLINT_SHINE_DARK 0
#define GLINT_SHINE_MATT 1
#define GLINT_MESH_STEEP 12     /* where slopes' e is less, u or v change by 8 a pixel or more */
#define GLINT_MESH_GENTLE 15    /* slopes' e from which on it is asked whether t stays beyond its plane at a corner, */
#define GLINT_MESH_MARGIN_LOG 3 /* by so much of the greatest side */

/* Where the assembly finds fields of glint_line_loop, in bytes, and numbers that it shares with C; offsets.c
 * compares them with the compiler's. Macros only: assembly includes it. */

#define GLINT_LINE_SHIFT 25 /* a level is V 2^-25 */

/* The first GLINT_AT_LINE_COPIED bytes are copied to the stack, where they have the same offsets. */
#define GLINT_AT_LINE_L 0
#define GLINT_AT_LINE_T_END 12
#define GLINT_AT_LINE_BASE 16 /* by nl and 1, for red, green and blue; behind t_end: one load has three words */
#define GLINT_AT_LINE_R 40
#define GLINT_AT_LINE_K 52
#define GLINT_AT_LINE_RECIPROCALS 64
#define GLINT_AT_LINE_F_MAX 68
#define GLINT_AT_LINE_DARK 72
#define GLINT_AT_LINE_COPIED 76
#define GLINT_AT_LINE_MINUS_H 76 /* with limit behind it: one load of four words */
#define GLINT_AT_LINE_OUT 92     /* with w, mask, normals and albedo behind it: one load of five words */
#define GLINT_AT_LINE_LIT 112    /* with steps, span and turn behind it */
#define GLINT_STEPS_LOG 6        /* values of nl to a step of a table, as a power of two */

/* Of glint_grain_loop: 14 words that are copied, too. */
#define GLINT_AT_GRAIN 148

/* What of.exact.k's copy in the line's loop is where there is grain: GLINT_GRAIN_SHIFT less 1. */
#define GLINT_GRAIN_UP 0
#define GLINT_GRAIN_LEAST 1
#define GLINT_GRAIN_SHIFT 2

/* Where the loop has U or n from: one direction, or as these say. */
#define GLINT_GRAIN_LINE_PLACE 1
#define GLINT_GRAIN_LINE_MAP 2
#define GLINT_GRAIN_LINE_SHININESS 3

#endif
