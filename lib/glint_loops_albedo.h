/* SPDX-License-Identifier: MIT
 * Internal. A line of INT8 over ALBEDO tables: aligned 2-byte pixels, as 16-bit numbers, or those with their bytes swapped.
 * The assembly has twins of both. */
#ifndef GLINT_LOOPS_ALBEDO_H
#define GLINT_LOOPS_ALBEDO_H

#include "glint.h"

void glint_albedo_int8(const struct glint_tables *tables, const struct glint_tables_light *light, const uint32_t *words,
                       const uint16_t *albedo, uint16_t w, uint16_t *out);
void glint_albedo_int8_swapped(const struct glint_tables *tables, const struct glint_tables_light *light,
                               const uint32_t *words, const uint16_t *albedo, uint16_t w, uint16_t *out);

#endif
