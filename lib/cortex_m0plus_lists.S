/* SPDX-License-Identifier: MIT
 * glint_mesh_sort_faces(frame, drawn, y), as mesh_lists.c has it: from the last face to the first. Half of them show their backs, which
 * is known as soon as the corners are loaded. And glint_mesh_clear(depth, bytes), as mesh_strip.c has it. */
#if defined GLINT_CORTEX_M0PLUS_ASM && GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"
#include "glint_mesh_offsets.h"

#define face r0
#define number r7
#define vertices r8
#define from r9 /* y */
#define height r10
#define bands r11
#define links r12
#define is_cut lr

    function glint_mesh_sort_faces
    enter 0
    mov from, r2
    ldrh r3, [r0, #GLINT_AT_FRAME_W + 2]
    mov height, r3
    ldr r4, [r1, #GLINT_AT_DRAWN_VERTICES]
    mov vertices, r4
    ldr r5, [r1, #GLINT_AT_DRAWN_LINKS]
    mov links, r5
    ldr r6, [r1, #GLINT_AT_DRAWN_LINKS + 4]
    mov bands, r6
    movs r5, r1
    adds r5, #GLINT_AT_DRAWN_IS_CUT
    ldrb r5, [r5]
    mov is_cut, r5
    ldr r1, [r1, #GLINT_AT_DRAWN_MESH]
    ldrh number, [r1, #GLINT_AT_MESH_VERTEX_COUNT + 2]
    ldr face, [r1, #GLINT_AT_MESH_FACES]
    movs r2, #6
    muls r2, number
    adds face, face, r2

.Lface:
    subs number, #1
    bmi .Lsorted
    subs face, #6
    ldrh r1, [face]
    ldrh r2, [face, #2]
    ldrh r3, [face, #4]
    lsls r1, r1, #4
    lsls r2, r2, #4
    lsls r3, r3, #4
    add r1, vertices
    add r2, vertices
    add r3, vertices
    mov r5, is_cut
    cmp r5, #0
    bne .Lmay_be_out
.Lin: /* r5: 0 */
    ldrsh r4, [r2, r5]
    ldrsh r6, [r3, r5]
    ldrsh r5, [r1, r5]
    subs r4, r4, r5 /* x1 */
    subs r5, r6, r5 /* x2 */
    movs r6, #2
    ldrsh r1, [r1, r6]
    ldrsh r2, [r2, r6]
    ldrsh r3, [r3, r6]
    subs r6, r3, r1
    muls r4, r6
    subs r6, r2, r1
    muls r5, r6
    subs r4, r4, r5 /* the area */
    bge .Lface
    cmp r1, r2 /* r1: the least y, r2: the greatest */
    ble 1f
    movs r4, r1
    movs r1, r2
    movs r2, r4
1:  cmp r3, r1
    bge 1f
    movs r1, r3
1:  cmp r3, r2
    ble 1f
    movs r2, r3
1:  adds r1, #7
    asrs r1, r1, #4
    adds r2, #7
    asrs r2, r2, #4
    cmp r1, from
    bge 1f
    mov r1, from
1:  cmp r1, r2
    bge .Lface
    cmp r1, height
    bge .Lface
.Lband:
    lsrs r1, r1, #GLINT_MESH_BAND_LOG
    lsls r1, r1, #1
    add r1, bands
    ldrh r2, [r1]
    strh number, [r1]
    lsls r3, number, #1
    add r3, links
    strh r2, [r3]
    b .Lface

.Lmay_be_out:
    ldrh r4, [r1, #6]
    ldrh r5, [r2, #6]
    ldrh r6, [r3, #6]
    orrs r5, r4
    orrs r5, r6
    beq .Lin
    /* Seen once it is clipped, unless one plane cuts all of it. */
    ldrh r5, [r2, #6]
    ands r4, r5
    tst r4, r6
    bne .Lface
    mov r1, from
    b .Lband
.Lsorted:
    leave 0

/* 112 bytes at a time, then 4. */
    function glint_mesh_clear
    push {r4-r7, lr}
    movs r2, #0
    mvns r2, r2
    movs r3, r2
    movs r4, r2
    movs r5, r2
    movs r6, r2
    movs r7, r2
    subs r1, #112
    blo 2f
1:  stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r7}
    stmia r0!, {r2-r5}
    subs r1, #112
    bhs 1b
2:  adds r1, #112
    beq 4f
3:  stmia r0!, {r2}
    subs r1, #4
    bne 3b
4:  pop {r4-r7, pc}
#endif
