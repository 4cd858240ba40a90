/* SPDX-License-Identifier: MIT
 * Internal. COLOUR tables with dither (sequence.md): what lies where, and their fill. */
#ifndef GLINT_TABLES_DITHER_H
#define GLINT_TABLES_DITHER_H

#include "glint.h"
#include "glint_tables_geometry.h"

/* The fields of a sum, 5.4, 6.4 and 5.4 bits: red from bit 23, green from 1, blue from 12. Where a field overflows: bits 21 (blue) and
 * 11 (green), and the carry out of bit 31 (red). */
#define GLINT_DITHER_FIELDS UINT32_C(0xf81f07e0) /* their whole levels; with what is 16 bits above, a pixel */
#define GLINT_DITHER_GUARDS UINT32_C(0x00200800)

void glint_dither_fill(struct glint_tables *tables, const struct glint_shader *shader, void *memory);

#endif
