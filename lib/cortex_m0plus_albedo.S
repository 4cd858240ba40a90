/* SPDX-License-Identifier: MIT
 * glint_albedo_int8 and glint_albedo_int8_swapped(paint, words, albedo, w, out): a line of 8-bit normals over ALBEDO
 * tables.
 *
 * As in cortex_m0plus_int8.S each kind of pixel has a row, here of six, and where the next pixel is of another kind, it is in
 * that kind's row, at the same place, that the code goes on. Rows are longer than a conditional branch reaches: those lead
 * to islands before and behind.
 *
 * And glint_palette_line(colours, offsets, w, out): a load for the offset, one for the colour. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

/* Ours, from sp. */
#define OUR_LX 0
#define OUR_DARK 4
#define OUR_LAST 8 /* the last place of out where a row may begin */
#define OUR_END 12
#define OURS 16

#define x r2
#define v r3
#define z r4
#define lx r5
#define ly r6
#define albedo r7
#define lz r8
#define minus_cut r9
#define base r10 /* of shine; before it, downwards, levels */
#define gaps r11 /* between the fields of a word */
#define half r12
#define factor lr

#define ROW 6
#define LEVEL_SHIFT_Q25 (GLINT_ALBEDO_LEVEL_SHIFT - 5)

/* The next word: d in x and in the flags. */
.macro dot gap
    ldmia r0!, {v}
    asrs z, v, #16
    beq \gap
    sxtb x, v
    muls x, lx
    sxth v, v
    muls v, ly
    adds x, x, v
    mov v, lz
    muls v, z
    adds x, x, v
.endm

.macro edge /* e in z and in the flags */
    lsls z, z, #10
    add z, minus_cut
    subs z, z, x
.endm

/* The albedo times the level in x, as fields, in v; gaps in the spare register. */
.macro lit spare, at
    ldrh v, [albedo, #2 * \at]
    lsls \spare, v, #16
    orrs v, \spare
    mov \spare, gaps
    bics v, \spare
    muls v, x
    add v, half
    lsrs v, v, #5
    bics v, \spare
.endm

.macro store at, swapped
    lsrs x, v, #16
    orrs v, x
.if \swapped
    rev16 v, v
.endif
    strh v, [r1, #2 * \at]
.endm

.macro inside at, swapped, over, back
    mov v, factor
    muls z, v
    lsrs z, z, #32 - GLINT_ALBEDO_COLUMNS_LOG
    lsls z, z, #2
    mov v, base
    ldr z, [v, z]
    asrs x, x, #LEVEL_SHIFT_Q25
    ldrb x, [v, x]
    lit lx, \at
    adds v, v, z
    tst v, lx
    bne \over
\back:
    store \at, \swapped
    ldr lx, [sp, #OUR_LX]
.endm

.macro full back /* the fields with a guard set, which is in a gap: lx */
    movs x, v
    ands x, lx
    lsrs z, x, #6 /* green has a bit more */
    orrs v, z
    lsrs z, x, #5
    subs x, x, z
    orrs v, x
    bics v, lx
    b \back
.endm

.macro outside at, swapped
    asrs x, x, #LEVEL_SHIFT_Q25
    mov v, base
    ldrb x, [v, x]
    lit z, \at
    store \at, \swapped
.endm

.macro dark at, swapped
    ldr x, [sp, #OUR_DARK]
    lit z, \at
    store \at, \swapped
.endm

.macro next name, row /* a row is done */
    adds r1, #2 * ROW
    adds albedo, #2 * ROW
    ldr x, [sp, #OUR_LAST]
    cmp r1, x
    bhi 1f
    b .L\name\()_\row\()_0
1:  b .L\name\()_rest
.endm

/* Islands: where a pixel of a row is a gap, or of another kind. */
.macro to_gap name, row, at
.L\name\()_\row\()_gap_\at:
    adds r1, #2 * \at
    adds albedo, #2 * \at
    b .L\name\()_gap
.endm
.macro from_in name, at
    to_gap \name, in, \at
.L\name\()_in_dark_\at:
    b .L\name\()_is_dark_\at
.L\name\()_in_out_\at:
    b .L\name\()_is_out_\at
.endm
.macro from_out name, at
    to_gap \name, out, \at
.L\name\()_out_dark_\at:
    b .L\name\()_is_dark_\at
.L\name\()_out_in_\at:
    b .L\name\()_is_in_\at
.endm
.macro from_dark name, at
    to_gap \name, dark, \at
.L\name\()_dark_lit_\at:
    b .L\name\()_is_lit_\at
.endm
.macro over name, at
.L\name\()_over_\at:
    full .L\name\()_stored_\at
.endm

/* (paint, words, albedo, w, out) */
.macro albedo_int8 name, swapped
    function \name
    enter OURS
    ldr r5, [sp, #OURS + SAVED] /* out */
    lsls r4, r3, #1
    adds r4, r4, r5
    str r4, [sp, #OUR_END]
    subs r4, #2 * ROW
    str r4, [sp, #OUR_LAST]
    ldr r4, [r0, #GLINT_AT_TABLES_COLOUR]
    mov base, r4
    ldrh r4, [r0, #GLINT_AT_TABLES_DARK]
    str r4, [sp, #OUR_DARK]
    ldr r4, [r0, #GLINT_AT_PAINT_X + 8]
    mov lz, r4
    ldr r4, [r0, #GLINT_AT_PAINT_CUT]
    rsbs r4, r4, #0
    mov minus_cut, r4
    ldr r4, [r0, #GLINT_AT_PAINT_R]
    mov factor, r4
    ldr r4, 2f
    mov gaps, r4
    ldr r4, 3f
    mov half, r4
    movs albedo, r2
    mov r3, r5
    ldr lx, [r0, #GLINT_AT_PAINT_X]
    ldr ly, [r0, #GLINT_AT_PAINT_X + 4]
    str lx, [sp, #OUR_LX]
    mov r0, r1
    mov r1, r3
    b .L\name\()_rest
    .balign 4
2:  .word 0xf81f07e0
3:  .word 0x02008010

.L\name\()_gap: /* v is the word, r0 past it */
    cmp v, #0
    bne 1f
    movs v, #1
1:  lsls v, v, #1
    ldr x, [sp, #OUR_END]
    subs x, x, r1
    cmp v, x
    bhs .L\name\()_done
    adds r1, r1, v
    adds albedo, albedo, v
    lsls v, v, #1
    subs v, #4
    adds r0, r0, v
.L\name\()_rest: /* how many are left? */
    ldr x, [sp, #OUR_LAST]
    cmp r1, x
    bhi 1f
    b .L\name\()_out_0
1:  ldr x, [sp, #OUR_END]
    cmp r1, x
    bhs .L\name\()_done
    dot .L\name\()_gap
    bpl 3f
    edge
    bpl 1f
    outside 0, \swapped
    b 4f
1:  inside 0, \swapped, 6f, 5
    b 4f
3:  dark 0, \swapped
4:  adds r1, #2
    adds albedo, #2
    b .L\name\()_rest
6:  full 5b
.L\name\()_done:
    leave OURS

.irp at, 0, 1, 2
    from_dark \name, \at
.endr
.irp at, 0, 1, 2, 3, 4, 5
.L\name\()_dark_\at:
    dot .L\name\()_dark_gap_\at
    bmi .L\name\()_dark_lit_\at
.L\name\()_is_dark_\at:
    dark \at, \swapped
.endr
    next \name, dark
.irp at, 3, 4, 5
    from_dark \name, \at
.endr

.irp at, 0, 1, 2
    from_out \name, \at
.endr
.irp at, 0, 1, 2, 3, 4, 5
.L\name\()_out_\at:
    dot .L\name\()_out_gap_\at
    bpl .L\name\()_out_dark_\at
.L\name\()_is_lit_\at:
    edge
    bpl .L\name\()_out_in_\at
.L\name\()_is_out_\at:
    outside \at, \swapped
.endr
    next \name, out
.irp at, 3, 4, 5
    from_out \name, \at
.endr

.irp at, 0, 1, 2
    from_in \name, \at
    over \name, \at
.endr
.irp at, 0, 1, 2, 3, 4, 5
.L\name\()_in_\at:
    dot .L\name\()_in_gap_\at
    bpl .L\name\()_in_dark_\at
    edge
    bmi .L\name\()_in_out_\at
.L\name\()_is_in_\at:
    inside \at, \swapped, .L\name\()_over_\at, .L\name\()_stored_\at
.endr
    next \name, in
.irp at, 3, 4, 5
    from_in \name, \at
    over \name, \at
.endr
.endm

    albedo_int8 glint_albedo_int8, 0
    albedo_int8 glint_albedo_int8_swapped, 1

/* ---- a palette ---- */

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
