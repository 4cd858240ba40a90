/* SPDX-License-Identifier: MIT
 * The loops over COLOUR tables and palettes for ARMv6-M, by hand: what the C in loops_colour.c and loops.c does, bit for
 * bit. Empty unless GLINT_CORTEX_M0PLUS_ASM is 1, for the C and for this file. At most 44 bytes of stack.
 *
 * Neighbours are alike: each kind of pixel has a row of four, and where the next pixel is of the other kind, it is in the
 * other kind's row, at the same place, that the code goes on. So no pixel pays for a loop and few for a branch. */
#if defined GLINT_CORTEX_M0PLUS_ASM && GLINT_CORTEX_M0PLUS_ASM
    .syntax unified
    .cpu cortex-m0plus
    .thumb

/* Offsets in struct glint_tables and struct glint_tables_light; loops_colour.c compares them with the compiler's. */
#define COLUMNS 0
#define COLOURS 4
#define DARK 12
#define LIGHT_X 12
#define LIGHT_Y 16
#define LIGHT_Z 20
#define LIGHT_CUT 24
#define LIGHT_R 28
#define LIGHT_A 32

#define SAVED 36 /* bytes */

.macro function name
    .section .text.\name, "ax", %progbits
    .global \name
    .type \name, %function
    .balign 4
    .thumb_func
\name:
.endm

.macro enter bytes
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
    sub sp, #\bytes
.endm

.macro leave bytes
    add sp, #\bytes
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}
.endm

/* ---- glint_colour_int8(tables, light, words, w, out): words in r0, out in r1 ---- */

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
    lsrs x, x, #23
    lsls x, x, #7
    add x, colours
    ldrh x, [x]
    strh x, [r1, #2 * \at]
.endm

.macro int8_inside at
    mov z, exponent
    lsrs v, z
    mov z, factor
    muls v, z
    lsrs v, v, #20
    add v, columns
    ldrb v, [v]
    lsrs x, x, #23
    lsls x, x, #7
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
    ldrh r4, [r0, #DARK]
    str r4, [sp]
    ldr r4, [sp, #SAVED + 8]
    lsls r3, r3, #1
    adds r3, r3, r4
    str r3, [sp, #4] /* the end of out */
    subs r3, #8
    mov last, r3
    ldr r3, [r0, #COLUMNS]
    mov columns, r3
    ldr r3, [r0, #COLOURS]
    mov colours, r3
    mov r0, r2
    ldr r5, [r1, #LIGHT_CUT]
    rsbs r5, r5, #0
    mov minus_cut, r5
    ldr r5, [r1, #LIGHT_R]
    mov factor, r5
    adds r1, #LIGHT_X
    ldrb r5, [r1, #LIGHT_A - LIGHT_X]
    mov exponent, r5
    ldmia r1!, {lx, ly, lz}
    mov r1, r4
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

/* ---- glint_run_outside(colours, nl, dnl, out, end): all pixels lit, none in the lobe ---- */

.macro outside at
    lsrs r5, r1, #24
    lsls r5, r5, #7
    ldrh r5, [r0, r5]
    strh r5, [r3, #2 * \at]
    adds r1, r1, r2
.endm

    function glint_run_outside
    push {r4, r5, lr}
    ldr r4, [sp, #12]
    subs r4, #16
    b 2f
1:
.irp at, 0, 1, 2, 3, 4, 5, 6, 7
    outside \at
.endr
    adds r3, #16
2:  cmp r3, r4
    bls 1b
    adds r4, #16
    b 4f
3:  outside 0
    adds r3, #2
4:  cmp r3, r4
    blo 3b
    pop {r4, r5, pc}

/* ---- glint_run_inside(run, out, end), glint_run_mixed(run, out, end) ---- */

#define back r0
#define dback r1
#define colours r2
#define nl r3
#define out r4
#define shift r5
#define j r6
#define at r7
#define ddback r8
#define dnl r9
#define columns r10
#define last r11
#define limit r12
#define t_max lr

.macro run_enter /* end at sp, dark at sp + 4 */
    enter 8
    str r2, [sp]
    subs r2, #8
    mov last, r2
    mov out, r1
    ldr at, [r0, #8]
    mov ddback, at
    ldr at, [r0, #16]
    mov dnl, at
    ldr at, [r0, #20]
    mov columns, at
    ldr colours, [r0, #24]
    ldr shift, [r0, #28]
    ldr at, [r0, #32]
    mov t_max, at
    ldr at, [r0, #36]
    mov limit, at
    ldrh at, [r0, #40]
    str at, [sp, #4]
    ldr nl, [r0, #12]
    ldr dback, [r0, #4]
    ldr back, [r0]
.endm

.macro run_step
    add nl, dnl
    adds back, back, dback
    add dback, ddback
.endm

.macro inside i
    movs j, back
    lsrs j, shift
    add j, columns
    ldrb j, [j]
    lsrs at, nl, #24
    lsls at, at, #7
    adds at, at, j
    ldrh at, [colours, at]
    strh at, [out, #2 * \i]
    run_step
.endm

    function glint_run_inside
    run_enter
    b 2f
1:
.irp i, 0, 1, 2, 3
    inside \i
.endr
    adds out, #8
2:  cmp out, last
    bls 1b
    b 4f
3:  inside 0
    adds out, #2
4:  ldr at, [sp]
    cmp out, at
    blo 3b
    leave 8

.macro mixed_dark row /* dark in j, so that at keeps nothing */
.irp i, 0, 1, 2, 3
.Lmixed_\row\()_dark_\i:
    ldr j, [sp, #4]
    strh j, [out, #2 * \i]
    b .Lmixed_\row\()_step_\i
.endr
.endm

.macro mixed_next row
    adds out, #8
    cmp out, last
    bls .Lmixed_\row\()_0
    b .Lmixed_rest
.endm

    function glint_run_mixed
    run_enter
.Lmixed_rest:
    cmp out, last
    bls .Lmixed_past_0
    ldr at, [sp]
    cmp out, at
    bhs 5f
    asrs at, nl, #24
    bmi 3f
    movs j, #0
    cmp back, limit
    bhi 2f
    movs j, back
    cmp back, t_max
    bls 1f
    mov j, t_max
1:  lsrs j, shift
    add j, columns
    ldrb j, [j]
2:  lsls at, at, #7
    adds at, at, j
    ldrh at, [colours, at]
    b 4f
3:  ldr at, [sp, #4]
4:  strh at, [out]
    adds out, #2
    run_step
    b .Lmixed_rest
5:  leave 8

    mixed_dark past
.irp i, 0, 1, 2, 3
.Lmixed_past_\i:
    asrs at, nl, #24
    bmi .Lmixed_past_dark_\i
    cmp back, limit
    bls .Lmixed_is_in_\i
.Lmixed_is_past_\i:
    lsls at, at, #7
    ldrh at, [colours, at]
    strh at, [out, #2 * \i]
.Lmixed_past_step_\i:
    run_step
.endr
    mixed_next past

.irp i, 0, 1, 2, 3
.Lmixed_in_\i:
    asrs at, nl, #24
    bmi .Lmixed_in_dark_\i
.Lmixed_is_in_\i:
    movs j, back
    cmp back, t_max
    bhi .Lmixed_over_\i
.Lmixed_column_\i:
    lsrs j, shift
    add j, columns
    ldrb j, [j]
    lsls at, at, #7
    adds at, at, j
    ldrh at, [colours, at]
    strh at, [out, #2 * \i]
.Lmixed_in_step_\i:
    run_step
.endr
    mixed_next in
    mixed_dark in
.irp i, 0, 1, 2, 3
.Lmixed_over_\i: /* t is over t_max, or a little below 0 */
    mov j, t_max
    cmp back, limit
    bls .Lmixed_column_\i
    b .Lmixed_is_past_\i
.endr

#undef back
#undef dback
#undef colours
#undef nl
#undef out
#undef shift
#undef j
#undef at
#undef ddback
#undef dnl
#undef columns
#undef last
#undef limit
#undef t_max

/* ---- glint_palette_line(colours, offsets, w, out): a load for the offset, one for the colour ---- */

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
