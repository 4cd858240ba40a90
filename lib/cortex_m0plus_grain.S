/* SPDX-License-Identifier: MIT
 * glint_line_grain(loop, x): the exact line of RGB565 under MSH with grain or a map of shininess, from pixel x on.
 *
 * As glint_line_rgb565 draws it, but for m in the place of n t: steps 2a and 3 of sequence.md, as grain.c and lobe_msh.c have them. Normals
 * that are no unit vectors or along U, and an F next to 2^-q, end the call as pixels do that V + W does not decide: C draws them. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus_line.inc"

/* Of the loop's t_end and k. */
#define END GLINT_AT_LINE_T_END
#define UP (GLINT_AT_LINE_K + 4 * GLINT_GRAIN_UP)
#define LEAST (GLINT_AT_LINE_K + 4 * GLINT_GRAIN_LEAST)
#define SHIFT (GLINT_AT_LINE_K + 4 * GLINT_GRAIN_SHIFT)

/* Behind what all lines have: GLINT_GRAIN_WORDS that are copied, in the order of the struct. */
#define WAY OURS
#define WAY_H (OURS + 8)
#define KIND (OURS + 12)
#define ACROSS (OURS + 16)
#define MORE (OURS + 20)
#define SWAP (OURS + 24)
#define MAP (OURS + 28)
#define SINES (OURS + 32)
#define PLACE (OURS + 36)
#define LINE (OURS + 40)
#define LINE_SIZE (OURS + 44)
#define LOG (OURS + 48)
#define IS_SPUN (OURS + 52)
/* The pixel's. */
#define NL (OURS + 56)
#define NORMAL (OURS + 60)
#define SQUARE (OURS + 64)
#define FRAME (OURS + 68)

/* N.U in nl and (N.V)^2 in constants, of U in nl and v; r0 is used. */
.macro along_across
    movs r0, x
    muls r0, v
    movs constants, y
    muls constants, nl
    subs constants, constants, r0
    asrs constants, constants, #15
    muls constants, constants
    muls nl, x
    muls v, y
    adds nl, nl, v
.endm

/* H.U of U in nl and v, to its place; r0 and constants are used. */
.macro along_half
    mov r0, minus_hx
    muls r0, nl
    mov constants, minus_hy
    muls constants, v
    adds r0, r0, constants
    rsbs r0, r0, #0
    str r0, [sp, #WAY_H]
.endm

    function glint_line_grain
    enter FRAME
    line_begin 0
    ldr r2, [sp, #OUR_LOOP]
    adds r2, #GLINT_AT_GRAIN
    add r3, sp, #OURS
.rept 3
    ldmia r2!, {r4-r7}
    stmia r3!, {r4-r7}
.endr
    ldmia r2!, {r4, r5}
    stmia r3!, {r4, r5}
    line_runs grain, FRAME

.Lgrain_dark:
    ldr y, [sp, #GLINT_AT_LINE_DARK]
    b .Lgrain_store
.Lgrain_bright:
    movs nl, #1
    lsls nl, nl, #16
    b .Lgrain_lit
.Lgrain_turned_to: /* what is too far for a branch on a condition */
    b .Lgrain_turns
.Lgrain_other:
    b .Lgrain_scale
.Lgrain_dull:
    b .Lgrain_far
.Lgrain_undecided:
    b .Lgrain_done

.Lgrain_pixel:
    normal
    ble .Lgrain_dark
    lsrs v, nl, #16
    bne .Lgrain_bright
.Lgrain_lit:
    str nl, [sp, #NL]
    str r0, [sp, #NORMAL]
    ldr r0, [sp, #KIND]
    cmp r0, #0
    bne .Lgrain_turned_to
    add constants, sp, #WAY
    ldmia constants!, {nl, v}
.Lgrain_way: /* U in nl and v, of length 1; H.U in its place */
    along_across
    movs r0, z
    muls r0, r0
    distance .Lgrain_dull
.Lgrain_apart: /* 2t in x, z^2 |U|^2 in r0, (N.V)^2 in constants, N.U in nl */
    lsrs x, x, #1
    lsrs y, x, #30
    bne .Lgrain_dull
    adds constants, constants, r0
    lsrs constants, constants, #3 /* d */
    lsrs y, x, #13
    adds y, #1
    lsrs y, y, #1
    asrs z, nl, #15
    adds z, #1
    asrs z, z, #1
    muls y, z
    subs y, y, nl
    ldr z, [sp, #WAY_H]
    adds y, y, z /* o */
    bpl 1f
    rsbs y, y, #0
1:  lsrs z, y, #30
    bne .Lgrain_undecided
    movs v, #10
    lsls constants, constants, #1
    lsrs z, constants, #27
    cmp z, #1
    bne .Lgrain_other
.Lgrain_scaled: /* D in constants, 11 less its shift in v */
    lsrs z, constants, #21
    subs z, #64
    ldr r0, [sp, #GLINT_AT_LINE_RECIPROCALS]
    ldrb z, [r0, z]
    muls constants, z
    asrs r0, constants, #14
    muls r0, r0
    lsrs r0, r0, #13
    asrs constants, constants, #6
    subs r0, r0, constants
    muls r0, z
    asrs r0, r0, #6
    lsls z, z, #23
    adds z, z, r0
    lsrs z, z, #14
    adds z, #1
    lsrs z, z, #1 /* i */
    lsrs r0, y, #14
    lsls y, y, #18
    lsrs y, y, #16
    muls y, r0
    lsrs y, y, #15
    muls r0, r0
    adds y, y, r0 /* S */
    lsrs r0, y, #16
    muls r0, z
    uxth y, y
    muls y, z
    lsrs y, y, #16
    adds y, y, r0
    lsrs y, v
    lsrs z, x, #8
    cmp y, z
    bls 1f
    movs y, z
1:  ldr r0, [sp, #ACROSS]
    muls z, r0
    ldr r0, [sp, #MORE]
    muls y, r0
    adds z, z, y
.Lgrain_m: /* m in z, t in x */
    ldr r0, [sp, #END]
    cmp z, r0
    blo 1f
    b .Lgrain_far
1:  movs constants, #1
    lsls constants, constants, #30
    subs constants, constants, x
    lsrs y, constants, #2
    lsls r0, y, #2
    adds y, y, r0
    lsrs y, y, #8
    adds z, z, y
    adds z, #2
    ldr r0, [sp, #UP]
    lsls z, r0
    ldr y, [sp, #SHIFT]
    lsrs v, z, #27
    beq .Lgrain_small
.Lgrain_ready:
    msh_reciprocal r0
    msh_quotient .Lgrain_high, .Lgrain_peak
.Lgrain_f: /* in constants */
    ldr y, [sp, #LEAST]
    cmp constants, y
    bls .Lgrain_least
.Lgrain_noted:
    cmp first, r1
    bhi .Lgrain_first
    str r1, [sp, #OUR_LAST]
    ldr nl, [sp, #NL]
    ldr r0, [sp, #NORMAL]
    channel z, x, 0, 0, y
    channel x, v, 1, 0, y
    channel v, y, 2, 0, y
.Lgrain_value:
    levels_held .Lgrain_held
.Lgrain_levels:
    levels .Lgrain_open
    ldr z, [sp, #SWAP]
    lsls x, y, #16
    orrs y, x
    rors y, z
.Lgrain_store:
    strh y, [r1]
    adds r1, #2
    cmp r1, run_end
    beq 1f
    b .Lgrain_pixel
1:  b .Lgrain_run

.Lgrain_open:
    b .Lgrain_done
.Lgrain_first:
    mov first, r1
    b .Lgrain_noted
.Lgrain_peak:
    ldr v, [sp, #GLINT_AT_LINE_F_MAX]
    cmp constants, v
    bls .Lgrain_f
    movs constants, v
    b .Lgrain_f
.Lgrain_held:
    held_all
    b .Lgrain_levels
.Lgrain_small:
    lsls z, z, #1
    subs y, #2
    lsrs v, z, #27
    beq .Lgrain_small
    b .Lgrain_ready
.Lgrain_least: /* is it 2^-q or 1 below it? */
    adds constants, #1
    cmp constants, y
    bhs .Lgrain_open
.Lgrain_far: /* F is 0 */
    ldr nl, [sp, #NL]
    ldr r0, [sp, #NORMAL]
    add constants, sp, #GLINT_AT_LINE_BASE
    ldmia constants!, {x, z}
    base_plain
    b .Lgrain_value
    .balign 4
.Lgrain_high:
    .word GLINT_MSH_GRAIN_HIGH

.Lgrain_scale: /* d is small, or its normal no unit vector */
    cmp z, #0
    bne .Lgrain_large
1:  subs v, #1
    bmi .Lgrain_open
    lsls constants, constants, #1
    lsrs z, constants, #27
    beq 1b
    b .Lgrain_scaled
.Lgrain_large:
    lsrs constants, constants, #1
    movs v, #11
    lsrs z, constants, #28
    bne .Lgrain_open
    b .Lgrain_scaled

.Lgrain_turns: /* where U is another at each pixel: kind in r0 */
    lsrs constants, r1, #1
    cmp r0, #GLINT_GRAIN_LINE_PLACE
    beq .Lgrain_place
    ldr v, [sp, #MAP]
    cmp r0, #GLINT_GRAIN_LINE_SHININESS
    beq .Lgrain_shininess
    ldrb r0, [v, constants]
    ldr constants, [sp, #SINES]
    movs v, #128
    subs v, v, r0
    bmi 1f
    lsls v, v, #1
    ldrh nl, [constants, v]
    lsls r0, r0, #1
    ldrh v, [constants, r0]
    b 2f
1:  movs r0, #128
    adds r0, r0, v
    rsbs v, v, #0
    lsls v, v, #1
    ldrh nl, [constants, v]
    rsbs nl, nl, #0
    lsls r0, r0, #1
    ldrh v, [constants, r0]
2:  along_half
    b .Lgrain_way

.Lgrain_shininess:
    ldrb r0, [v, constants]
    distance .Lgrain_far
    lsrs x, x, #1
    lsrs y, x, #30
    bne .Lgrain_far
    lsls y, r0, #2
    adds r0, r0, y
    lsrs y, r0, #7 /* the octave */
    lsls r0, r0, #25
    lsrs r0, r0, #25 /* f */
    movs z, #88
    muls z, r0
    movs v, #84
    lsls v, v, #8
    adds z, z, v
    muls r0, z
    lsrs r0, r0, #8
    movs z, #1
    lsls z, z, #14
    adds r0, r0, z
    movs z, #13
    subs z, z, y
    lsrs r0, z
    adds r0, #1
    lsrs r0, r0, #1 /* n */
    lsrs z, x, #8
    muls z, r0
    b .Lgrain_m

.Lgrain_place: /* x of the pixel in r0, of the line in v */
    ldr r0, [sp, #PLACE]
    lsls constants, r1, #3
    adds r0, r0, constants
    asrs constants, r0, #31
    movs nl, r0
    eors nl, constants
    subs nl, nl, constants
    ldr v, [sp, #LINE_SIZE]
    adds nl, nl, v
    ldr v, [sp, #LOG]
    movs constants, nl
    lsrs constants, v
    cmp constants, #1
    bne .Lgrain_log
.Lgrain_placed:
    movs constants, #30
    subs constants, constants, v
    ldr v, [sp, #LINE]
    lsls r0, constants
    asrs r0, r0, #16
    lsls v, constants
    asrs v, v, #16
    ldr nl, [sp, #IS_SPUN]
    cmp nl, #0
    beq 1f
    movs nl, v
    movs v, r0
    b 2f
1:  movs nl, r0
2:  along_half
    movs r0, nl
    muls r0, r0
    movs constants, v
    muls constants, constants
    adds r0, r0, constants
    lsls r0, r0, #1
    str r0, [sp, #SQUARE]
    along_across
    movs r0, z
    muls r0, r0
    lsls r0, r0, #1
    distance .Lgrain_outside
    ldr z, [sp, #SQUARE]
    lsrs y, r0, #16
    uxth r0, r0
    lsrs v, z, #16
    uxth z, z
    muls r0, v
    lsrs r0, r0, #16
    muls z, y
    lsrs z, z, #16
    muls y, v
    adds y, y, z
    adds r0, r0, y
    b .Lgrain_apart
.Lgrain_outside:
    b .Lgrain_far
.Lgrain_nowhere: /* the centre itself */
    b .Lgrain_done

.Lgrain_log: /* of the size in nl, near the pixel's before: 2^v up to twice that */
    bhi 2f
    cmp nl, #0
    beq .Lgrain_nowhere
1:  subs v, #1
    movs constants, nl
    lsrs constants, v
    beq 1b
    b 3f
2:  adds v, #1
    movs constants, nl
    lsrs constants, v
    cmp constants, #1
    bne 2b
3:  str v, [sp, #LOG]
    b .Lgrain_placed
#endif
