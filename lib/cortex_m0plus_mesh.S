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
    triangle_parts
    beq .Ldark
    lsrs r6, r6, #24 + 1
    beq .Lmatt
    b .Lglossy
    triangle_edges

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
    plain_values_next
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
    longest_of
.Lglossy_line:
    edges_begin .Lglossy_hold, .Lglossy_end
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
    values_next
    next_line .Lglossy_line
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

.Lmay_miss: /* r5: ddt, r6: the pixels */
    misses .Lhits
    ldr r3, [sp, #COLOURS]
    ldr r4, [sp, #OFF]
    mov r7, dz
    matt_pixels .Lmiss_dark
    b .Lglossy_end
    matt_dark .Lmiss_dark
#endif
