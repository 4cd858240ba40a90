/* SPDX-License-Identifier: MIT
 * Internal. COLOUR tables (sequence.md): their fill, and a light for the loops over them. */
#ifndef GLINT_TABLES_COLOUR_H
#define GLINT_TABLES_COLOUR_H

#include "glint_tables_columns.h"

void glint_colour_fill(struct glint_tables *tables, const struct glint_peak *peak, void *memory);
/* Sets what the loops over COLOUR tables read of a light whose l, h and kind are set. */
void glint_colour_light(struct glint_tables_light *light, const struct glint_tables *tables);

#endif
