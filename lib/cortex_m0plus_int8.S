/* SPDX-License-Identifier: MIT
 * glint_colour_int8(paint, words, w, out): a line of 8-bit normals over COLOUR tables.
 *
 * Neighbours are alike: each kind of pixel has a row of four, and where the next pixel is of the other kind, it is in the
 * other kind's row, at the same place, that the code goes on. So no pixel pays for a loop and few for a branch. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

/* words in r0, out in r1 */
#define x r2
#define v r3
#define z r4
#define lx r5
#define ly r6
#define lz r7
#define minus_cut r8
#define columns r9
#define colours r10
#define last r11 /* the last place of out where a row of four may begin */
#define factor r12
#define exponent lr

/* The next word: d in x and in the flags, 2^14 z in v. */
.macro int8_dot gap
    ldmia r0!, {v}
    asrs z, v, #16
    beq \gap
    sxtb x, v
    muls x, lx
    sxth v, v
    muls v, ly
    adds x, x, v
    lsls v, z, #14
    muls z, lz
    adds x, x, z
.endm

.macro int8_edge /* e in v and in the flags */
    add v, minus_cut
    adds v, v, x
.endm

.macro int8_outside at
    lsrs x, x, #ROW_SHIFT_Q29
    lsls x, x, #GLINT_COLOUR_ROW_BYTES_LOG
    add x, colours
    ldrh x, [x]
    strh x, [r1, #2 * \at]
.endm

.macro int8_inside at
    mov z, exponent
    lsrs v, z
    mov z, factor
    muls v, z
    lsrs v, v, #32 - GLINT_COLOUR_COLUMNS_LOG
    add v, columns
    ldrb v, [v]
    lsrs x, x, #ROW_SHIFT_Q29
    lsls x, x, #GLINT_COLOUR_ROW_BYTES_LOG
    add x, colours
    ldrh x, [x, v]
    strh x, [r1, #2 * \at]
.endm

.macro int8_dark at
    ldr x, [sp]
    strh x, [r1, #2 * \at]
.endm

.macro int8_next row /* four pixels are done */
    adds r1, #8
    cmp r1, last
    bls .Lint8_\row\()_0
    b .Lint8_rest
.endm

.macro int8_skip row /* out to the gap */
.irp at, 0, 1, 2, 3
.Lint8_\row\()_gap_\at:
    adds r1, #2 * \at
    b .Lint8_gap
.endr
.endm

    function glint_colour_int8
    enter 8
    ldrh r4, [r0, #GLINT_AT_TABLES_DARK]
    str r4, [sp]
    lsls r2, r2, #1
    adds r2, r2, r3
    str r2, [sp, #4] /* the end of out */
    subs r2, #8
    mov last, r2
    ldr r2, [r0, #GLINT_AT_TABLES_COLUMNS]
    mov columns, r2
    ldr r2, [r0, #GLINT_AT_TABLES_COLOUR]
    mov colours, r2
    ldr r5, [r0, #GLINT_AT_PAINT_CUT]
    rsbs r5, r5, #0
    mov minus_cut, r5
    ldr r5, [r0, #GLINT_AT_PAINT_R]
    mov factor, r5
    adds r0, #GLINT_AT_PAINT_X
    ldrb r5, [r0, #GLINT_AT_PAINT_A - GLINT_AT_PAINT_X]
    mov exponent, r5
    ldmia r0!, {lx, ly, lz}
    mov r0, r1
    mov r1, r3
    b .Lint8_rest

.Lint8_gap: /* v is the word, r0 past it */
    cmp v, #0
    bne 1f
    movs v, #1
1:  lsls v, v, #1
    ldr x, [sp, #4]
    subs x, x, r1
    cmp v, x
    bhs .Lint8_done
    adds r1, r1, v
    lsls v, v, #1
    subs v, #4
    adds r0, r0, v
.Lint8_rest: /* how many are left? */
    cmp r1, last
    bls .Lint8_out_0
    ldr x, [sp, #4]
    cmp r1, x
    bhs .Lint8_done
    int8_dot .Lint8_gap
    bmi 2f
    int8_edge
    bpl 1f
    int8_outside 0
    adds r1, #2
    b .Lint8_rest
1:  int8_inside 0
    adds r1, #2
    b .Lint8_rest
2:  int8_dark 0
    adds r1, #2
    b .Lint8_rest
.Lint8_done:
    leave 8

    int8_skip dark
.irp at, 0, 1, 2, 3
.Lint8_dark_\at:
    int8_dot .Lint8_dark_gap_\at
    bpl .Lint8_is_lit_\at
.Lint8_is_dark_\at:
    int8_dark \at
.endr
    int8_next dark

    int8_skip out
.irp at, 0, 1, 2, 3
.Lint8_out_\at:
    int8_dot .Lint8_out_gap_\at
    bmi .Lint8_is_dark_\at
.Lint8_is_lit_\at:
    int8_edge
    bpl .Lint8_is_in_\at
.Lint8_is_out_\at:
    int8_outside \at
.endr
    int8_next out

.irp at, 0, 1, 2, 3
.Lint8_in_\at:
    int8_dot .Lint8_in_gap_\at
    bmi .Lint8_in_dark_\at
    int8_edge
    bmi .Lint8_is_out_\at
.Lint8_is_in_\at:
    int8_inside \at
.endr
    int8_next in
    int8_skip in
.irp at, 0, 1, 2, 3
.Lint8_in_dark_\at:
    b .Lint8_is_dark_\at
.endr

#undef x
#undef v
#undef z
#undef lx
#undef ly
#undef lz
#undef minus_cut
#undef columns
#undef colours
#undef last
#undef factor
#undef exponent
#endif
