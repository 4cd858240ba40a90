/* SPDX-License-Identifier: MIT
 * glint_line_rgb565(loop, x), _swapped, _albedo, _albedo_swapped: the exact line of RGB565 under MSH, from pixel x on; _soft, _soft_swapped:
 * pixels of it that are covered in part, blended as coverage.c does, side by side.
 *
 * The stages of an exact run in one loop: t and N.L from the normal (sample.c), where t is within the lobe F (lobe_msh.c),
 * then V and its levels (pixel_rgb.c), in the same steps. Pixels without light, and pixels without highlight, leave the
 * rest out. One whose levels V + W does not decide ends the call: C draws it, and calls again. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"
#include "glint_lobe.h"
#include "glint_offsets.h"

/* normals past the pixel in r0, its place in out in r1; constants in r2, in their order */
#define constants r2
#define x r3
#define y r4
#define z r5
#define nl r6
#define v r7
#define minus_hx r8
#define minus_hy r9
#define minus_hz r10
#define first r11 /* lit pixel, in out */
#define limit r12
#define run_end lr /* of out */

/* Ours, from sp, behind what is copied. */
#define OUR_ALBEDO GLINT_AT_LINE_DARK /* the pixel's albedo is at this and half the normal's place; a map has no dark pixel */
#define OUR_LOOP (GLINT_AT_LINE_COPIED)
#define OUR_LAST (GLINT_AT_LINE_COPIED + 4) /* lit pixel, in out */
#define OUR_LINE_END (GLINT_AT_LINE_COPIED + 8)
#define OUR_MASK (GLINT_AT_LINE_COPIED + 12)
#define OUR_MASK_AT (GLINT_AT_LINE_COPIED + 16) /* the pixel's mask is at this and half the pixel's place */
#define OURS 96

#define BASE_NL(k) (GLINT_AT_LINE_BASE + 8 * (k))
#define BASE_ONE(k) (GLINT_AT_LINE_BASE + 8 * (k) + 4)
#define LEVEL_BITS (32 - GLINT_LINE_SHIFT) /* of V, above a level's fraction */

/* The next normal in x, y, z; nl and the flags of it, not held to 65536 yet. */
.macro normal
    mov constants, sp
    ldrh x, [r0]
    ldrh y, [r0, #2]
    ldrh z, [r0, #4]
    adds r0, #6
    sxth x, x
    sxth y, y
    sxth z, z
    ldmia constants!, {nl, v}
    muls nl, x
    muls v, y
    adds nl, nl, v
    ldmia constants!, {v}
    muls v, z
    adds nl, nl, v
    asrs nl, nl, #13
    adds nl, #1
    asrs nl, nl, #1
.endm

/* 2t in x; to \far where it exceeds 32 bits. */
.macro distance far
    add x, minus_hx
    add y, minus_hy
    add z, minus_hz
.irp difference, x, y, z
    muls \difference, \difference
.endr
    adds x, x, y
    bcs \far
    adds x, x, z
    bcs \far
.endm

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

/* V without highlight in z, x, v. constants: in their order from base[0] on, but where x and z hold its words. */
.macro base_plain
    muls x, nl
    adds z, z, x
    ldmia constants!, {x, y, v}
    muls x, nl
    adds x, x, y
    muls v, nl
    ldmia constants!, {y}
    adds v, v, y
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

/* A channel of V with F in constants; at is the place of its albedo. */
.macro channel value, spare, k, mapped, at
    ldr \value, [sp, #BASE_NL(\k)]
    muls \value, nl
    ldr \spare, [sp, #BASE_ONE(\k)]
    adds \value, \value, \spare
.if \mapped
    lsrs \value, \value, #7
    ldrb \spare, [\at, #\k]
    muls \value, \spare
.endif
    ldr \spare, [sp, #GLINT_AT_LINE_R + 4 * \k]
    muls \spare, constants
    adds \value, \value, \spare
.endm

/* F in constants, from 2t in x; all but nl and the places are changed. msh_near and msh_quotient, step by step. */
.macro msh name
    lsrs x, x, #1
    ldr y, [sp, #GLINT_AT_LINE_K + 4 * GLINT_MSH_FACTOR]
    lsrs z, x, #14
    muls z, y
    lsls v, x, #18
    lsrs v, v, #18
    muls v, y
    asrs v, v, #14
    adds z, z, v
    ldr v, [sp, #GLINT_AT_LINE_K + 4 * GLINT_MSH_ADDEND]
    adds z, z, v /* m */
    ldr y, [sp, #GLINT_AT_LINE_K + 4 * GLINT_MSH_SHIFT]
    lsrs v, z, #27
    beq .L\name\()_small
.L\name\()_scaled:
    lsrs v, z, #21
    subs v, #64
    ldr constants, [sp, #GLINT_AT_LINE_RECIPROCALS]
    ldrb v, [constants, v] /* y */
    movs constants, #1
    lsls constants, constants, #30
    subs constants, constants, x
    lsrs constants, constants, #6 /* u */
    muls constants, v
    lsrs constants, constants, #8
    muls constants, v /* b */
    muls z, v
    asrs z, z, #14 /* r */
    movs v, z
    muls v, z
    asrs v, v, #19
    lsls x, z, #1
    adds x, x, z
    subs x, x, v
    muls x, z
    asrs x, x, #22
    subs x, x, z /* p */
    lsrs v, constants, #16
    muls v, x
    asrs v, v, #4
    adds constants, constants, v /* x */
    lsrs v, constants, #2
    lsrs constants, constants, #3
    adds constants, constants, v
.irp bits, 4, 8, 16
    lsrs v, constants, #\bits
    adds constants, constants, v
.endr /* q */
    ldr v, .L\name\()_high
    subs constants, constants, v
    asrs constants, y /* and half of the last bit */
    adds constants, #1
    lsrs constants, constants, #1
    lsrs v, constants, #16
    bne .L\name\()_peak
.endm

/* A level that exceeds its largest in \value. */
.macro held value, bits
    lsrs y, \value, #GLINT_LINE_SHIFT + \bits
    beq 1f
    movs \value, #(1 << \bits) - 1
    lsls \value, \value, #GLINT_LINE_SHIFT
1:
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

/* soft: from a pixel on that is covered in part, up to one that is not. */
.macro line_rgb565 name, swapped, mapped, soft
    function \name
    enter OURS
    movs r2, r0
    mov r3, sp
.rept 3
    ldmia r2!, {r4-r7}
    stmia r3!, {r4-r7}
.endr
    ldmia r2!, {r4-r7}
    stmia r3!, {r4-r7}
    ldmia r2!, {r4-r6}
    stmia r3!, {r4-r6}
    stmia r3!, {r0} /* OUR_LOOP */
    ldmia r2!, {r3-r6}
    mov minus_hx, r3
    mov minus_hy, r4
    mov minus_hz, r5
.if \soft
    ldr r7, .L\name\()_more
    subs r6, r6, r7
.endif
    mov limit, r6
    ldmia r2!, {r3-r7} /* out, w, mask, normals, albedo */
.if \mapped
    lsrs r0, r6, #1
    subs r7, r7, r0
    subs r7, #3
    str r7, [sp, #OUR_ALBEDO]
.endif
    lsrs r0, r3, #1
    subs r0, r5, r0
    str r0, [sp, #OUR_MASK_AT]
    str r5, [sp, #OUR_MASK]
    lsls r4, r4, #1
    adds r4, r4, r3
    str r4, [sp, #OUR_LINE_END]
    lsls r1, r1, #1
    adds r0, r6, r1
    adds r0, r0, r1
    adds r0, r0, r1
    adds r1, r1, r3
    ldmia r2!, {r4, r5}
    mov first, r4
    str r5, [sp, #OUR_LAST]

.L\name\()_run: /* x and y: where in the mask, and its end */
    ldr y, [sp, #OUR_LINE_END]
    mov run_end, y
    cmp r1, y
    beq .L\name\()_done
.if \soft
    b .L\name\()_pixel
.else
    ldr x, [sp, #OUR_MASK]
    cmp x, #0
    beq .L\name\()_pixel
    ldr v, [sp, #OUR_MASK_AT]
    lsrs x, r1, #1
    adds x, x, v
    lsrs y, y, #1
    adds y, y, v
1:  lsls z, x, #30
    bne 3f
2:  adds z, x, #4
    cmp z, y
    bhi 3f
    ldr nl, [x]
    cmp nl, #0
    bne 3f
    movs x, z
    b 2b
3:  cmp x, y
    beq .L\name\()_masked
    ldrb nl, [x]
    cmp nl, #255
    beq 4f
    cmp nl, #0
    bne .L\name\()_edge
    adds x, #1
    b 1b
4:  subs z, x, v
    lsls z, z, #1
    subs nl, z, r1
    movs r1, z
    adds r0, r0, nl
    adds r0, r0, nl
    adds r0, r0, nl
5:  lsls z, x, #30
    bne 7f
6:  adds z, x, #4
    cmp z, y
    bhi 7f
    ldr nl, [x]
    adds nl, #1
    bne 7f
    movs x, z
    b 6b
7:  cmp x, y
    beq 8f
    ldrb nl, [x]
    cmp nl, #255
    bne 8f
    adds x, #1
    b 5b
8:  subs x, x, v
    lsls x, x, #1
    mov run_end, x
    b .L\name\()_pixel
.endif

.if !\soft
.L\name\()_edge: /* for another to blend */
    subs x, x, v
    lsls r1, x, #1
    b .L\name\()_done
.L\name\()_masked:
    ldr r1, [sp, #OUR_LINE_END]
.endif
.L\name\()_done: /* or a pixel is open */
    ldr r2, [sp, #OUR_LOOP]
    adds r2, #GLINT_AT_LINE_OUT
    ldr r0, [r2]
    subs r0, r1, r0
    lsrs r0, r0, #1
    mov r4, first
    ldr r5, [sp, #OUR_LAST]
    str r4, [r2, #GLINT_AT_LINE_LIT - GLINT_AT_LINE_OUT]
    str r5, [r2, #GLINT_AT_LINE_LIT + 4 - GLINT_AT_LINE_OUT]
    leave OURS

.L\name\()_dark:
.if \mapped || \soft
    movs nl, #0
    b .L\name\()_far
.else
    ldr y, [sp, #GLINT_AT_LINE_DARK]
    b .L\name\()_store
.endif

.L\name\()_far: /* t exceeds 32 bits */
    ldmia constants!, {y}
    b .L\name\()_plain

.L\name\()_pixel:
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
    ldmia constants!, {y}
    cmp x, y
    blo .L\name\()_inside
.L\name\()_plain:
    ldmia constants!, {x, z}
.if \mapped
    base_mapped
.else
    base_plain
.endif
.L\name\()_value: /* V in z, x, v */
.if \soft
    b .L\name\()_blend
.else
    movs y, z
    orrs y, v
    lsrs nl, x, #1
    orrs y, nl
    lsrs y, y, #GLINT_LINE_SHIFT + 5
    bne .L\name\()_held
.endif
.L\name\()_levels:
    lsls y, z, #LEVEL_BITS
    cmp y, limit
    bhs .L\name\()_done
    lsls y, x, #LEVEL_BITS
    cmp y, limit
    bhs .L\name\()_done
    lsls y, v, #LEVEL_BITS
    cmp y, limit
    bhs .L\name\()_done
    lsrs y, z, #GLINT_LINE_SHIFT
    lsls y, y, #6
    lsrs x, x, #GLINT_LINE_SHIFT
    adds y, y, x
    lsls y, y, #5
    lsrs v, v, #GLINT_LINE_SHIFT
    adds y, y, v
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
    bne .L\name\()_pixel
    b .L\name\()_run

.L\name\()_bright:
    movs nl, #1
    lsls nl, nl, #16
    b .L\name\()_lit

.if !\soft
.L\name\()_held:
    held z, 5
    held x, 6
    held v, 5
    b .L\name\()_levels
.endif

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

.L\name\()_first:
    mov first, r1
.L\name\()_inside:
    cmp first, r1
    bhi .L\name\()_first
    str r1, [sp, #OUR_LAST]
    msh \name
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
    b .L\name\()_value
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
#endif
