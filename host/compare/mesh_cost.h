/* SPDX-License-Identifier: MIT
 * What a mesh's picture costs a Cortex-M0+, predicted. */
#ifndef GLINT_COMPARE_MESH_COST_H
#define GLINT_COMPARE_MESH_COST_H

#include "draw/view.h"
#include "mesh/fit.h"

/* Cycles of a picture by COLOUR tables, in strips of 16 lines, with the library at -O2 in RAM. */
struct mesh_cycles {
    double c, assembly; /* with GLINT_CORTEX_M0PLUS_ASM=1 */
};
struct mesh_cycles mesh_cycles(const struct mesh *mesh, const struct fitted *fitted, const struct view *view);

#endif
