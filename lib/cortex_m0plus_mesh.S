/* SPDX-License-Identifier: MIT
 * glint_mesh_colour(tables, triangle, target), as fused_mesh.c has it, part by part; a strip calls the routine in it by itself. A line's columns and first values, then its
 * pixels, then the steps to the next line: three times, for dark, matt and glossy triangles; a glossy one's line that misses the highlight
 * is drawn as a matt one. Pixels keep all they need in registers; lines take it from the frame and the triangle, but where a triangle is
 * dark or matt its edges stay in registers, too. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus_mesh.inc"

#define COLOUR_FRAME (GLINT_MESH_LINES_BYTES + 4)

    function glint_mesh_colour
    enter COLOUR_FRAME
    movs r4, r1
    movs r1, r2
    mov r2, sp
    bl glint_mesh_colour_begin
    movs r0, r4
    bl colour_lines
    leave COLOUR_FRAME

    function glint_mesh_colour_begin
    push {r4, lr}
    ldr r3, =colour_lines
    str r3, [r2, #GLINT_AT_LINES_DRAW]
    bl glint_mesh_colour_set
    pop {r4, pc}
    .ltorg

/* The triangle in r0; sp: to the struct glint_mesh_lines. Registers are lost. */
    .section .text.colour_lines, "ax", %progbits
    .type colour_lines, %function
    .balign 4
    .thumb_func
colour_lines:
    push {lr}
    sub sp, #LINES_FRAME
    str r0, [sp, #TRIANGLE]
    adds r0, #GLINT_AT_TRIANGLE_Y
    ldmia r0!, {r3, r4} /* y, y_middle; y_end, shine, long_is_left */
    sxth r2, r3
    sxth r5, r4
    ldr r6, [sp, #END]
    cmp r5, r6
    ble 1f
    movs r5, r6
1:  cmp r2, r5
    bge .Ldone
    subs r0, #8
    strh r5, [r0]
    lsrs r4, r4, #16
    str r4, [sp, #SIDES]
    asrs r3, r3, #16
    cmp r3, r5
    ble 1f
    movs r3, r5
1:  add r7, sp, #OFF_FIRST
    ldmia r7!, {r0, r1}
    ldr r6, [r7, #OFF_STEP - OFF]
    muls r6, r2
    adds r0, r0, r6
    ldr r6, [r7, #DEPTH_STEP - OFF]
    muls r5, r6
    adds r5, r5, r1
    str r5, [sp, #TRIANGLE_LAST]
    movs r4, r6
    muls r4, r2
    muls r6, r3
    adds r6, r6, r1
    adds r1, r1, r4
    stmia r7!, {r0, r1} /* off, depth */
    ldr r0, [sp, #TRIANGLE]
    adds r0, #GLINT_AT_TRIANGLE_LONG
    movs r1, r0
    adds r1, #8 /* the upper edge */
    cmp r2, r3
    blt .Lpart
    movs r6, r5
.Llower:
    adds r1, #8
.Lpart: /* r0: the long edge, r1: the other; r6: the last line */
    str r6, [sp, #LAST]
    ldr r4, [sp, #SIDES]
    lsrs r5, r4, #8
    bne 1f
    movs r5, r0
    movs r0, r1
    movs r1, r5
1:  str r0, [sp, #LEFT_AT]
    str r1, [sp, #RIGHT_AT]
    lsls r6, r4, #24
    ldmia r0!, {r2, r4}
    ldmia r1!, {r3, r5}
    beq .Ldark
    lsrs r6, r6, #24 + 1
    beq .Lmatt
    b .Lglossy
.Ledges:
    ldr r2, [sp, #LEFT_AT]
    str r0, [r2]
    ldr r2, [sp, #RIGHT_AT]
    str r1, [r2]
    ldr r2, [sp, #DEPTH]
    ldr r6, [sp, #TRIANGLE_LAST]
    ldr r0, [sp, #TRIANGLE]
    adds r0, #GLINT_AT_TRIANGLE_LONG
    movs r1, r0
    adds r1, #8
    cmp r2, r6
    bne .Llower
.Ldone:
    add sp, #LINES_FRAME
    pop {pc}

.Ldark: /* r3: dark, r4: off, r7: dz */
    plain_part DARK
.Ldark_line:
    plain_begin .Ldark_hold, 4f
    ldr z, [r6, #GLINT_AT_TRIANGLE_Z]
    muls r5, r7
    adds z, z, r5
2:  in_front 3f
    strh r3, [depth, r4]
3:  adds depth, #2
    adds z, z, r7
    cmp depth, end
    blo 2b
4:  ldr r6, [sp, #TRIANGLE]
    ldr r0, [r6, #GLINT_AT_TRIANGLE_Z]
    ldr r1, [r6, #GLINT_AT_TRIANGLE_ZY]
    adds r0, r0, r1
    str r0, [r6, #GLINT_AT_TRIANGLE_Z]
    plain_end .Ldark_line
.Ldark_hold:
    hold r5, r1, r0, .Ldark_hold_held, 4b

.Lmatt: /* r3: colours, r4: off, r7: dz */
    plain_part COLOURS
    ldr r5, [r6, #GLINT_AT_TRIANGLE_NLX]
    mov dnl, r5
.Lmatt_line:
    plain_begin .Lmatt_hold, .Lmatt_end
    ldmia r6!, {r1, r2} /* z, nl */
    mov r6, dnl
    muls r6, r5
    adds nl, nl, r6
    muls r5, r7
    adds z, z, r5
    matt_pixels .Lmatt_dark
.Lmatt_end:
    ldr r6, [sp, #TRIANGLE]
    ldmia r6!, {r0, r1}
    ldr r2, [r6, #GLINT_AT_TRIANGLE_ZY - 8]
    adds r0, r0, r2
    ldr r2, [r6, #GLINT_AT_TRIANGLE_NLY - 8]
    adds r1, r1, r2
    subs r6, #8
    stmia r6!, {r0, r1}
    plain_end .Lmatt_line
    matt_dark .Lmatt_dark
.Lmatt_hold:
    hold r5, r1, r0, .Lmatt_hold_held, .Lmatt_end

.Lglossy_hold:
    hold r2, r3, r6, .Lglossy_held, .Lglossy_end

.Lglossy:
    mov r6, sp
    stmia r6!, {r2-r5}
    ldr r0, [sp, #COLUMNS]
    mov columns, r0
    ldr r0, [sp, #T_MAX]
    mov t_max, r0
    ldr r7, [sp, #TRIANGLE]
    ldr r0, [r7, #GLINT_AT_TRIANGLE_ZX]
    mov dz, r0
    ldr r0, [r7, #GLINT_AT_TRIANGLE_NLX]
    mov dnl, r0
    ldr r0, [r7, #GLINT_AT_TRIANGLE_TXX]
    mov ddt, r0
    asrs r1, r0, #31
    eors r0, r1
    movs r1, #31
    lsrs r0, r0, #26
    beq 1f
    movs r1, #0
1:  str r1, [sp, #LONGEST]
.Lglossy_line:
    mov r7, sp
    ldmia r7!, {r0, r1, r4, r5}
    asrs r2, r0, #16
    asrs r3, r1, #16
    adds r0, r0, r4
    adds r1, r1, r5
    subs r7, #16
    stmia r7!, {r0, r1}
    subs r6, r3, r2
    ble .Lglossy_end
    ldr r4, [sp, #W]
    subs r4, r4, r3
    orrs r4, r2
    bmi .Lglossy_hold
.Lglossy_held:
    ldr depth, [sp, #DEPTH]
    lsls r4, r2, #1
    adds depth, depth, r4
    lsls r3, r6, #1
    adds r3, r3, depth
    mov end, r3
    ldr r7, [sp, #TRIANGLE]
    ldr r1, [r7, #GLINT_AT_TRIANGLE_X]
    subs r5, r2, r1 /* k, from the triangle's column */
    ldmia r7!, {r1-r4} /* z, nl, t, tx */
    mov r7, dz
    muls r7, r5
    adds z, z, r7
    mov r7, dnl
    muls r7, r5
    adds nl, nl, r7
    movs r7, r4
    muls r7, r5
    adds r3, r3, r7
    mov r7, ddt
    muls r7, r5
    adds dt, dt, r7
    subs r7, r5, #1
    muls r7, r5
    asrs r7, r7, #1
    mov r5, ddt
    muls r7, r5
    adds r3, r3, r7
    mov r7, t_max
    subs back, r7, r3
    bmi .Lmay_miss
.Lhits:
    ldr r7, [sp, #SHIFT]
1:  in_front 4f
    asrs r5, nl, #GLINT_COLOUR_ROW_SHIFT
    bmi 5f
    lsls r5, r5, #GLINT_COLOUR_ROW_BYTES_LOG
    movs r6, back
    cmp back, t_max
    bhi 6f
2:  lsrs r6, r7
    add r6, columns
    ldrb r6, [r6]
    adds r5, r5, r6
3:  ldr r6, [sp, #COLOURS]
    ldrh r5, [r6, r5]
    ldr r6, [sp, #OFF]
    strh r5, [depth, r6]
4:  adds depth, #2
    add z, dz
    add nl, dnl
    subs back, back, dt
    add dt, ddt
    cmp depth, end
    blo 1b
.Lglossy_end:
    ldr r6, [sp, #TRIANGLE]
    ldmia r6!, {r0-r4} /* z, nl, t, tx, ty */
    adds r2, r2, r4
    ldmia r6!, {r5, r7} /* zy, nly */
    adds r0, r0, r5
    adds r1, r1, r7
    ldmia r6!, {r5, r7} /* txy, tyy */
    adds r3, r3, r5
    adds r4, r4, r7
    subs r6, #36
    stmia r6!, {r0-r4}
    add r6, sp, #OFF
    ldmia r6!, {r0-r4} /* and last */
    adds r0, r0, r3
    adds r1, r1, r2
    subs r6, #20
    stmia r6!, {r0, r1}
    cmp r1, r4
    bne .Lglossy_line
    ldr r0, [sp, #LEFT]
    ldr r1, [sp, #RIGHT]
    b .Ledges
5:  ldr r5, [sp, #DARK]
    ldr r6, [sp, #OFF]
    strh r5, [depth, r6]
    b 4b
6:  ldr r6, [sp, #LIMIT] /* t is over t_max, or a little below 0 */
    cmp back, r6
    bhi 3b
    mov r6, t_max
    b 2b

/* back is below 0 at the line's first pixel: t is past t_max, and not below 0, since LIMIT < 2^31. So it is at the m pixels behind it if it is
 * at the last one and t only grows or only falls: if its first step and that after the last pixel have one sign. r5: ddt, r6: m + 1.
 * With m < 32 and |ddt| <= 2^26 the latter is exact; with both below 2^26 t changes by less than 2^31, so that no sign is wrong. */
.Lmay_miss:
    subs r6, #1
    ldr r7, [sp, #LONGEST]
    cmp r6, r7
    bhi .Lhits
    subs r7, r6, #1
    muls r7, r6
    asrs r7, r7, #1
    muls r7, r5
    muls r5, r6
    adds r5, r5, dt
    muls r6, r4
    adds r7, r7, r6
    subs r7, back, r7
    bpl .Lhits
    asrs r6, dt, #31
    eors r5, r6
    eors r6, dt
    orrs r5, r6
    lsrs r5, r5, #26
    bne .Lhits
    ldr r3, [sp, #COLOURS]
    ldr r4, [sp, #OFF]
    mov r7, dz
    matt_pixels .Lmiss_dark
    b .Lglossy_end
    matt_dark .Lmiss_dark
#endif
