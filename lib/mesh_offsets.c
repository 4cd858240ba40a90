/* SPDX-License-Identifier: MIT
 * What the assembly takes for granted of a triangle: arrays of -1 where it is not so. */
#include "glint_mesh_offsets.h"
#include "glint_math_assembly.h"
#include "glint_mesh_colour.h"

typedef char glint_shine_order[GLINT_MESH_DARK == GLINT_SHINE_DARK && GLINT_MESH_MATT == GLINT_SHINE_MATT ? 1 : -1];

#if GLINT_CORTEX_M0PLUS_ASM
#define AT(field, offset) (offsetof(struct glint_mesh_triangle, field) == (offset))
typedef char
    glint_triangle_layout[AT(values.x, GLINT_AT_TRIANGLE_X) && AT(values.z, GLINT_AT_TRIANGLE_Z) &&
                                  AT(values.zx, GLINT_AT_TRIANGLE_ZX) && AT(values.zy, GLINT_AT_TRIANGLE_ZY) &&
                                  AT(values.nl, GLINT_AT_TRIANGLE_NL) && AT(values.nlx, GLINT_AT_TRIANGLE_NLX) &&
                                  AT(values.nly, GLINT_AT_TRIANGLE_NLY) && AT(values.t, GLINT_AT_TRIANGLE_T) &&
                                  AT(values.tx, GLINT_AT_TRIANGLE_T + 4) && AT(values.txx, GLINT_AT_TRIANGLE_T + 8) &&
                                  AT(values.txy, GLINT_AT_TRIANGLE_T + 12) && AT(values.ty, GLINT_AT_TRIANGLE_TY) &&
                                  AT(values.tyy, GLINT_AT_TRIANGLE_TY + 4) && AT(long_edge, GLINT_AT_TRIANGLE_LONG) &&
                                  AT(upper, GLINT_AT_TRIANGLE_LONG + 8) && AT(lower, GLINT_AT_TRIANGLE_LONG + 16) &&
                                  AT(y, GLINT_AT_TRIANGLE_Y) && AT(y_middle, GLINT_AT_TRIANGLE_Y_MIDDLE) &&
                                  AT(y_end, GLINT_AT_TRIANGLE_Y_END) && AT(shine, GLINT_AT_TRIANGLE_SHINE) &&
                                  AT(long_is_left, GLINT_AT_TRIANGLE_LONG_IS_LEFT)
                              ? 1
                              : -1];
#undef AT
#define AT(field, offset) (offsetof(struct glint_mesh_target, field) == (offset))
typedef char glint_target_layout[AT(surface, 0) && AT(depth, 4) && AT(w, 8) && AT(y, 12) && AT(end, 16) &&
                                         offsetof(struct glint_surface, pixels) == 0 &&
                                         offsetof(struct glint_surface, stride) == 4
                                     ? 1
                                     : -1];
#undef AT
#endif
