/* SPDX-License-Identifier: MIT
 * Internal. Where the assembly finds fields of glint_line_loop, in bytes, and numbers that it shares with C; pixel_line.c
 * compares them with the compiler's. Macros only: assembly includes it. */
#ifndef GLINT_PIXEL_OFFSETS_H
#define GLINT_PIXEL_OFFSETS_H

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
#define GLINT_AT_LINE_LIT 112

#endif
