/* SPDX-License-Identifier: MIT
 * glint_dither_int8_plain and _swapped(paint, words, w, out, phase, y): a line of 8-bit normals over COLOUR tables with dither.
 *
 * Rows of four as in cortex_m0plus_int8.S, which begin where x mod 4 is 0: a pixel's place in the row is then its place in the
 * tables. Rows are longer than a conditional branch reaches, so some lead to islands, as in cortex_m0plus_albedo.S. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

/* Ours, from sp. */
#define OUR_EXPONENT 0
#define OUR_GUARDS 4
#define OUR_FIELDS 8
#define OUR_LAST 12 /* the last place of out where a row may begin */
#define OUR_END 16
#define OUR_START 20 /* out, less the phase */
#define OUR_LX 24
#define OURS 28

/* words in r0, out in r1 */
#define x r2
#define v r3
#define z r4
#define lx r5
#define ly r6
#define lz r7
#define minus_cut r8
#define pixels r9
#define sums r10
#define shines r11
#define factor r12
#define nudge lr

#define DITHER_SHIFT_Q29 (GLINT_DITHER_ROW_SHIFT - 1)

/* The next word: d in x and in the flags, 2^14 z in v. */
.macro dot gap
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

.macro edge /* e in v and in the flags */
    add v, minus_cut
    adds v, v, x
.endm

.macro past /* the row's address in x */
    add x, nudge
    lsrs x, x, #DITHER_SHIFT_Q29
    lsls x, x, #GLINT_DITHER_PIXELS_LOG
    add x, pixels
.endm

.macro sum_of /* the row's address in x, the shine in v */
    ldr z, [sp, #OUR_EXPONENT]
    lsrs v, z
    mov z, factor
    muls v, z
    lsrs v, v, #32 - GLINT_DITHER_COLUMNS_LOG
    lsls v, v, #2
    add v, shines
    ldr v, [v]
    add x, nudge
    lsrs x, x, #DITHER_SHIFT_Q29
    lsls x, x, #GLINT_DITHER_SUMS_LOG
    add x, sums
.endm

.macro put at, swapped, full, back /* x, a row's sum, and v, the shine */
    adds x, x, v
    bcs \full
    ldr z, [sp, #OUR_GUARDS]
    tst x, z
    bne \full
\back:
    ldr z, [sp, #OUR_FIELDS]
    ands x, z
    lsrs v, x, #16
    orrs x, v
.if \swapped
    rev16 x, x
.endif
    strh x, [r1, #2 * \at]
.endm

.macro full back /* C: red is over; the guards tell the others */
    sbcs v, v
    mvns v, v
    lsls v, v, #27
    orrs x, v
    ldr z, [sp, #OUR_GUARDS]
    ands z, x
    lsrs v, z, #5
    subs v, z, v
    orrs x, v
    lsrs z, z, #6 /* green has a bit more */
    orrs x, z
    b \back
.endm

.macro within at, swapped, full, back
    sum_of
    ldr x, [x, #4 * \at]
    put \at, \swapped, \full, \back
.endm

.macro outside at
    past
    ldrh x, [x, #2 * \at]
    strh x, [r1, #2 * \at]
.endm

.macro dark at
    mov x, pixels
    subs x, #1 << GLINT_DITHER_PIXELS_LOG
    ldrh x, [x, #2 * \at]
    strh x, [r1, #2 * \at]
.endm

.macro phase to, with /* 2 (x mod 4) */
    ldr \to, [sp, #OUR_START]
    subs \to, r1, \to
    movs \with, #6
    ands \to, \with
.endm

.macro next name, row /* a row is done */
    adds r1, #8
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
    b .L\name\()_gap
.endm
.macro from_in name, at
    to_gap \name, in, \at
.L\name\()_in_dark_\at:
    b .L\name\()_is_dark_\at
.L\name\()_in_out_\at:
    b .L\name\()_is_out_\at
.L\name\()_over_\at:
    full .L\name\()_stored_\at
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

.macro dither_int8 name, swapped
    function \name
    enter OURS
    lsls r5, r2, #1
    adds r5, r5, r3
    str r5, [sp, #OUR_END]
    subs r5, #8
    str r5, [sp, #OUR_LAST]
    ldr r5, [sp, #OURS + SAVED]
    subs r5, r3, r5
    str r5, [sp, #OUR_START]
    ldr r5, 2f
    str r5, [sp, #OUR_GUARDS]
    ldr r5, 3f
    str r5, [sp, #OUR_FIELDS]
    ldr r5, [sp, #OURS + SAVED + 4]
    lsls r5, r5, #30
    lsrs r5, r5, #30 /* y mod 4 */
    ldr r6, [r0, #GLINT_AT_TABLES_COLUMNS]
    mov shines, r6
    ldr r6, [r0, #GLINT_AT_TABLES_COLOUR]
    ldr r7, 4f
    muls r7, r5
    adds r7, r7, r6
    adds r7, #1 << GLINT_DITHER_PIXELS_LOG
    mov pixels, r7
    ldr r7, 5f
    muls r7, r5
    adds r7, r7, r6
    ldr r6, 6f
    adds r7, r7, r6
    mov sums, r7
    lsls r5, r5, #2
    ldr r6, 7f
    lsrs r6, r5
    lsls r6, r6, #28
    lsrs r6, r6, #32 - GLINT_DITHER_ROW_SHIFT /* 4 bits, to the eighths of a row in Q29 */
    mov nudge, r6
    ldr r5, [r0, #GLINT_AT_PAINT_CUT]
    rsbs r5, r5, #0
    mov minus_cut, r5
    ldr r5, [r0, #GLINT_AT_PAINT_R]
    mov factor, r5
    adds r0, #GLINT_AT_PAINT_X
    ldrb r5, [r0, #GLINT_AT_PAINT_A - GLINT_AT_PAINT_X]
    str r5, [sp, #OUR_EXPONENT]
    ldmia r0!, {lx, ly, lz}
    str lx, [sp, #OUR_LX]
    mov r0, r1
    mov r1, r3
    b .L\name\()_rest
    .balign 4
2:  .word 0x00200800
3:  .word 0xf81f07e0
4:  .word GLINT_DITHER_PIXELS_PART
5:  .word GLINT_DITHER_SUMS_PART
6:  .word GLINT_DITHER_SUMS
7:  .word 0x3157

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
    lsls v, v, #1
    subs v, #4
    adds r0, r0, v
.L\name\()_rest: /* how many are left, and does a row begin here? */
    ldr x, [sp, #OUR_START]
    subs x, r1, x
    lsls x, x, #29
    bne 1f
    ldr x, [sp, #OUR_LAST]
    cmp r1, x
    bhi 1f
    b .L\name\()_out_0
1:  ldr x, [sp, #OUR_END]
    cmp r1, x
    bhs .L\name\()_done
    dot .L\name\()_gap
    bmi 3f
    edge
    bpl 1f
    past
    b 2f
3:  mov x, pixels
    subs x, #1 << GLINT_DITHER_PIXELS_LOG
2:  phase v, z
    ldrh x, [x, v]
    strh x, [r1]
    b 4f
1:  sum_of
    mov z, x
    phase x, lx /* for a moment */
    lsls x, x, #1
    ldr x, [z, x]
    ldr lx, [sp, #OUR_LX]
    put 0, \swapped, 6f, 5
4:  adds r1, #2
    b .L\name\()_rest
6:  full 5b
.L\name\()_done:
    leave OURS

.irp at, 0, 1, 2, 3
    from_dark \name, \at
.endr
.irp at, 0, 1, 2, 3
.L\name\()_dark_\at:
    dot .L\name\()_dark_gap_\at
    bpl .L\name\()_dark_lit_\at
.L\name\()_is_dark_\at:
    dark \at
.endr
    next \name, dark

.irp at, 0, 1
    from_out \name, \at
.endr
.irp at, 0, 1, 2, 3
.L\name\()_out_\at:
    dot .L\name\()_out_gap_\at
    bmi .L\name\()_out_dark_\at
.L\name\()_is_lit_\at:
    edge
    bpl .L\name\()_out_in_\at
.L\name\()_is_out_\at:
    outside \at
.endr
    next \name, out
.irp at, 2, 3
    from_out \name, \at
.endr

.irp at, 0, 1
    from_in \name, \at
.endr
.irp at, 0, 1, 2, 3
.L\name\()_in_\at:
    dot .L\name\()_in_gap_\at
    bmi .L\name\()_in_dark_\at
    edge
    bmi .L\name\()_in_out_\at
.L\name\()_is_in_\at:
    within \at, \swapped, .L\name\()_over_\at, .L\name\()_stored_\at
.endr
    next \name, in
.irp at, 2, 3
    from_in \name, \at
.endr
.endm

    dither_int8 glint_dither_int8_plain, 0
    dither_int8 glint_dither_int8_swapped, 1
#endif
