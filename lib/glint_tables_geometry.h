/* SPDX-License-Identifier: MIT
 * Internal. How large the tables are and by which bits they are read; for C and for assembly, so macros only. Fixed point as
 * in glint.h: nl and t are Q2.30, a lit nl is below 2^31. */
#ifndef GLINT_TABLES_GEOMETRY_H
#define GLINT_TABLES_GEOMETRY_H

/* COLOUR: rows of colours over nl, colours of a row over F, and columns over t that tell which colour of the row. */
#define GLINT_COLOUR_ROWS 128
#define GLINT_COLOUR_ROW_SHIFT 24    /* nl_q30 >> this: the row; 2^31 >> 24 = 128 */
#define GLINT_COLOUR_STEPS 64        /* colours of a row */
#define GLINT_COLOUR_ROW_BYTES_LOG 7 /* a row's bytes, 64 x 2, as a power of two */
#define GLINT_COLOUR_COLUMNS_LOG 12  /* columns, as a power of two */

/* ALBEDO: levels over nl, highlights over t. */
#define GLINT_ALBEDO_LEVEL_SHIFT 23 /* nl_q30 >> this: the level's number; 128 of them below nl = 1 */
#define GLINT_ALBEDO_LEVELS 392     /* three times 128, and some: whatever normals and lights are */
#define GLINT_ALBEDO_COLUMNS_LOG 11

/* SMALL: two segments of columns over t, the second one coarser, and words over nl. */
#define GLINT_SMALL_SEGMENT 192
#define GLINT_SMALL_COARSER 4  /* bits of t */
#define GLINT_SMALL_DIFFUSE 65 /* nl = 0, and 64 intervals of nl_q30 >> GLINT_COLOUR_ROW_SHIFT */

/* Spans: pixels that are judged together. A store of Thumb reaches 31 pixels from its address. */
#define GLINT_SPAN_RUN_LOG 5
#define GLINT_SPAN_RUN 32

#endif
