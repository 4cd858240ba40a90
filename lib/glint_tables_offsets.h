/* SPDX-License-Identifier: MIT
 * Internal. Where the assembly finds fields of the structs, in bytes; tables_offsets.c compares these with the compiler's.
 * Macros only: assembly includes it. */
#ifndef GLINT_TABLES_OFFSETS_H
#define GLINT_TABLES_OFFSETS_H

#define GLINT_AT_TABLES_COLUMNS 0
#define GLINT_AT_TABLES_COLOUR 4 /* behind columns: one load of two words has both */
#define GLINT_AT_TABLES_T_MAX 8
#define GLINT_AT_TABLES_DARK 12
#define GLINT_AT_TABLES_KIND 14
#define GLINT_AT_TABLES_SHIFT 16
#define GLINT_AT_TABLES_DITHER 17

#define GLINT_AT_LIGHT_H 6
#define GLINT_AT_LIGHT_X 12 /* x, y, z: one load of three words */
#define GLINT_AT_LIGHT_CUT 24
#define GLINT_AT_LIGHT_PEAK 28
#define GLINT_AT_LIGHT_R 32
#define GLINT_AT_LIGHT_A 36

#define GLINT_AT_SPAN_W 20 /* t, dt, ddt, nl, dnl before it, from 0 on */

#define GLINT_NEGATIVE_T_LOG 27 /* GLINT_NEGATIVE_T is 2^32 less 2 to this */

#endif
