/* SPDX-License-Identifier: MIT
 * glint_mesh_triangle_set(triangle, corner, shine, t_end), as mesh_triangle.c has it: corners by y, then three edges by a routine that
 * keeps all it needs in registers, the inverse of its height included; then its values. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"
#include "cortex_m0plus_numbers.inc"

/* ---- both: a frame, and mesh_triangle.c's helpers as macros on registers, which they name; each register named is another one ---- */

#define T_OF 8 /* of a vertex */
#define NL_OF 12

/* The frame. */
#define VERTICES 0 /* from the upper one down */
#define SLOPES 12  /* u, v, ux, vx, uy, vy */
#define UX 20      /* y2, -y1, -x2, x1 first, of which the slopes are made */
#define UY 28
#define E 36     /* e - 18 */
#define SIDES 40 /* rr, qq, pp; then B, C, A: P.Q, Q.Q, P.P of 15 bits */
#define PLACES SIDES /* before: x, y of the vertices */
#define TRIANGLE 52
#define SHINE 56 /* flat and glossy: FLAT */
#define CORNERS 60
#define BEYOND 72 /* the least t beyond t_end, or 0 */
#define AREA 76
#define LAY 80 /* below 0: slopes are laid behind the triangle */
#define FACE 84 /* the corners of a face */
#define FRAME 108 /* with lr a multiple of 8 */

/* least: of t at three vertices; second and third are lost. */
.macro least_t least, first, second, third
    ldr \least, [\first, #T_OF]
    ldr \second, [\second, #T_OF]
    ldr \third, [\third, #T_OF]
    cmp \least, \second
    bls 1f
    movs \least, \second
1:  cmp \least, \third
    bls 1f
    movs \least, \third
1:
.endm

/* ---- edges ---- */

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
    push {r3-r7, lr}
    bl 1f
    pop {r3-r7, pc}
1:  push {lr}
    sub sp, #FRAME
    str r0, [sp, #TRIANGLE]
    movs r0, #0
    str r0, [sp, #LAY]
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
    ldr r1, [r1]
    ldr r2, [r2]
    ldr r3, [r3]
    add r7, sp, #PLACES
    stmia r7!, {r1-r3}
    sxth r1, r1
    sxth r2, r2
    sxth r3, r3
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
    ldr r1, [sp, #PLACES]
    ldr r2, [sp, #PLACES + 8]
    bl triangle_edge
    ldr r1, [sp, #PLACES]
    ldr r2, [sp, #PLACES + 4]
    bl triangle_edge
    ldr r1, [sp, #PLACES + 4]
    ldr r2, [sp, #PLACES + 8]
    bl triangle_edge
    bl glint_mesh_triangle_values /* does not return here */
.Lnothing:
    movs r0, #0
    add sp, #FRAME
    pop {pc}

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

/* glint_mesh_face_set(triangle, drawn, face, t_end), as mesh_strip.c has it; t_end + 2^31: slopes are laid, too. Sides between normals of 8 bits as glint_mesh_sides8 has them. */
    entry glint_mesh_face_set
    push {r3-r7, lr}
    bl glint_mesh_face_lines
    pop {r3-r7, pc}

    entry glint_mesh_face_lines /* the same; r4-r7 are lost */
    push {lr}
    sub sp, #FRAME
    str r0, [sp, #TRIANGLE]
    str r3, [sp, #LAY]
    lsls r3, r3, #1
    lsrs r3, r3, #1
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

/* An edge from place r1 down to r2 to where r0 points, which moves on by it; r1-r7 and r12 are lost. */
    .section .text.triangle_edge, "ax", %progbits
    .type triangle_edge, %function
    .balign 4
    .thumb_func
triangle_edge:
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
    lsrs r4, r5, #8
    bne .Lhigh
    movs r3, #7     /* 31 - zeros(dy) */
    lsls r5, r5, #24
    up_by 4, r5, r3, r4
    up_by 2, r5, r3, r4
    up_by 1, r5, r3, r4
    lsrs r5, r5, #23
    ldr r4, =triangle_inverses - 256
    ldrh r5, [r4, r5]
    adds r5, #1
.Lstep:
    muls r2, r5
    asrs r2, r3 /* the step */
    asrs r3, r2, #4
    muls r3, r6
    adds r1, #8
    lsls r1, r1, #12
    subs r1, #1 /* 65535 - 32768 more */
    adds r1, r1, r3
    stmia r0!, {r1, r2}
    bx lr
.Lhigh:
    movs r3, #14
    lsls r5, r5, #17
    up_by 4, r5, r3, r4
    up_by 2, r5, r3, r4
    up_by 1, r5, r3, r4
    mov r12, r3
    inverse_of r5, r4, r7, r3
    mov r3, r12
    b .Lstep
.Lno_line:
    movs r1, #0
    movs r2, #0
    stmia r0!, {r1, r2}
    bx lr
    .ltorg

/* glint_mesh_inverse, less 1, of what has 8 bits. */
    .section .rodata.triangle_inverses, "a", %progbits
    .balign 2
triangle_inverses:
    .set height, 128
    .rept 128
    .short ((1 << 23) + height / 2) / height - 1
    .set height, height + 1
    .endr

/* ---- values ----
 * The end of glint_mesh_triangle_set, whose frame it takes over: glint_mesh_values_set, as mesh_triangle.c has it: slopes, the depth, nl, and t
 * where it may shine. The slopes lie in the frame in the order in which sums of two products take them; e is kept 18 less, so that
 * its sign tells how what is linear is shifted. */

#define DOWN SHINE /* once it is known to be glossy: P.P, Q.Q and P.Q are shifted by it */

#define FLAT 3

/* values_linear of p in r1 and q in r2, r7 pointing to the slopes: at, x, y in r3-r5; the base in r0 is added. To three values; r7 is these then. */
.macro linear at, x, y
    ldmia r7!, {r3, r4}
    muls r3, r1
    muls r4, r2
    adds r3, r3, r4
    ldmia r7!, {r4, r5}
    muls r4, r1
    muls r5, r2
    adds r4, r4, r5
    ldmia r7!, {r5, r6}
    muls r5, r1
    muls r6, r2
    adds r5, r5, r6
    ldr r6, [r7, #E - SLOPES - 24]
    ldr r7, [sp, #TRIANGLE]
    cmp r6, #0
    blt 1f
    asrs r3, r6
    adds r6, #1
    asrs r4, r6
    asrs r5, r6
    b 2f
1:  negs r6, r6
    lsls r3, r6
    subs r6, #1
    lsls r4, r6
    lsls r5, r6
2:  adds r3, r3, r0
    str r3, [r7, #\at]
    str r4, [r7, #\x]
    str r5, [r7, #\y]
.endm

    function glint_mesh_triangle_values
    ldr r3, [sp, #SHINE]
    cmp r3, #GLINT_SHINE_MATT
    bls .Lshine_known
    /* Matt if t, which is lower between the corners by two thirds of a side at most, stays beyond t_end. */
    add r7, sp, #CORNERS
    ldmia r7!, {r4-r6}
    ldr r0, [r4, #4]
    ldr r1, [r5, #4]
    ldr r2, [r6, #4]
    add r7, sp, #SIDES
    stmia r7!, {r0-r2}
    cmp r0, r1
    bhs 1f
    movs r0, r1
1:  cmp r0, r2
    bhs 1f
    movs r0, r2
1:  movs r1, #1
    lsls r1, r1, #29
    cmp r0, r1
    bls 1f
    movs r3, #FLAT
    str r3, [sp, #SHINE]
    b .Lshine_known
1:  ldr r1, [sp, #BEYOND]
    lsrs r2, r0, #GLINT_MESH_MARGIN_LOG
    subs r2, r1, r2
    str r2, [sp, #BEYOND] /* and by a margin, for .Lt */
    cmp r1, r0
    bls .Lshine_known
    movs r3, #GLINT_SHINE_MATT
    str r3, [sp, #SHINE]
.Lshine_known:
    ldr r2, [sp, #AREA]
    /* The inverse of the area, and its sign. */
    asrs r3, r2, #31
    eors r2, r3
    subs r2, r2, r3
    mov lr, r3
    movs r1, #43 - 18
    up_by 16, r2, r1, r7
    up_by_15 r2, r1, r7
    inverse_of r2, r0, r7, r3
    mov r3, lr
    eors r2, r3
    subs r2, r2, r3

    /* r3: ux, r5: vx, r6: uy, r7: vy; from the corner to the pixel, r12: fx, lr: fy = 15 - (a->y + 7) % 16. */
    add r4, sp, #UX
    ldmia r4!, {r3, r5-r7}
    muls r3, r2
    muls r5, r2
    muls r6, r2
    muls r7, r2
    ldr r4, [sp, #VERTICES]
    ldr r0, [r4] /* x, y */
    sxth r2, r0
    asrs r2, r2, #4
    ldr r4, [sp, #TRIANGLE]
    str r2, [r4, #GLINT_AT_TRIANGLE_X]
    lsls r2, r0, #28
    lsrs r2, r2, #28
    movs r4, #8
    subs r4, r4, r2
    mov r12, r4
    asrs r0, r0, #16
    adds r0, #7
    mvns r0, r0
    lsls r0, r0, #28
    lsrs r0, r0, #28
    mov lr, r0
    size_of r0, r3
    size_of r2, r5
    orrs r0, r2
    size_of r2, r6
    orrs r0, r2
    size_of r2, r7
    orrs r0, r2
    lsrs r2, r0, #14
    adds r0, r0, r2 /* from 2^15 on, since the inverse is: down is not 0 */
    lsrs r0, r0, #15
    count_bits r2, r0, r4
    movs r0, #1
    lsls r0, r2
    lsrs r0, r0, #1
    adds r3, r3, r0
    asrs r3, r2
    adds r5, r5, r0
    asrs r5, r2
    adds r6, r6, r0
    asrs r6, r2
    adds r7, r7, r0
    asrs r7, r2
    subs r1, r1, r2
    add r4, sp, #UX
    stmia r4!, {r3, r5-r7}
    str r1, [r4] /* e - 18 */
    mov r0, lr
    muls r6, r0
    muls r7, r0
    mov r0, r12
    muls r3, r0
    muls r5, r0
    adds r3, r3, r6
    adds r3, #16
    asrs r3, r3, #5
    adds r5, r5, r7
    adds r5, #16
    asrs r5, r5, #5
    str r3, [sp, #SLOPES]
    str r5, [sp, #SLOPES + 4]

    mov r7, sp
    ldmia r7!, {r3-r5}
    ldrh r0, [r3, #4]
    ldrh r3, [r4, #4]
    ldrh r2, [r5, #4]
    adds r1, #18 - GLINT_MESH_STEEP
    bmi .Lsteep
    subs r1, r3, r0
    adds r1, #1
    asrs r1, r1, #1
    subs r2, r2, r0
    adds r2, #1
    asrs r2, r2, #1
    lsls r0, r0, #16
    linear GLINT_AT_TRIANGLE_Z, GLINT_AT_TRIANGLE_ZX, GLINT_AT_TRIANGLE_ZY

    ldr r0, [sp, #SHINE]
    cmp r0, #FLAT
    beq .Lflat
    subs r0, #GLINT_SHINE_MATT
    blo .Ldark
    mov r7, sp
    ldmia r7!, {r3-r5}
    ldr r0, [r3, #NL_OF]
    asrs r3, r0, #2
    movs r6, #1
    lsls r6, r6, #14
    subs r3, r3, r6
    ldr r1, [r4, #NL_OF]
    asrs r1, r1, #2
    subs r1, r1, r3
    asrs r1, r1, #15
    ldr r2, [r5, #NL_OF]
    asrs r2, r2, #2
    subs r2, r2, r3
    asrs r2, r2, #15
    linear GLINT_AT_TRIANGLE_NL, GLINT_AT_TRIANGLE_NLX, GLINT_AT_TRIANGLE_NLY
    ldr r0, [sp, #SHINE]
    cmp r0, #GLINT_SHINE_MATT
    bne .Lt
.Lfar: /* r0: the shine */
    movs r1, #1
    lsls r1, r1, #31
.Lt_stays: /* t is r1; r7: values */
    movs r2, #0
    movs r3, #0
    str r2, [r7, #GLINT_AT_TRIANGLE_TXX]
    str r2, [r7, #GLINT_AT_TRIANGLE_TXY]
    str r2, [r7, #GLINT_AT_TRIANGLE_TYY]
    adds r7, #GLINT_AT_TRIANGLE_T
    stmia r7!, {r1-r3}
    adds r7, #GLINT_AT_TRIANGLE_SHINE - GLINT_AT_TRIANGLE_ZY
.Lset: /* r0: the shine, r7: to it */
    strb r0, [r7]
    ldr r1, [sp, #LAY]
    cmp r1, #0
    blt .Llay
.Lreturn:
    movs r0, #1
    add sp, #FRAME
    pop {pc}

.Llay: /* what glint_mesh_albedo_draw makes u and v of */
    movs r1, #GLINT_MESH_SLOPED
    orrs r0, r1
    strb r0, [r7]
    adds r7, #GLINT_MESH_KEPT_SIZE - GLINT_AT_TRIANGLE_SHINE
    add r6, sp, #SLOPES
    ldmia r6!, {r0-r5}
    stmia r7!, {r0-r5}
    ldr r6, [r6]
    mov r0, sp
    ldmia r0!, {r1-r3}
    stmia r7!, {r1-r3}
    str r6, [r7]
    b .Lreturn

.Ldark:
    movs r1, #0
    mvns r0, r1
    str r0, [r7, #GLINT_AT_TRIANGLE_NL]
    str r1, [r7, #GLINT_AT_TRIANGLE_NLX]
    str r1, [r7, #GLINT_AT_TRIANGLE_NLY]
    movs r0, #GLINT_SHINE_DARK
    b .Lfar

.Lsteep:
    adds r0, r0, r3
    adds r0, r0, r2
    ldr r1, =65535 / 3
    muls r0, r1
    movs r1, #0
    ldr r7, [sp, #TRIANGLE]
    str r0, [r7, #GLINT_AT_TRIANGLE_Z]
    str r1, [r7, #GLINT_AT_TRIANGLE_ZX]
    str r1, [r7, #GLINT_AT_TRIANGLE_ZY]
.Lflat: /* one light */
    ldr r0, [sp, #SHINE]
    cmp r0, #GLINT_SHINE_DARK
    beq .Ldark
    mov r6, sp
    ldmia r6!, {r1, r4, r5}
    ldr r2, [r1, #NL_OF]
    asrs r2, r2, #2
    ldr r3, [r4, #NL_OF]
    asrs r3, r3, #1
    adds r2, r2, r3
    ldr r3, [r5, #NL_OF]
    asrs r3, r3, #2
    adds r2, r2, r3
    movs r3, #0
    str r2, [r7, #GLINT_AT_TRIANGLE_NL]
    str r3, [r7, #GLINT_AT_TRIANGLE_NLX]
    str r3, [r7, #GLINT_AT_TRIANGLE_NLY]
    cmp r0, #GLINT_SHINE_MATT
    beq .Lfar
    ldr r1, [r1, #T_OF]
    lsrs r1, r1, #2
    ldr r2, [r4, #T_OF]
    lsrs r2, r2, #1
    adds r1, r1, r2
    ldr r2, [r5, #T_OF]
    lsrs r2, r2, #2
    adds r1, r1, r2
    movs r0, #GLINT_SHINE_MATT + 1
    b .Lt_stays
    .ltorg

.Lt: /* It is matt, too, where mesh_triangle.c's t_stays_beyond says so. */
    ldr r7, [sp, #BEYOND]
    cmp r7, #0
    ble .Lt_set
    ldr r6, [sp, #E]
    adds r6, #18 - GLINT_MESH_GENTLE
    bmi .Lt_set
    mov r6, sp
    ldmia r6!, {r3-r5}
    ldr r3, [r3, #T_OF]
    ldr r4, [r4, #T_OF]
    ldr r5, [r5, #T_OF]
    add r6, sp, #SIDES
    ldmia r6!, {r0-r2}
    /* r6: the least t; r4, r5: the others; r2, r1: the sides to these. */
    cmp r3, r4
    bhi 2f
    movs r6, r3
    cmp r3, r5
    bls 3f
1:  movs r6, r5
    movs r5, r3
    movs r2, r0
    b 3f
2:  cmp r4, r5
    bhi 1b
    movs r6, r4
    movs r4, r3
    movs r1, r0
3:  subs r6, r6, r7
    lsls r2, r2, #1
    subs r4, r4, r2
    subs r4, r4, r6
    cmp r4, #0
    ble .Lt_set
    lsls r1, r1, #1
    subs r5, r5, r1
    subs r5, r5, r6
    cmp r5, #0
    ble .Lt_set
    ldr r7, [sp, #TRIANGLE]
    movs r0, #GLINT_SHINE_MATT
    b .Lfar
.Lt_set:
    mov r7, sp
    ldmia r7!, {r0-r2}
    ldr r0, [r0, #T_OF]
    lsrs r0, r0, #1
    ldr r1, [r1, #T_OF]
    lsrs r1, r1, #1
    subs r1, r1, r0
    ldr r2, [r2, #T_OF]
    lsrs r2, r2, #1
    subs r2, r2, r0
    add r7, sp, #SIDES
    ldmia r7!, {r3-r5} /* rr, qq, pp */
    subs r1, r1, r5
    mov r12, r1 /* dp */
    subs r2, r2, r4
    mov lr, r2 /* dq */
    adds r6, r5, r4
    subs r3, r6, r3
    lsls r4, r4, #1
    lsls r5, r5, #1
    size_of r6, r3
    orrs r6, r4
    orrs r6, r5
    lsrs r6, r6, #15
    count_bits r0, r6, r1
    asrs r3, r0 /* B */
    asrs r4, r0 /* C */
    asrs r5, r0 /* A */
    subs r7, #12
    stmia r7!, {r3-r5}
    str r0, [sp, #DOWN]
    ldr r6, [sp, #E]
    adds r6, #18 - 2
    subs r6, r6, r0
    add r7, sp, #SLOPES
    ldmia r7!, {r1, r2} /* u, v */
    movs r0, r5
    muls r0, r1
    movs r7, r3
    muls r7, r2
    adds r0, r0, r7
    muls r3, r1
    muls r4, r2
    adds r3, r3, r4
    shift_to_nearest r6, r0, r3
    mov r4, r12
    mov r5, lr
    adds r0, r0, r4
    adds r3, r3, r5
    mov r12, r0 /* dp_here */
    mov lr, r3 /* dq_here */
    asrs r0, r0, #1
    asrs r4, r4, #1
    adds r4, r4, r0
    asrs r3, r3, #1
    asrs r5, r5, #1
    adds r5, r5, r3
    pair_of r4, r5, r3, r0, r6
    muls r4, r1
    muls r5, r2
    adds r4, r4, r5
    ldr r6, [sp, #E]
    adds r6, #18 - 3
    subs r6, r6, r3
    shift_to_nearest r6, r4
    ldr r0, [sp, #VERTICES]
    ldr r0, [r0, #T_OF]
    adds r0, r0, r4
    ldr r7, [sp, #TRIANGLE]
    str r0, [r7, #GLINT_AT_TRIANGLE_T]

    mov r0, r12
    mov r1, lr
    pair_of r0, r1, r2, r3, r4
    add r3, sp, #UX
    ldmia r3!, {r4-r7}
    ldr r3, [r3]
    adds r3, #18 - 2
    subs r3, r3, r2
    muls r4, r0
    muls r5, r1
    adds r4, r4, r5
    muls r6, r0
    muls r7, r1
    adds r6, r6, r7
    shift_to_nearest r3, r4, r6
    mov r12, r4 /* tx, without half of txx */
    mov lr, r6 /* ty, without half of tyy */

/* r6, r7: how D.P and D.Q change, as a pair, from ux and vx or uy and vy to r4, r5; r0: 2 e - down - shift - 2. */
.macro change_of slopes
    ldr r4, [sp, #\slopes]
    ldr r5, [sp, #\slopes + 4]
    add r3, sp, #SIDES
    ldmia r3!, {r0-r2} /* B, C, A */
    movs r6, r2
    muls r6, r4
    movs r7, r0
    muls r7, r5
    adds r6, r6, r7
    muls r0, r4
    muls r1, r5
    adds r7, r0, r1
    pair_of r6, r7, r1, r0, r2
    ldr r0, [sp, #E]
    adds r0, #18 - 1
    lsls r0, r0, #1
    ldr r2, [sp, #DOWN]
    subs r0, r0, r2
    subs r0, r0, r1
.endm
    change_of UX
    muls r4, r6
    muls r5, r7
    adds r4, r4, r5
    add r3, sp, #UY
    ldmia r3!, {r1, r2}
    muls r1, r6
    muls r2, r7
    adds r1, r1, r2
    shift_to_nearest r0, r4, r1
    lsrs r0, r4, #1
    add r12, r0
    ldr r7, [sp, #TRIANGLE]
    str r4, [r7, #GLINT_AT_TRIANGLE_TXX]
    str r1, [r7, #GLINT_AT_TRIANGLE_TXY]
    mov r0, r12
    str r0, [r7, #GLINT_AT_TRIANGLE_TX]
    change_of UY
    muls r4, r6
    muls r5, r7
    adds r4, r4, r5
    shift_to_nearest r0, r4
    lsrs r0, r4, #1
    add r0, lr
    ldr r7, [sp, #TRIANGLE]
    str r0, [r7, #GLINT_AT_TRIANGLE_TY]
    str r4, [r7, #GLINT_AT_TRIANGLE_TYY]
    movs r0, #GLINT_SHINE_MATT + 1
    adds r7, #GLINT_AT_TRIANGLE_SHINE
    b .Lset
#endif
