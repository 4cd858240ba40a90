/* SPDX-License-Identifier: MIT
 * glint_line_rgb565(loop, x), _swapped, _albedo, _albedo_swapped: the exact line of RGB565 under MSH, from pixel x on.
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

.macro line_rgb565 name, swapped, mapped
    function \name
    enter OURS
    line_begin \mapped
    line_runs \name, OURS

.L\name\()_dark:
.if \mapped
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
    levels_held .L\name\()_held
.L\name\()_levels:
    levels .L\name\()_done
.if \swapped
    rev16 y, y
.endif
.L\name\()_store:
    strh y, [r1]
    adds r1, #2
    cmp r1, run_end
    bne .L\name\()_pixel
    b .L\name\()_run

.L\name\()_bright:
    movs nl, #1
    lsls nl, nl, #16
    b .L\name\()_lit

.L\name\()_held:
    held_all
    b .L\name\()_levels

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
    b .L\name\()_value
    .balign 4
.L\name\()_high:
    .word GLINT_MSH_HIGH
.endm

    line_rgb565 glint_line_rgb565, 0, 0
    line_rgb565 glint_line_rgb565_swapped, 1, 0
    line_rgb565 glint_line_rgb565_albedo, 0, 1
    line_rgb565 glint_line_rgb565_albedo_swapped, 1, 1
#endif
