/* SPDX-License-Identifier: MIT
 * What the assembly takes for granted of the structs (cortex_m0plus.inc): arrays of -1 where it is not so. */
#include "glint_tables.h"

#if GLINT_CORTEX_M0PLUS_ASM
#define AT(type, field, offset) (offsetof(struct type, field) == (offset))
typedef char glint_tables_layout[AT(glint_tables, columns, 0) && AT(glint_tables, colour, 4) &&
                                         AT(glint_tables, t_max_q30, 8) && AT(glint_tables, dark, 12) &&
                                         AT(glint_tables, kind, 14) && AT(glint_tables, shift, 16) &&
                                         GLINT_TABLES_COLOUR == 0
                                     ? 1
                                     : -1];
typedef char glint_light_layout[AT(glint_tables_light, h, 6) && AT(glint_tables_light, x, 12) &&
                                        AT(glint_tables_light, y, 16) && AT(glint_tables_light, z, 20) &&
                                        AT(glint_tables_light, cut, 24) && AT(glint_tables_light, peak, 28) &&
                                        AT(glint_tables_light, r, 32) && AT(glint_tables_light, a, 36)
                                    ? 1
                                    : -1];
typedef char glint_span_layout[AT(glint_span, t_q30, 0) && AT(glint_span, dt_q30, 4) && AT(glint_span, ddt_q30, 8) &&
                                       AT(glint_span, nl_q30, 12) && AT(glint_span, dnl_q30, 16) &&
                                       AT(glint_span, w, 20) && AT(glint_surface, pixels, 0) &&
                                       GLINT_NEGATIVE_T == UINT32_C(0) - (UINT32_C(1) << 27)
                                   ? 1
                                   : -1];
#endif
