/* SPDX-License-Identifier: MIT
 * Internal. 1: cortex_m0plus_*.S, assembled with the same definition, take the place of the C loops of the same names. */
#ifndef GLINT_MATH_ASSEMBLY_H
#define GLINT_MATH_ASSEMBLY_H

#ifndef GLINT_CORTEX_M0PLUS_ASM
#define GLINT_CORTEX_M0PLUS_ASM 0
#endif

#endif
