/* SPDX-License-Identifier: MIT
 * glint_mesh_triangle_set(triangle, corner, shine, t_end), as mesh_edges.c has it: corners by y, then three edges by a routine that
 * keeps all it needs in registers, the inverse of its height included; then its values, by cortex_m0plus_gradient.S. */
#if defined GLINT_CORTEX_M0PLUS_ASM && GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus_gradient.inc"

/* The first line whose middle is at or beyond y. */
.macro first line, y
    adds \line, \y, #7
    asrs \line, \line, #4
.endm

/* Of two corners that follow each other. */
.macro exchange a, b, ya, yb
    movs r7, \a
    movs \a, \b
    movs \b, r7
    movs r7, \ya
    movs \ya, \yb
    movs \yb, r7
.endm

    function glint_mesh_triangle_set
    push {r4-r7, lr}
    sub sp, #FRAME
    str r0, [sp, #TRIANGLE]
    str r2, [sp, #SHINE]
    ldr r4, [r1]
    ldr r5, [r1, #8]
    ldr r6, [r1, #16]
    least_t r0, r4, r5, r6
    subs r0, r0, r3
    bhs 1f
    movs r0, #0
1:  str r0, [sp, #BEYOND]
.Lcorners: /* r1 */
    movs r2, r1
    adds r2, #8
    movs r3, r1
    adds r3, #16
    movs r0, #2
    ldr r7, [r1]
    ldrsh r4, [r7, r0]
    ldr r7, [r2]
    ldrsh r5, [r7, r0]
    ldr r7, [r3]
    ldrsh r6, [r7, r0]
    cmp r5, r4
    bge 1f
    exchange r1, r2, r4, r5
1:  cmp r6, r5
    bge 1f
    exchange r2, r3, r5, r6
    cmp r5, r4
    bge 1f
    exchange r1, r2, r4, r5
1:  add r7, sp, #CORNERS
    stmia r7!, {r1-r3}
    ldr r1, [r1]
    ldr r2, [r2]
    ldr r3, [r3]
    mov r7, sp
    stmia r7!, {r1-r3}
    ldr r0, [sp, #TRIANGLE]
    adds r0, #GLINT_AT_TRIANGLE_Y
    first r7, r5
    strh r7, [r0, #GLINT_AT_TRIANGLE_Y_MIDDLE - GLINT_AT_TRIANGLE_Y]
    first r7, r6
    strh r7, [r0, #GLINT_AT_TRIANGLE_Y_END - GLINT_AT_TRIANGLE_Y]
    subs r6, r6, r4 /* y2 */
    subs r5, r5, r4 /* y1 */
    first r4, r4
    strh r4, [r0]
    cmp r4, r7
    bge .Lnothing
    movs r4, #0
    ldrsh r1, [r1, r4]
    ldrsh r2, [r2, r4]
    ldrsh r3, [r3, r4]
    subs r4, r2, r1 /* x1 */
    subs r3, r1, r3 /* -x2 */
    movs r1, r6
    negs r2, r5
    muls r6, r4
    muls r5, r3
    adds r5, r5, r6
    beq .Lnothing
    str r5, [sp, #AREA]
    add r7, sp, #UX
    stmia r7!, {r1-r4}
    movs r4, #0
    cmp r5, #0
    ble 1f
    movs r4, #1
1:  strb r4, [r0, #GLINT_AT_TRIANGLE_LONG_IS_LEFT - GLINT_AT_TRIANGLE_Y]
    subs r0, #GLINT_AT_TRIANGLE_Y - GLINT_AT_TRIANGLE_LONG
    ldr r1, [sp, #VERTICES]
    ldr r2, [sp, #VERTICES + 8]
    bl triangle_edge
    ldr r1, [sp, #VERTICES]
    ldr r2, [sp, #VERTICES + 4]
    bl triangle_edge
    ldr r1, [sp, #VERTICES + 4]
    ldr r2, [sp, #VERTICES + 8]
    bl triangle_edge
    bl glint_mesh_triangle_values /* does not return here */
.Lnothing:
    movs r0, #0
    add sp, #FRAME
    pop {r4-r7, pc}

/* r3-r5: a face's normals of 8 bits from r1 on; r2: the face. The differences' squares: r2, r6, r1. */
.macro normal to, at
    ldrh \to, [r2, #\at]
    lsls r6, \to, #1
    adds \to, \to, r6
    adds \to, \to, r1
.endm

.macro difference at
    movs r1, #\at
    ldrsb r2, [r3, r1]
    ldrsb r6, [r4, r1]
    ldrsb r1, [r5, r1]
    subs r2, r2, r6
    subs r6, r6, r1
    adds r1, r2, r6
    muls r2, r2
    muls r6, r6
    muls r1, r1
.endm

/* glint_mesh_face_set(triangle, drawn, face, t_end), as mesh_strip.c has it; sides between normals of 8 bits as glint_mesh_sides8 has them. */
    entry glint_mesh_face_set
    push {r4-r7, lr}
    sub sp, #FRAME
    str r0, [sp, #TRIANGLE]
    ldr r7, [r1, #GLINT_AT_DRAWN_VERTICES]
    ldrh r4, [r2]
    ldrh r5, [r2, #2]
    ldrh r6, [r2, #4]
    lsls r4, r4, #4
    lsls r5, r5, #4
    lsls r6, r6, #4
    adds r4, r4, r7
    adds r5, r5, r7
    adds r6, r6, r7
    str r4, [sp, #FACE]
    str r5, [sp, #FACE + 8]
    str r6, [sp, #FACE + 16]
    ldr r0, [r4, #NL_OF]
    ldr r7, [r5, #NL_OF]
    ands r0, r7
    ldr r7, [r6, #NL_OF]
    ands r0, r7
    bmi 4f
    least_t r0, r4, r5, r6
    subs r0, r0, r3
    bhs 1f
    movs r0, #0
1:  str r0, [sp, #BEYOND]
    lsrs r0, r0, #29
    bne 3f
    ldr r1, [r1, #GLINT_AT_DRAWN_MESH]
    ldr r3, [r1, #GLINT_AT_MESH_NORMALS]
    cmp r3, #0
    bne 2f
    ldr r1, [r1, #GLINT_AT_MESH_NORMALS8]
    normal r3, 0
    normal r4, 2
    normal r5, 4
    difference 0
    mov r12, r2
    mov lr, r6
    movs r7, r1
    difference 1
    add r12, r2
    add lr, r6
    adds r7, r7, r1
    difference 2
    add r2, r12
    add r6, lr
    adds r7, r7, r1
    ldr r1, =129 * 129
    muls r6, r1
    str r6, [sp, #FACE + 4]
    muls r7, r1
    str r7, [sp, #FACE + 12]
    muls r2, r1
    str r2, [sp, #FACE + 20]
    movs r2, #GLINT_SHINE_MATT + 1
    b 5f
2:  add r0, sp, #FACE
    bl glint_mesh_sides16
    movs r2, #GLINT_SHINE_MATT + 1
    b 5f
3:  movs r2, #GLINT_SHINE_MATT
    b 5f
4:  movs r2, #GLINT_SHINE_DARK
5:  str r2, [sp, #SHINE]
    add r1, sp, #FACE
    b .Lcorners

/* An edge from vertex r1 down to r2 to where r0 points, which moves on by it; r1-r7 and r12 are lost. */
    .section .text.triangle_edge, "ax", %progbits
    .type triangle_edge, %function
    .balign 4
    .thumb_func
triangle_edge:
    ldr r1, [r1] /* x, y */
    ldr r2, [r2]
    asrs r4, r1, #16
    asrs r5, r2, #16
    first r6, r4
    first r7, r5
    cmp r6, r7
    bge .Lno_line
    sxth r1, r1
    sxth r2, r2
    subs r2, r2, r1 /* dx */
    subs r5, r5, r4 /* dy, 15 bits */
    lsls r6, r6, #4
    adds r6, #8
    subs r6, r6, r4 /* from the corner to the line's middle */
    movs r3, #14    /* 31 - zeros(dy) */
    lsls r5, r5, #17
    up_by_15 r5, r3, r4
    mov r12, r3
    inverse_of r5, r4, r7, r3
    muls r2, r5
    mov r3, r12
    asrs r2, r3 /* the step */
    asrs r3, r2, #4
    muls r3, r6
    lsls r1, r1, #12
    adds r1, r1, r3
    ldr r3, =65535 - 32768
    adds r1, r1, r3
    stmia r0!, {r1, r2}
    bx lr
.Lno_line:
    movs r1, #0
    movs r2, #0
    stmia r0!, {r1, r2}
    bx lr
    .ltorg
#endif
