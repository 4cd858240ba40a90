/* SPDX-License-Identifier: MIT
 * Internal. A line over COLOUR tables: aligned 2-byte pixels. int8 and int10 have twins in assembly; they need a light
 * whose viewer is at (0, 0, 1); vec and int10_aside take any. */
#ifndef GLINT_LOOPS_COLOUR_H
#define GLINT_LOOPS_COLOUR_H

#include "glint.h"

void glint_colour_vec(const struct glint_tables *tables, const struct glint_tables_light *light,
                      const struct glint_vec *normals, uint16_t w, uint16_t *out);
void glint_colour_int10(const struct glint_tables *tables, const struct glint_tables_light *light,
                        const uint32_t *words, uint16_t w, uint16_t *out);
void glint_colour_int10_aside(const struct glint_tables *tables, const struct glint_tables_light *light,
                              const uint32_t *words, uint16_t w, uint16_t *out);
void glint_colour_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       uint16_t w, uint16_t *out);

#endif
