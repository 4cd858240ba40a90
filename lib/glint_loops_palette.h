/* SPDX-License-Identifier: MIT
 * Internal. */
#ifndef GLINT_LOOPS_PALETTE_H
#define GLINT_LOOPS_PALETTE_H

#include <stdint.h>

/* A line of a palette; with a twin in assembly. */
void glint_palette_line(const uint16_t *colours, const uint16_t *offsets, uint16_t w, uint16_t *out);

#endif
