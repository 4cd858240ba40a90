/* SPDX-License-Identifier: MIT
 * glint_colour_span(tables, span, out), run by run as fused_tables.c has it. Loops over a run are unrolled whole, and entered so that they end after w pixels. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

    function glint_colour_span
    push {r4-r7, lr}
    movs r3, r2 /* the pixels */
    ldrh r4, [r1, #GLINT_AT_SPAN_W]
    subs r4, #1
    cmp r4, #GLINT_SPAN_RUN - 1
    bls .Lrun
    adds r4, #1
    bne .Llong
    pop {r4-r7, pc}

.Llong: /* run by run: at sp t, dt, ddt, nl, dnl, tables, out, how many are left */
    sub sp, #36 /* a multiple of 8 with what is pushed */
    str r4, [sp, #28]
    mov r5, sp
    ldmia r1!, {r2, r4, r6}
    stmia r5!, {r2, r4, r6}
    ldmia r1!, {r2, r4}
    stmia r5!, {r2, r4}
    str r0, [r5]
    str r3, [r5, #4]
2:  mov r1, sp
    movs r2, #GLINT_SPAN_RUN
    bl .Lany_run
    mov r0, sp
    ldmia r0!, {r1-r7} /* r6: tables, r7: out */
    subs r0, #28
    movs r5, #GLINT_SPAN_RUN - 1
    lsls r5, r5, #GLINT_SPAN_RUN_LOG - 1 /* 31 * 32 / 2 */
    muls r5, r3
    adds r1, r1, r5
    lsls r5, r2, #GLINT_SPAN_RUN_LOG
    adds r1, r1, r5
    lsls r5, r3, #GLINT_SPAN_RUN_LOG
    adds r2, r2, r5
    ldr r5, [sp, #16]
    lsls r5, r5, #GLINT_SPAN_RUN_LOG
    adds r4, r4, r5
    stmia r0!, {r1-r4}
    movs r3, r7
    adds r3, #2 * GLINT_SPAN_RUN
    str r3, [sp, #24]
    ldr r2, [sp, #28]
    subs r2, #GLINT_SPAN_RUN
    str r2, [sp, #28]
    movs r0, r6
    cmp r2, #GLINT_SPAN_RUN
    bhi 2b
    mov r1, sp
    bl .Lany_run
    add sp, #36
    pop {r4-r7, pc}

    .balign 4
.Lany_run: /* (tables, span, w, out) */
    push {r4-r7, lr}
    subs r4, r2, #1
.Lrun: /* tables r0, dnl r1 and lr, t r2, out r12, m = w - 1 r4, dt r5, ddt r6, nl r7 */
    ldmia r1!, {r2, r5-r7}
    ldr r1, [r1]
    mov r12, r3
    mov lr, r1
    movs r3, r4
    muls r3, r1
    adds r3, r3, r7 /* the last nl */
    orrs r3, r7
    orrs r3, r2
    bmi .Lnegative
    movs r3, #1
    lsls r3, r3, #25
    adds r1, r1, r3
    adds r3, r3, r5
    orrs r3, r1
    lsrs r3, r3, #26
    bne .Lmixed_of_t
    lsrs r3, r6, #20
    bne .Lmixed_of_t
    ldr r1, [r0, #GLINT_AT_TABLES_T_MAX]
    subs r1, r1, r2 /* back = t_max - t */
    bpl .Lstarts_inside
    cmp r5, #0
    bpl .Loutside
    movs r2, r4 /* t is not below the tangent at the start */
    muls r2, r5
    subs r2, r1, r2
    bmi .Loutside
    b .Lmixed

.Lstarts_inside:
    movs r2, r4
    muls r2, r5
    subs r3, r4, #1
    muls r3, r4
    lsrs r3, r3, #1
    muls r3, r6
    adds r3, r3, r2
    subs r3, r1, r3 /* the last back */
    bmi .Lmixed_1
    cmp r5, #0
    bmi 1f
    b .Linside
1:  subs r2, r1, r2
    ldr r3, [r0, #GLINT_AT_TABLES_T_MAX]
    cmp r2, r3
    bgt .Lmixed_1
    b .Linside
.Lmixed_1:
    b .Lmixed

.Lnegative: /* t, or nl at an end; dnl is still in r1 */
    movs r3, r4
    muls r3, r1
    adds r3, r3, r7
    ands r3, r7
    bpl .Lmixed_of_t
    movs r3, #1
    lsls r3, r3, #25
    adds r3, r3, r1
    lsrs r3, r3, #26
    bne .Lmixed_of_t
    b .Ldark
.Lmixed_of_t:
    ldr r1, [r0, #GLINT_AT_TABLES_T_MAX]
    subs r1, r1, r2
    b .Lmixed

.Loutside: /* nl r7, dnl r1, colours r0, out r3 */
    ldr r0, [r0, #GLINT_AT_TABLES_COLOUR]
    mov r1, lr
    movs r2, #GLINT_SPAN_RUN - 1
    subs r2, r2, r4
    mov r3, r12
    lsls r4, r2, #1
    subs r3, r3, r4
    movs r4, #10 /* bytes of code a pixel */
    muls r2, r4
    add pc, r2
    nop
    .set pixel, 0
.rept GLINT_SPAN_RUN
    lsrs r4, r7, #GLINT_COLOUR_ROW_SHIFT
    lsls r4, r4, #GLINT_COLOUR_ROW_BYTES_LOG
    ldrh r4, [r0, r4]
    strh r4, [r3, #2 * pixel]
    adds r7, r7, r1
    .set pixel, pixel + 1
.endr
    movs r0, #0
    pop {r4-r7, pc}

.Linside: /* back r1, -dt r5, -ddt r12, all scaled; nl r7, dnl lr; columns r0, colours r2, out r3 */
    ldrb r2, [r0, #GLINT_AT_TABLES_SHIFT]
    movs r3, #32 - GLINT_COLOUR_COLUMNS_LOG
    subs r2, r3, r2
    lsls r1, r2
    rsbs r5, r5, #0
    lsls r5, r2
    rsbs r6, r6, #0
    lsls r6, r2
    mov r3, r12
    mov r12, r6
    movs r6, #GLINT_SPAN_RUN - 1
    subs r6, r6, r4
    lsls r4, r6, #1
    subs r3, r3, r4
    movs r4, #20 /* bytes of code a pixel */
    muls r6, r4
    ldmia r0, {r0, r2}
    add pc, r6
    nop
    .set pixel, 0
.rept GLINT_SPAN_RUN
    lsrs r4, r1, #32 - GLINT_COLOUR_COLUMNS_LOG
    ldrb r4, [r0, r4]
    lsrs r6, r7, #GLINT_COLOUR_ROW_SHIFT
    lsls r6, r6, #GLINT_COLOUR_ROW_BYTES_LOG
    adds r6, r6, r4
    ldrh r6, [r2, r6]
    strh r6, [r3, #2 * pixel]
    add r7, lr
    adds r1, r1, r5
    add r5, r12
    .set pixel, pixel + 1
.endr
    movs r0, #0
    pop {r4-r7, pc}

.Ldark:
    ldrh r0, [r0, #GLINT_AT_TABLES_DARK]
    movs r2, #GLINT_SPAN_RUN - 1
    subs r2, r2, r4
    lsls r2, r2, #1
    mov r3, r12
    subs r3, r3, r2
    add pc, r2
    nop
    .set pixel, 0
.rept GLINT_SPAN_RUN
    strh r0, [r3, #2 * pixel]
    .set pixel, pixel + 1
.endr
    movs r0, #0
    pop {r4-r7, pc}

/* ---- pixels of any kind: a row of four each for those within the cutoff and past it ---- */

#define colours r0
#define back r1
#define shift r2
#define out r3
#define j r4
#define dback r5
#define at r6
#define nl r7
#define ddback r8
#define columns r9
#define last r10
#define limit r11 /* back <= limit: t is up to t_max, or a little below 0 */
#define t_max r12
#define dnl lr

.macro run_step
    add nl, dnl
    adds back, back, dback
    add dback, ddback
.endm

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

.Lmixed: /* back r1, m r4, -dback r5, -ddback r6, nl r7, dnl lr, out r12; end will be at sp, dark at sp + 4 */
    mov r2, r8
    mov r3, r9
    push {r2, r3}
    mov r2, r10
    mov r3, r11
    push {r2, r3}
    mov out, r12
    ldrh r2, [r0, #GLINT_AT_TABLES_DARK]
    lsls r4, r4, #1
    adds r4, r4, out
    adds r4, #2
    sub sp, #8
    str r4, [sp]
    str r2, [sp, #4]
    subs r4, #8
    mov last, r4
    rsbs r6, r6, #0
    mov ddback, r6
    rsbs dback, dback, #0
    ldr r4, [r0, #GLINT_AT_TABLES_COLUMNS]
    mov columns, r4
    ldr r4, [r0, #GLINT_AT_TABLES_T_MAX]
    mov t_max, r4
    movs r6, #1
    lsls r6, r6, #GLINT_NEGATIVE_T_LOG
    adds r4, r4, r6
    mov limit, r4
    ldrb shift, [r0, #GLINT_AT_TABLES_SHIFT]
    ldr colours, [r0, #GLINT_AT_TABLES_COLOUR]
.Lmixed_rest:
    cmp out, last
    bls .Lmixed_past_0
    ldr at, [sp]
    cmp out, at
    bhs 5f
    asrs at, nl, #GLINT_COLOUR_ROW_SHIFT
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
2:  lsls at, at, #GLINT_COLOUR_ROW_BYTES_LOG
    adds at, at, j
    ldrh at, [colours, at]
    b 4f
3:  ldr at, [sp, #4]
4:  strh at, [out]
    adds out, #2
    run_step
    b .Lmixed_rest
5:  add sp, #8
    pop {r2, r3}
    mov r10, r2
    mov r11, r3
    pop {r2, r3}
    mov r8, r2
    mov r9, r3
    movs r0, #0
    pop {r4-r7, pc}

    mixed_dark past
.irp i, 0, 1, 2, 3
.Lmixed_past_\i:
    asrs at, nl, #GLINT_COLOUR_ROW_SHIFT
    bmi .Lmixed_past_dark_\i
    cmp back, limit
    bls .Lmixed_is_in_\i
.Lmixed_is_past_\i:
    lsls at, at, #GLINT_COLOUR_ROW_BYTES_LOG
    ldrh at, [colours, at]
    strh at, [out, #2 * \i]
.Lmixed_past_step_\i:
    run_step
.endr
    mixed_next past

.irp i, 0, 1, 2, 3
.Lmixed_in_\i:
    asrs at, nl, #GLINT_COLOUR_ROW_SHIFT
    bmi .Lmixed_in_dark_\i
.Lmixed_is_in_\i:
    movs j, back
    cmp back, t_max
    bhi .Lmixed_over_\i
.Lmixed_column_\i:
    lsrs j, shift
    add j, columns
    ldrb j, [j]
    lsls at, at, #GLINT_COLOUR_ROW_BYTES_LOG
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
#endif
