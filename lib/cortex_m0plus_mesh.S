/* SPDX-License-Identifier: MIT
 * glint_mesh_colour(tables, triangle, target), as fused_mesh.c has it; a strip calls the routine in it by itself. Dark, matt and glossy
 * triangles have loops of their own, and so have pixels of glossy ones in the highlight and past it. z, nl, t and the step of t stay in registers from
 * line to line, at the column behind the last pixel: they go a line down and some columns aside. The triangle is written only where it
 * goes on in the next strip. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

/* The frame: a triangle's part; behind it and the return address the struct glint_mesh_lines of who calls the routine, which holds what is
 * the same for all triangles of a strip. */
#define LEFT 0 /* glossy: edges, and their steps */
#define LEFT_STEP 4
#define RIGHT 8
#define RIGHT_STEP 12
#define STEPS 0 /* dark and matt: zy, nly, and the edges' steps */
#define DOWN 16 /* glossy: ty in column 0, tyy, zy, nly; the values' column, txy */
#define COLUMN 32
#define TRIANGLE 40
#define SIDES 44 /* shine; 256 where the long edge is the left one, 65536 where it goes on */
#define TRIANGLE_LAST 48 /* depths after the triangle's last line here */
#define LINES_FRAME 52
#define LINES (LINES_FRAME + 4)
#define OUT_FIRST (LINES + 4) /* of line 0 of the picture */
#define DEPTH_FIRST (LINES + 8)
#define PLAIN (LINES + 12) /* w; dark and matt: the values' column; steps of depths and of pixels; depths after the part's last line */
#define COLUMN_NOW (LINES + 16)
#define DEPTH_STEP (LINES + 20)
#define OUT_STEP (LINES + 24)
#define LAST (LINES + 28)
#define COLOURS (LINES + GLINT_AT_LINES_COLOURS)
#define DARK (COLOURS + 4)
#define SHIFT (COLOURS + 8)
#define W PLAIN
#define END (COLOURS + 20)
#define COLUMNS (COLOURS + 24)
#define T_MAX (COLOURS + 28)

/* pixel: counts up to 0, 2 a pixel. depth and out: behind the line's last one. colours: all of them, or the dark one. */
#define pixel r0
#define z r1
#define nl r2
#define colours r3
#define t r3
#define depth r4
#define out r7
#define dz r12
#define dnl lr
/* Of a dark or matt triangle: edges, and where a line begins. */
#define left r8
#define right r9
#define depths r10
#define outs r11
/* Of a glossy one. */
#define dt r8
#define ddt r9
#define t_max r10
#define columns r11

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

/* Columns from..to - 1, in r5 and r6, are held to 0..w; r0: less how many they are. */
.macro hold held, skip
    cmp r5, #0
    bge 1f
    movs r5, #0
1:  ldr r0, [sp, #W]
    cmp r6, r0
    ble 1f
    movs r6, r0
1:  subs r0, r5, r6
    bmi \held
    b \skip
.endm

/* r5, r6: columns from..to - 1, r0: w; then less how many they are. */
.macro held hold, skip
    subs r0, r0, r6
    orrs r0, r5
    bmi \hold
    subs r0, r5, r6
    bpl \skip
.endm

/* value: so many columns on as r5 says; r6 is lost. */
.macro aside value, step
    mov r6, \step
    muls r6, r5
    adds \value, \value, r6
.endm

/* The same of t and dt; r5 is lost. */
.macro t_aside
    aside t, dt
    mov r6, ddt
    muls r6, r5
    add dt, r6
    subs r6, r5, #1
    muls r5, r6
    asrs r5, r5, #1
    mov r6, ddt
    muls r5, r6
    adds t, t, r5
.endm

/* Is the pixel behind? Else its depth is entered. */
.macro in_front behind
    lsrs r5, z, #16
    ldrh r6, [depth, pixel]
    cmp r5, r6
    bhs \behind
    strh r5, [depth, pixel]
.endm

/* A dark or a matt triangle: r0, r5: the left edge and its step, r2, r6: the right one. */
.macro plain name, constant, is_matt
    mov left, r0
    mov right, r2
    ldr r7, [sp, #TRIANGLE]
    ldr r3, [r7, #GLINT_AT_TRIANGLE_ZY]
    .if \is_matt
    ldr r4, [r7, #GLINT_AT_TRIANGLE_NLY]
    .endif
    add r0, sp, #STEPS
    stmia r0!, {r3-r6}
    ldmia r7!, {z, nl}
    ldr r3, [r7, #GLINT_AT_TRIANGLE_ZX - 8]
    mov dz, r3
    .if \is_matt
    ldr r3, [r7, #GLINT_AT_TRIANGLE_NLX - 8]
    mov dnl, r3
    .endif
    ldr colours, [sp, #\constant]
    ldr r4, [r7, #GLINT_AT_TRIANGLE_X - 8]
    str r4, [sp, #COLUMN_NOW]
    ldr r0, [sp, #PLAIN]
.L\name\()_line: /* r0: w, r4: the values' column */
    mov r5, left
    asrs r5, r5, #16
    mov r6, right
    asrs r6, r6, #16
    held .L\name\()_hold, .L\name\()_next
.L\name\()_held:
    subs r5, r5, r4
    str r6, [sp, #COLUMN_NOW]
    lsls depth, r6, #1
    lsls out, r6, #1
    add depth, depths
    add out, outs
    lsls pixel, r0, #1
    aside z, dz
    .if \is_matt
    aside nl, dnl
.L\name\()_pixel:
    in_front 1f
    asrs r5, nl, #GLINT_COLOUR_ROW_SHIFT
    bmi .L\name\()_dark
    lsls r5, r5, #GLINT_COLOUR_ROW_BYTES_LOG
    ldrh r5, [colours, r5]
    strh r5, [out, pixel]
1:  add z, dz
    add nl, dnl
    .else
.L\name\()_pixel:
    in_front 1f
    strh colours, [out, pixel]
1:  add z, dz
    .endif
    adds pixel, #2
    bne .L\name\()_pixel
.L\name\()_next:
    add r0, sp, #STEPS
    ldmia r0!, {r4-r7}
    adds z, z, r4
    .if \is_matt
    adds nl, nl, r5
    .endif
    add left, r6
    add right, r7
    add r0, sp, #PLAIN
    ldmia r0, {r0, r4-r7}
    add depths, r5
    add outs, r6
    cmp depths, r7
    bne .L\name\()_line
    ldr r5, [sp, #TRIANGLE_LAST]
    cmp r7, r5
    beq 3f
    str r5, [sp, #LAST]
    ldr r7, [sp, #TRIANGLE]
    adds r7, #GLINT_AT_TRIANGLE_LONG + 16
    ldmia r7!, {r5, r6}
    ldr r7, [sp, #SIDES]
    lsls r7, r7, #31 - 8
    bmi 2f
    mov left, r5
    str r6, [sp, #STEPS + 8]
    b .L\name\()_line
2:  mov right, r5
    str r6, [sp, #STEPS + 12]
    b .L\name\()_line
3:  ldr r0, [sp, #SIDES]
    lsrs r0, r0, #16
    bne 4f
    add sp, #LINES_FRAME
    pop {pc}
4:  ldr r0, [sp, #TRIANGLE]
    ldr r5, [r0, #GLINT_AT_TRIANGLE_X]
    subs r5, r5, r4
    aside z, dz
    .if \is_matt
    aside nl, dnl
    .endif
    stmia r0!, {z, nl}
    mov r5, left
    mov r6, right
    b .Lgoes_on
.L\name\()_hold:
    hold .L\name\()_held, .L\name\()_next
    .if \is_matt
.L\name\()_dark:
    ldr r5, [sp, #DARK]
    strh r5, [out, pixel]
    add z, dz
    add nl, dnl
    adds pixel, #2
    bne .L\name\()_pixel
    b .L\name\()_next
    .endif
.endm

/* The triangle in r0; sp: to the struct glint_mesh_lines. Registers are lost. */
    .section .text.colour_lines, "ax", %progbits
    .type colour_lines, %function
    .balign 4
    .thumb_func
colour_lines:
    push {lr}
    sub sp, #LINES_FRAME
    str r0, [sp, #TRIANGLE]
    movs r7, r0
    adds r0, #GLINT_AT_TRIANGLE_Y
    ldmia r0!, {r3, r4} /* y, y_middle; y_end, shine, long_is_left */
    sxth r2, r3
    asrs r3, r3, #16
    sxth r5, r4
    lsrs r4, r4, #16
    ldr r6, [sp, #END]
    cmp r5, r6
    ble 1f
    movs r5, r6
    movs r0, #1
    lsls r0, r0, #16
    orrs r4, r0
1:  str r4, [sp, #SIDES]
    cmp r2, r5
    bge .Lnone
    ldr r0, [sp, #OUT_STEP]
    muls r0, r2
    ldr r1, [sp, #OUT_FIRST]
    adds r0, r0, r1
    mov outs, r0
    adds r7, #GLINT_AT_TRIANGLE_LONG
    mov r12, r7
    adds r7, #8 /* the upper edge */
    cmp r2, r3
    blt 1f
    adds r7, #8
    movs r3, r5
1:  cmp r3, r5
    ble 1f
    movs r3, r5
1:  ldr r6, [sp, #DEPTH_STEP]
    ldr r1, [sp, #DEPTH_FIRST]
    muls r2, r6
    muls r3, r6
    muls r5, r6
    adds r2, r2, r1
    mov depths, r2
    adds r3, r3, r1
    adds r5, r5, r1
    str r5, [sp, #TRIANGLE_LAST]
    str r3, [sp, #LAST]
    mov r1, r12
    lsls r0, r4, #31 - 8
    bmi 1f
    ldmia r1!, {r2, r6}
    ldmia r7!, {r0, r5}
    b 2f
1:  ldmia r1!, {r0, r5}
    ldmia r7!, {r2, r6}
2:  lsls r4, r4, #24
    beq .Ldark
    lsrs r4, r4, #24 + 1
    beq .Lmatt
    b .Lglossy
.Lnone:
    add sp, #LINES_FRAME
    pop {pc}

.Ldark:
    plain dark, DARK, 0
.Lmatt:
    plain matt, COLOURS, 1

/* r5, r6: the left and the right edge. */
.Lgoes_on:
    ldr r3, [sp, #SIDES]
    lsls r3, r3, #31 - 8
    bmi 1f
    movs r3, r5
    movs r5, r6
    movs r6, r3
1:  ldr r0, [sp, #TRIANGLE]
    adds r0, #GLINT_AT_TRIANGLE_LONG
    str r5, [r0]
    ldr r3, [sp, #END]
    movs r4, #GLINT_AT_TRIANGLE_Y_MIDDLE - GLINT_AT_TRIANGLE_LONG
    ldrsh r4, [r0, r4]
    cmp r3, r4
    ble 1f
    str r6, [r0, #16]
    b 2f
1:  str r6, [r0, #8]
2:  strh r3, [r0, #GLINT_AT_TRIANGLE_Y - GLINT_AT_TRIANGLE_LONG]
.Ldone:
    add sp, #LINES_FRAME
    pop {pc}


.Lglossy_hold:
    hold .Lglossy_held, .Lglossy_next

.Lglossy:
    mov r3, sp
    stmia r3!, {r0, r5}
    stmia r3!, {r2, r6}
    ldr r7, [sp, #TRIANGLE]
    ldmia r7!, {z, nl, t, r4} /* and tx */
    mov dt, r4
    ldmia r7!, {r4-r6} /* ty, zy, nly */
    str r5, [sp, #DOWN + 8]
    str r6, [sp, #DOWN + 12]
    ldmia r7!, {r5, r6} /* txy, tyy */
    str r6, [sp, #DOWN + 4]
    str r5, [sp, #COLUMN + 4]
    ldmia r7!, {r0, r6} /* zx, nlx */
    mov dz, r0
    mov dnl, r6
    ldmia r7!, {r0, r6} /* txx, x */
    mov ddt, r0
    str r6, [sp, #COLUMN]
    muls r5, r6
    subs r4, r4, r5
    str r4, [sp, #DOWN]
    lsls depth, r6, #1
    lsls out, r6, #1
    add depth, depths
    add out, outs
    ldr r0, [sp, #COLUMNS]
    mov columns, r0
    ldr r0, [sp, #T_MAX]
    mov t_max, r0
.Lglossy_line: /* depth and out: at the values' column */
    mov r0, sp
    ldmia r0!, {r5, r6}
    adds r6, r6, r5
    str r6, [sp, #LEFT]
    asrs r5, r5, #16
    ldmia r0, {r0, r6}
    adds r6, r6, r0
    str r6, [sp, #RIGHT]
    asrs r6, r0, #16
    ldr r0, [sp, #W]
    held .Lglossy_hold, .Lglossy_next
.Lglossy_held:
    ldr r0, [sp, #COLUMN]
    str r6, [sp, #COLUMN]
    subs r5, r5, r0
    subs r6, r6, r0
    subs r0, r5, r6
    lsls r6, r6, #1
    adds depth, depth, r6
    adds out, out, r6
    lsls pixel, r0, #1
    aside z, dz
    aside nl, dnl
    t_aside
1:  in_front 4f
    mov r6, t_max
    subs r6, r6, t
.Lhit:
    blo 6f
2:  ldr r5, [sp, #SHIFT]
    lsrs r6, r5
    add r6, columns
    ldrb r6, [r6]
    asrs r5, nl, #GLINT_COLOUR_ROW_SHIFT
    bmi 5f
    lsls r5, r5, #GLINT_COLOUR_ROW_BYTES_LOG
    adds r5, r5, r6
    ldr r6, [sp, #COLOURS]
    ldrh r5, [r6, r5]
    strh r5, [out, pixel]
4:  add z, dz
    add nl, dnl
    add t, dt
    add dt, ddt
    adds pixel, #2
    bne 1b
.Lglossy_next:
    add r0, sp, #DOWN
    ldmia r0!, {r5, r6}
    adds t, t, r5
    adds r5, r5, r6
    str r5, [sp, #DOWN]
    ldmia r0!, {r5, r6}
    adds z, z, r5
    adds nl, nl, r6
    ldmia r0!, {r5, r6}
    add dt, r6
    muls r6, r5
    adds t, t, r6
    ldr r6, [sp, #OUT_STEP]
    adds out, out, r6
    ldr r6, [sp, #DEPTH_STEP]
    adds depth, depth, r6
    lsls r5, r5, #1
    subs r5, depth, r5
    ldr r6, [sp, #LAST]
    cmp r5, r6
    bne .Lglossy_line
    ldr r0, [sp, #TRIANGLE_LAST]
    cmp r0, r6
    beq .Lglossy_last
    str r0, [sp, #LAST]
    ldr r0, [sp, #TRIANGLE]
    adds r0, #GLINT_AT_TRIANGLE_LONG + 16
    ldmia r0!, {r5, r6}
    ldr r0, [sp, #SIDES]
    lsls r0, r0, #31 - 8
    bmi 8f
    mov r0, sp
    stmia r0!, {r5, r6}
    b .Lglossy_line
8:  add r0, sp, #RIGHT
    stmia r0!, {r5, r6}
    b .Lglossy_line
5:  ldr r5, [sp, #DARK]
    strh r5, [out, pixel]
    b 4b
6:  asrs r5, t, #GLINT_NEGATIVE_T_LOG /* t is over t_max, or a little below 0 */
    adds r5, #1
    bne 2f
    mov r6, t_max
    b 2b

/* Pixels past t_max: mostly one after the other. */
1:  in_front 3f
    mov r6, t_max
    subs r6, r6, t
    bpl .Lhit
2:  asrs r5, nl, #GLINT_COLOUR_ROW_SHIFT
    bmi 4f
    lsls r5, r5, #GLINT_COLOUR_ROW_BYTES_LOG
    ldr r6, [sp, #COLOURS]
    ldrh r5, [r6, r5]
    strh r5, [out, pixel]
3:  add z, dz
    add nl, dnl
    add t, dt
    add dt, ddt
    adds pixel, #2
    bne 1b
    b .Lglossy_next
4:  ldr r5, [sp, #DARK]
    strh r5, [out, pixel]
    b 3b

.Lglossy_last:
    ldr r0, [sp, #SIDES]
    lsrs r0, r0, #16
    beq 1f
    ldr r7, [sp, #TRIANGLE]
    ldr r0, [r7, #GLINT_AT_TRIANGLE_X]
    add r6, sp, #COLUMN
    ldmia r6, {r4, r6}
    subs r5, r0, r4
    muls r0, r6
    ldr r4, [sp, #DOWN]
    adds r4, r4, r0
    aside z, dz
    aside nl, dnl
    t_aside
    mov r0, dt
    movs r5, r4
    movs r4, r0
    stmia r7!, {r1-r5}
    ldr r5, [sp, #LEFT]
    ldr r6, [sp, #RIGHT]
    b .Lgoes_on
1:  b .Ldone
#endif
