/* SPDX-License-Identifier: MIT
 * Internal. SMALL tables: any format, any address. */
#ifndef GLINT_LOOPS_SMALL_H
#define GLINT_LOOPS_SMALL_H

#include "glint.h"
#include "glint_tables_geometry.h"

void glint_small_rect(const struct glint_tables *tables, const struct glint_tables_light *light,
                      enum glint_normals format, const void *normals, ptrdiff_t stride, uint16_t w, uint16_t h,
                      const struct glint_surface *surface);
void glint_small_span(const struct glint_tables *tables, const struct glint_span *span,
                      const struct glint_surface *surface);

/* The highlight's step, 0..63, for t up to the tables' t_max_q30. */
static inline uint8_t glint_small_column(const struct glint_tables *tables, uint32_t t_q30)
{
    const uint32_t fine = t_q30 >> tables->shift;
    return tables->columns[fine < GLINT_SMALL_SEGMENT ? fine : GLINT_SMALL_SEGMENT + (fine >> GLINT_SMALL_COARSER)];
}

#endif
