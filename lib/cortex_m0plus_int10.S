/* SPDX-License-Identifier: MIT
 * glint_colour_int10(tables, light, words, w, out): a line of 10-bit normals over COLOUR tables, the viewer at (0, 0, 1).
 * Rows as in cortex_m0plus_int8.S, but of three pixels: so far a branch reaches. */
#if defined GLINT_CORTEX_M0PLUS_ASM && GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

/* words in r0, out in r1 */
#define x r2
#define y r3
#define z r4
#define v r5
#define minus_m r6
#define t_half r7
#define minus_hx r8
#define minus_hy r9
#define minus_hz r10
#define peak r11
#define colours r12
#define last lr /* the last place of out where a row may begin */
#define AT_DARK 0
#define AT_END 4
#define AT_COLUMNS 8
#define AT_SHIFT 12

/* The next word, which stays in y at a gap: s in x; nl in z and in the flags. */
.macro int10_nl gap
    ldmia r0!, {y}
    lsls v, y, #20
    beq \gap
    asrs x, y, #22
    lsls x, x, #5
    lsls y, y, #10
    asrs y, y, #22
    lsls y, y, #5
    asrs z, v, #17
    add x, minus_hx
    muls x, x
    add y, minus_hy
    muls y, y
    adds x, x, y
    add z, minus_hz
    muls z, z
    adds x, x, z
    lsrs z, x, #14
    muls z, minus_m
    add z, peak
    asrs v, v, #2
    subs z, z, v
.endm

.macro int10_edge /* t_max / 2 - s in y; no carry where s is more */
    subs y, t_half, x
.endm

.macro int10_outside at
    lsrs z, z, #ROW_SHIFT_Q29
    lsls z, z, #GLINT_COLOUR_ROW_BYTES_LOG
    add z, colours
    ldrh z, [z]
    strh z, [r1, #2 * \at]
.endm

.macro int10_inside at
    ldr x, [sp, #AT_SHIFT]
    lsrs y, x
    ldr x, [sp, #AT_COLUMNS]
    ldrb y, [x, y]
    lsrs z, z, #ROW_SHIFT_Q29
    lsls z, z, #GLINT_COLOUR_ROW_BYTES_LOG
    add z, colours
    ldrh z, [z, y]
    strh z, [r1, #2 * \at]
.endm

.macro int10_dark at
    ldr x, [sp, #AT_DARK]
    strh x, [r1, #2 * \at]
.endm

.macro int10_next row /* three pixels are done */
    adds r1, #6
    cmp r1, last
    bls .Lint10_\row\()_0
    b .Lint10_rest
.endm

.macro int10_skip row /* out to the gap */
.irp at, 0, 1, 2
.Lint10_\row\()_gap_\at:
    adds r1, #2 * \at
    b .Lint10_gap
.endr
.endm

.macro int10_half at, to /* a component of H in Q14, negative */
    movs r3, #GLINT_AT_LIGHT_H + 2 * \at
    ldrsh r3, [r1, r3]
    adds r3, #1
    asrs r3, r3, #1
    rsbs r3, r3, #0
    mov \to, r3
.endm

    function glint_colour_int10
    enter 16
    ldrh r4, [r0, #GLINT_AT_TABLES_DARK]
    str r4, [sp, #AT_DARK]
    ldr r4, [sp, #SAVED + 16]
    lsls r3, r3, #1
    adds r3, r3, r4
    str r3, [sp, #AT_END]
    subs r3, #6
    mov last, r3
    ldr r3, [r0, #GLINT_AT_TABLES_COLUMNS]
    str r3, [sp, #AT_COLUMNS]
    ldrb r3, [r0, #GLINT_AT_TABLES_SHIFT]
    subs r3, #1
    str r3, [sp, #AT_SHIFT]
    ldr t_half, [r0, #GLINT_AT_TABLES_T_MAX]
    lsrs t_half, t_half, #1
    ldr r3, [r0, #GLINT_AT_TABLES_COLOUR]
    mov colours, r3
    mov r0, r2
    int10_half 0, minus_hx
    int10_half 1, minus_hy
    int10_half 2, minus_hz
    ldr r3, [r1, #GLINT_AT_LIGHT_PEAK]
    mov peak, r3
    asrs r3, r3, #15
    rsbs minus_m, r3, #0
    mov r1, r4
    b .Lint10_rest

.Lint10_gap: /* y is the word, r0 past it */
    lsrs y, y, #12
    bne 1f
    movs y, #1
1:  lsls y, y, #1
    ldr x, [sp, #AT_END]
    subs x, x, r1
    cmp y, x
    bhs .Lint10_done
    adds r1, r1, y
    lsls y, y, #1
    subs y, #4
    adds r0, r0, y
.Lint10_rest: /* how many are left? */
    cmp r1, last
    bhi 1f
    b .Lint10_out_0
1:  ldr x, [sp, #AT_END]
    cmp r1, x
    bhs .Lint10_done
    int10_nl .Lint10_gap
    bmi 2f
    int10_edge
    bhs 1f
    int10_outside 0
    adds r1, #2
    b .Lint10_rest
1:  int10_inside 0
    adds r1, #2
    b .Lint10_rest
2:  int10_dark 0
    adds r1, #2
    b .Lint10_rest
.Lint10_done:
    leave 16

    int10_skip dark
.irp at, 0, 1, 2
.Lint10_dark_\at:
    int10_nl .Lint10_dark_gap_\at
    bpl .Lint10_is_lit_\at
.Lint10_is_dark_\at:
    int10_dark \at
.endr
    int10_next dark

    int10_skip out
.irp at, 0, 1, 2
.Lint10_out_\at:
    int10_nl .Lint10_out_gap_\at
    bmi .Lint10_is_dark_\at
.Lint10_is_lit_\at:
    int10_edge
    bhs .Lint10_is_in_\at
.Lint10_is_out_\at:
    int10_outside \at
.endr
    int10_next out

.irp at, 0, 1, 2
.Lint10_in_\at:
    int10_nl .Lint10_in_gap_\at
    bmi .Lint10_in_dark_\at
    int10_edge
    blo .Lint10_is_out_\at
.Lint10_is_in_\at:
    int10_inside \at
.endr
    int10_next in
    int10_skip in
.irp at, 0, 1, 2
.Lint10_in_dark_\at:
    b .Lint10_is_dark_\at
.endr
#endif
