/* SPDX-License-Identifier: MIT
 * glint_line_rgb565(loop, x), _swapped, _albedo, _albedo_swapped: the exact line of RGB565 under MSH, from pixel x on; _soft, _soft_swapped:
 * pixels of it that are covered in part, blended as coverage.c does, side by side; _steps, _steps_swapped: with paint.c's steps; _span: of a
 * span, in either order, with steps or without.
 *
 * The stages of an exact run in one loop: t and N.L from the normal (sample.c), where t is within the lobe F (lobe_msh.c),
 * then V and its levels (pixel_rgb.c), in the same steps. Pixels without light, and pixels without highlight, leave the
 * rest out. One whose levels V + W does not decide ends the call: C draws it, and calls again. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus_line.inc"

/* The places in the albedo map of the pixel whose normal r0 is behind: \at. */
.macro albedo_at at, spare
    lsrs \at, r0, #1
    ldr \spare, [sp, #OUR_ALBEDO]
    adds \at, \at, \spare
.endm

.macro add_half spare
    movs \spare, #1
    lsls \spare, \spare, #GLINT_LINE_SHIFT - 1
.irp value, x, z, v
    adds \value, \value, \spare
.endr
.endm

.macro base_mapped
    albedo_at y, v
    muls x, nl
    adds z, z, x
    lsrs z, z, #7
    ldrb x, [y]
    muls z, x
    ldmia constants!, {x, v}
    muls x, nl
    adds x, x, v
    lsrs x, x, #7
    ldrb v, [y, #1]
    muls x, v
    ldmia constants!, {v}
    muls v, nl
    ldmia constants!, {nl}
    adds v, v, nl
    lsrs v, v, #7
    ldrb nl, [y, #2]
    muls v, nl
    add_half y
.endm

/* Of \value, held to its largest, a level and 1/2 of it, and of what is below, q: their sum, blended. y: m, nl: 255 - m times
 * 2^(shift - 9). \spare: q. */
.macro blend value, spare
    lsrs \value, \value, #8
    muls \value, y
    muls \spare, nl
    lsls \spare, \spare, #1
    adds \value, \value, \spare
    adds \value, \value, nl
    lsrs \spare, \value, #8
    adds \value, \value, \spare
.endm

/* And its largest where it exceeds that; y: 2^(shift - 1). */
.macro held_half value, bits
    adds nl, \value, y
    lsrs nl, nl, #GLINT_LINE_SHIFT + \bits
    beq 1f
    movs \value, #(2 << \bits) - 1
    lsls \value, \value, #GLINT_LINE_SHIFT - 1
1:
.endm

/* Pixel second of two whose normals are three aligned words, from r0 on, by the table of steps, which is at constants: what is in the lobe, or
 * not in the table, is drawn alone. A word may have a half that lies beside the map. A pixel's step is of N.L before this is rounded. */
.macro pair_pixel name, second
.L\name\()_pair\second:
.if \second
    ldr x, [r0, #4]
    ldr z, [r0, #8]
    adds r0, #12
    asrs x, x, #16
    sxth y, z
    asrs z, z, #16
.else
    ldr x, [r0]
    ldr z, [r0, #4]
    asrs y, x, #16
    sxth x, x
    sxth z, z
.endif
    ldr nl, [sp, #GLINT_AT_LINE_L]
    muls nl, x
    ldr v, [sp, #GLINT_AT_LINE_L + 4]
    muls v, y
    adds nl, nl, v
    ldr v, [sp, #GLINT_AT_LINE_L + 8]
    muls v, z
    adds nl, nl, v
    lsrs v, nl, #30
    bne .L\name\()_beyond\second
.L\name\()_within\second:
    distance .L\name\()_step\second
    cmp x, t_most
    blo .L\name\()_lobe\second
.L\name\()_step\second:
    lsrs v, nl, #14 + GLINT_STEPS_LOG
    lsls v, v, #1
    ldrh y, [constants, v]
    cmp y, #0
    beq .L\name\()_miss\second
.L\name\()_put\second:
    strh y, [r1]
    adds r1, #2
    cmp r1, run_end
.if \second
    bne .L\name\()_pair0
    b .L\name\()_run
.else
    beq .L\name\()_half
.endif
.endm

/* What leaves it. */
.macro pair_rest name
.irp second, 0, 1
.L\name\()_beyond\second: /* N.L < 0, or 1 or more */
    cmp nl, #0
    bmi .L\name\()_unlit\second
    movs nl, #1
    lsls nl, nl, #30
    b .L\name\()_within\second
.L\name\()_unlit\second:
    ldr y, [sp, #GLINT_AT_LINE_DARK]
    b .L\name\()_put\second
.endr
.L\name\()_half:
    adds r0, #6
    b .L\name\()_run
.L\name\()_miss0:
    adds r0, #6
.L\name\()_miss1:
    nl_rounded
    mov constants, sp
    adds constants, #GLINT_AT_LINE_BASE
    b .L\name\()_base
.L\name\()_lobe0:
    adds r0, #6
.L\name\()_lobe1:
    nl_rounded
    beq 1f
    b .L\name\()_inside
1:  b .L\name\()_dark
.endm

/* F of t in x, and V in z, x, v; and what lies beside it. */
.macro lobe name, mapped
    ldr y, [sp, #GLINT_AT_LINE_K + 4 * GLINT_MSH_FACTOR]
    lsrs z, x, #14
    muls z, y
    lsls v, x, #18
    lsrs v, v, #18
    muls v, y
    asrs v, v, #14
    adds z, z, v
    ldr v, [sp, #GLINT_AT_LINE_K + 4 * GLINT_MSH_ADDEND]
    adds z, z, v /* m, as msh_near has it */
    ldr y, [sp, #GLINT_AT_LINE_K + 4 * GLINT_MSH_SHIFT]
    lsrs v, z, #27
    beq .L\name\()_small
.L\name\()_scaled:
    msh_reciprocal constants
    movs constants, #1
    lsls constants, constants, #30
    subs constants, constants, x
    msh_quotient .L\name\()_high, .L\name\()_peak
.L\name\()_sum: /* F in constants */
.if \mapped
    albedo_at y, z
.endif
    channel z, x, 0, \mapped, y
    channel x, v, 1, \mapped, y
    ldr v, [sp, #BASE_NL(2)]
    muls v, nl
    ldr nl, [sp, #BASE_ONE(2)]
    adds v, v, nl
.if \mapped
    lsrs v, v, #7
    ldrb nl, [y, #2]
    muls v, nl
.endif
    ldr nl, [sp, #GLINT_AT_LINE_R + 8]
    muls nl, constants
    adds v, v, nl
.if \mapped
    add_half y
.endif
.endm
.macro lobe_rest name
.L\name\()_small: /* m, until it is 2^27 */
    lsls z, z, #1
    subs y, #2
    lsrs v, z, #27
    beq .L\name\()_small
    b .L\name\()_scaled
.L\name\()_peak:
    ldr v, [sp, #GLINT_AT_LINE_F_MAX]
    cmp constants, v
    bls .L\name\()_sum
    movs constants, v
    b .L\name\()_sum
.endm

/* Where most pixels come from: with steps, behind the lobe. */
.macro put_value name, swapped, soft, steps
.L\name\()_value: /* V in z, x, v */
.if \soft
    b .L\name\()_blend
.else
    levels_held .L\name\()_held
.endif
.L\name\()_levels:
.if \steps
    levels .L\name\()_open
.else
    levels .L\name\()_done
.endif
.if \swapped
    rev16 y, y
.endif
.L\name\()_store:
    strh y, [r1]
    adds r1, #2
.if \soft
    mov r0, run_end
    ldr y, [sp, #OUR_LINE_END]
    cmp r1, y
.else
    cmp r1, run_end
.endif
.if \steps
    beq 1f
    b .L\name\()_alone
1:
.else
    bne .L\name\()_pixel
.endif
    b .L\name\()_run
.endm

/* soft: from a pixel on that is covered in part, up to one that is not. steps: pixels without highlight from a table, where it has them. */
.macro line_rgb565 name, swapped, mapped, soft, steps=0
    function \name
    enter OURS+8*\steps
    line_begin \mapped
.if \steps
    ldmia r2!, {r4}
    str r4, [sp, #OUR_STEPS]
    mov r4, first
    str r4, [sp, #OUR_FIRST]
    ldr r4, [sp, #GLINT_AT_LINE_T_END]
    mov t_most, r4
    b .L\name\()_run
    pair_pixel \name, 0
    pair_pixel \name, 1
    pair_rest \name
.L\name\()_pixel: /* by two, from the first or the second on */
    ldr constants, [sp, #OUR_STEPS]
    lsls y, r0, #30
    bne 1f
    b .L\name\()_pair0
1:  subs r0, #6
    b .L\name\()_pair1
.endif
.if \soft
    ldr r7, .L\name\()_more
    mov r6, limit
    subs r6, r6, r7
    mov limit, r6
.L\name\()_run:
    ldr y, [sp, #OUR_LINE_END]
    cmp r1, y
    bne .L\name\()_pixel
    line_done \name, OURS
.else
    line_runs \name, OURS+8*\steps, \steps
.endif

.L\name\()_dark:
.if \mapped || \soft
    movs nl, #0
    b .L\name\()_far
.else
    ldr y, [sp, #GLINT_AT_LINE_DARK]
.if \steps
    b .L\name\()_stored
.else
    b .L\name\()_store
.endif
.endif

.L\name\()_far: /* t exceeds 32 bits */
.if !\steps
    ldmia constants!, {y}
.endif
    b .L\name\()_plain

.if \steps
.L\name\()_stored: /* as the last of _pair0 and _pair1 */
    strh y, [r1]
    adds r1, #2
    cmp r1, run_end
    bne .L\name\()_pixel
    b .L\name\()_run
.L\name\()_alone:
.else
.L\name\()_pixel:
.endif
.if \soft
    ldr v, [sp, #OUR_MASK_AT]
    lsrs x, r1, #1
    ldrb x, [x, v]
    subs x, #1
    cmp x, #254
    bhs .L\name\()_done
.endif
    normal
    ble .L\name\()_dark
    lsrs v, nl, #16
    bne .L\name\()_bright
.L\name\()_lit:
    distance .L\name\()_far
.if \steps
    cmp x, t_most
.else
    ldmia constants!, {y}
    cmp x, y
.endif
    blo .L\name\()_inside
.L\name\()_plain:
.if \steps
    adds constants, #4
    lsrs x, nl, #GLINT_STEPS_LOG
    lsls x, x, #1
    ldr z, [sp, #OUR_STEPS]
    ldrh y, [z, x]
    cmp y, #0
    bne .L\name\()_stored
.L\name\()_base:
.endif
    ldmia constants!, {x, z}
.if \mapped
    base_mapped
.else
    base_plain
.endif
.if \steps
    b .L\name\()_value
.else
    put_value \name, \swapped, \soft, \steps
.endif

.L\name\()_bright:
    movs nl, #1
    lsls nl, nl, #16
    b .L\name\()_lit

.if !\soft
.L\name\()_held:
    held_all
    b .L\name\()_levels
.endif

    lobe_rest \name

.L\name\()_first:
.if \steps
    str r1, [sp, #OUR_FIRST]
.L\name\()_inside:
    ldr v, [sp, #OUR_FIRST]
    cmp v, r1
.else
    mov first, r1
.L\name\()_inside:
    cmp first, r1
.endif
    bhi .L\name\()_first
    str r1, [sp, #OUR_LAST]
    lsrs x, x, #1
    lobe \name, \mapped
.if \steps
    put_value \name, \swapped, \soft, \steps
.L\name\()_open:
    b .L\name\()_done
.else
    b .L\name\()_value
.endif
.if \soft
.L\name\()_blend: /* over what is there. r0 is kept where the run's end is not needed */
    movs y, #1
    lsls y, y, #GLINT_LINE_SHIFT - 1
    mov run_end, r0
    adds nl, z, y
    adds r0, v, y
    orrs nl, r0
    adds r0, x, y
    lsrs r0, r0, #1
    orrs nl, r0
    lsrs nl, nl, #GLINT_LINE_SHIFT + 5
    bne .L\name\()_most
.L\name\()_over:
    ldr r2, [sp, #OUR_MASK_AT]
    lsrs y, r1, #1
    ldrb y, [y, r2]
    movs nl, #255
    subs nl, nl, y
    lsls nl, nl, #GLINT_LINE_SHIFT - 9
    ldrh r2, [r1]
.if \swapped
    rev16 r2, r2
.endif
    lsrs r0, r2, #11
    blend z, r0
    lsls r0, r2, #21
    lsrs r0, r0, #26
    blend x, r0
    lsls r0, r2, #27
    lsrs r0, r0, #27
    blend v, r0
    b .L\name\()_levels
.L\name\()_most:
    held_half z, 5
    held_half x, 6
    held_half v, 5
    b .L\name\()_over
.endif
    .balign 4
.if \soft
.L\name\()_more: /* what W grows by: 256 and 3, and 2^-16 of the largest level, which is blend's */
    .word (259 + (64 << (GLINT_LINE_SHIFT - 16))) << LEVEL_BITS
.endif
.L\name\()_high:
    .word GLINT_MSH_HIGH
.endm

    line_rgb565 glint_line_rgb565, 0, 0, 0
    line_rgb565 glint_line_rgb565_swapped, 1, 0, 0
    line_rgb565 glint_line_rgb565_albedo, 0, 1, 0
    line_rgb565 glint_line_rgb565_albedo_swapped, 1, 1, 0
    line_rgb565 glint_line_rgb565_soft, 0, 0, 1
    line_rgb565 glint_line_rgb565_soft_swapped, 1, 0, 1
    line_rgb565 glint_line_rgb565_steps, 0, 0, 0, 1
    line_rgb565 glint_line_rgb565_steps_swapped, 1, 0, 0, 1

/* ---- Of a span, from its pixel x on: as sample.c walks it ---- */

#define t r0 /* and 2^GLINT_NEGATIVE_T_LOG: what is a little below 0 comes before all else */
#define nl_q30 minus_hx
#define dt minus_hy
#define ddt minus_hz
#define dnl first
#define OUR_TURN OUR_MASK

    function glint_line_rgb565_span
    enter OURS+8
    line_begin 0
    ldmia r2!, {r3-r5} /* steps, span, turn */
    str r3, [sp, #OUR_STEPS]
    str r5, [sp, #OUR_TURN]
    mov r3, first
    str r3, [sp, #OUR_FIRST]
    ldmia r4!, {r0, r2, r3, r5, r6}
    mov dt, r2
    mov ddt, r3
    mov nl_q30, r5
    mov dnl, r6
    movs r3, #1
    lsls r3, r3, #GLINT_NEGATIVE_T_LOG
    adds t, t, r3
    ldr r2, [sp, #GLINT_AT_LINE_T_END]
    lsrs r2, r2, #1
    adds r2, r2, r3
    str r2, [sp, #GLINT_AT_LINE_T_END]
    ldr r3, [sp, #OUR_LINE_END]
    mov run_end, r3
    cmp r1, r3
    bne .Lspan_pixel
    line_done span, OURS+8, 1

.Lspan_dark:
    movs nl, #0
    b .Lspan_plain
.Lspan_bright:
    movs nl, #1
    lsls nl, nl, #16
    b .Lspan_lit
.Lspan_pixel:
    mov nl, nl_q30
    add nl_q30, dnl
    movs x, t
    add t, dt
    add dt, ddt
    nl_rounded
    ble .Lspan_dark
    lsrs v, nl, #16
    bne .Lspan_bright
.Lspan_lit:
    ldr y, [sp, #GLINT_AT_LINE_T_END]
    cmp x, y
    blo .Lspan_inside
.Lspan_plain:
    ldr z, [sp, #OUR_STEPS]
    cmp z, #0
    beq 1f
    lsrs y, nl, #GLINT_STEPS_LOG
    lsls y, y, #1
    ldrh y, [z, y]
    cmp y, #0
    bne .Lspan_store
1:  mov constants, sp
    adds constants, #GLINT_AT_LINE_BASE
    ldmia constants!, {x, z}
    base_plain
.Lspan_value:
    levels_held .Lspan_held
.Lspan_levels:
    levels .Lspan_done
    ldr v, [sp, #OUR_TURN]
    lsls x, y, #16
    orrs y, x
    rors y, v
.Lspan_store:
    strh y, [r1]
    adds r1, #2
    cmp r1, run_end
    bne .Lspan_pixel
    b .Lspan_done

.Lspan_held:
    held_all
    b .Lspan_levels

    lobe_rest span

.Lspan_below:
    movs x, #0
    b .Lspan_above
.Lspan_inside:
    movs v, #1
    lsls v, v, #GLINT_NEGATIVE_T_LOG
    subs x, x, v
    blo .Lspan_below
.Lspan_above:
    ldr v, [sp, #OUR_FIRST]
    cmp v, r1
    bhi .Lspan_first_lit
.Lspan_last:
    str r1, [sp, #OUR_LAST]
    lobe span, 0
    b .Lspan_value
.Lspan_first_lit:
    str r1, [sp, #OUR_FIRST]
    b .Lspan_last
    .balign 4
.Lspan_high:
    .word GLINT_MSH_HIGH
#endif
