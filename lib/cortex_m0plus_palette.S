/* SPDX-License-Identifier: MIT
 * glint_palette_line(colours, offsets, w, out): a load for the offset, one for the colour. */
#if defined GLINT_CORTEX_M0PLUS_ASM && GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

.macro palette at
    ldrh r4, [r1, #2 * \at]
    ldrh r4, [r0, r4]
    strh r4, [r3, #2 * \at]
.endm

    function glint_palette_line
    push {r4, lr}
    lsls r2, r2, #1
    adds r2, r2, r3 /* the end of out */
    subs r2, #32
    b 2f
1:
.irp at, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15
    palette \at
.endr
    adds r1, #32
    adds r3, #32
2:  cmp r3, r2
    bls 1b
    adds r2, #32
    b 4f
3:  palette 0
    adds r1, #2
    adds r3, #2
4:  cmp r3, r2
    blo 3b
    pop {r4, pc}
#endif
