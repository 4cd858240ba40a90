/* SPDX-License-Identifier: MIT
 * Internal. SMALL tables: any format, any address. */
#ifndef GLINT_LOOPS_SMALL_H
#define GLINT_LOOPS_SMALL_H

#include "glint.h"

void glint_small_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w, uint16_t h,
                      const struct glint_surface *surface);
void glint_small_span(const struct glint_tables *tables, const struct glint_span *span,
                      const struct glint_surface *surface);

#endif
