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

/* SMALL: two segments of columns over t, the second one coarser, and words over nl. */
#define GLINT_SMALL_SEGMENT 192
#define GLINT_SMALL_COARSER 4  /* bits of t */
#define GLINT_SMALL_DIFFUSE 65 /* nl = 0, and 64 intervals of nl_q30 >> GLINT_COLOUR_ROW_SHIFT */

/* Spans: pixels that are judged together. A store of Thumb reaches 31 pixels from its address. */
#define GLINT_SPAN_RUN_LOG 5
#define GLINT_SPAN_RUN 32

#endif
