/* SPDX-License-Identifier: MIT
 * What the assembly takes for granted (glint_tables_offsets.h, glint_tables_geometry.h): arrays of -1 where it is not so. */
#include "glint_tables_offsets.h"
#include "glint_math_assembly.h"
#include "glint_pixel.h"
#include "glint_tables_geometry.h"

typedef char glint_geometry[(int64_t)GLINT_COLOUR_ROWS << GLINT_COLOUR_ROW_SHIFT == (int64_t)1 << 31 &&
                                    1 << GLINT_COLOUR_ROW_BYTES_LOG == 2 * GLINT_COLOUR_STEPS &&
                                    1 << GLINT_SPAN_RUN_LOG == GLINT_SPAN_RUN && GLINT_SPAN_RUN <= 32
                                ? 1
                                : -1];

#if GLINT_CORTEX_M0PLUS_ASM
#define AT(type, field, offset) (offsetof(struct type, field) == (offset))
typedef char glint_tables_layout
    [AT(glint_tables, columns, GLINT_AT_TABLES_COLUMNS) && AT(glint_tables, colour, GLINT_AT_TABLES_COLOUR) &&
             AT(glint_tables, t_max_q30, GLINT_AT_TABLES_T_MAX) && AT(glint_tables, dark, GLINT_AT_TABLES_DARK) &&
             AT(glint_tables, kind, GLINT_AT_TABLES_KIND) && AT(glint_tables, shift, GLINT_AT_TABLES_SHIFT) &&
             AT(glint_tables, dither, GLINT_AT_TABLES_DITHER) &&
             GLINT_AT_TABLES_COLOUR == GLINT_AT_TABLES_COLUMNS + 4 && GLINT_TABLES_COLOUR == 0
         ? 1
         : -1];
typedef char glint_light_layout
    [AT(glint_tables_light, h, GLINT_AT_LIGHT_H) && AT(glint_tables_light, x, GLINT_AT_LIGHT_X) &&
             AT(glint_tables_light, y, GLINT_AT_LIGHT_X + 4) && AT(glint_tables_light, z, GLINT_AT_LIGHT_X + 8) &&
             AT(glint_tables_light, cut, GLINT_AT_LIGHT_CUT) && AT(glint_tables_light, peak, GLINT_AT_LIGHT_PEAK) &&
             AT(glint_tables_light, r, GLINT_AT_LIGHT_R) && AT(glint_tables_light, a, GLINT_AT_LIGHT_A)
         ? 1
         : -1];
typedef char glint_span_layout[AT(glint_span, t_q30, 0) && AT(glint_span, dt_q30, 4) && AT(glint_span, ddt_q30, 8) &&
                                       AT(glint_span, nl_q30, 12) && AT(glint_span, dnl_q30, 16) &&
                                       AT(glint_span, w, GLINT_AT_SPAN_W) && AT(glint_surface, pixels, 0) &&
                                       GLINT_NEGATIVE_T == UINT32_C(0) - (UINT32_C(1) << GLINT_NEGATIVE_T_LOG)
                                   ? 1
                                   : -1];
#undef AT
#endif
