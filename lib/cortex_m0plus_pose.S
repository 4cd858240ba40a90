/* SPDX-License-Identifier: MIT
 * Vertices without perspective, with normals of 8 bits, as mesh_pose.c has them. What is the same
 * for all vertices lies in the frame in the order in which it is read, so that three words take one load. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"
#include "glint_offsets.h"

/* The frame: halfwords of the mesh drawn, as words; then 8 times the width and height, and where to go on and end. */
#define LIGHT 0 /* l, then h */
#define TURN 24
#define POSITION 60
#define ACROSS 72
#define DOWN 76
#define PLACES 80
#define END 84
#define ANY 88 /* is there one that is out? */
#define FRAME 92

#define vertex r0
#define first_down r8 /* a sum is shifted, multiplied by the scale, and shifted again */
#define then_down r9
#define scale r10
#define guard r11
#define guards r12 /* twice */
#define normals lr

/* r4: the next row of the turn, at r7, times r1-r3, scaled; half a unit or more of what is shifted out is the carry, so that adcs rounds to
 * nearest. */
.macro turned
    ldmia r7!, {r4-r6}
    muls r4, r1
    muls r5, r2
    adds r4, r4, r5
    muls r6, r3
    adds r4, r4, r6
    mov r5, first_down
    asrs r4, r5
    mov r5, scale
    muls r4, r5
    mov r5, then_down
    asrs r4, r5
.endm

/* To the screen's corner, or away to where its plane is noted. */
.macro placed add, field, beyond
    mov r5, guard
    adds r5, r4, r5
    cmp r5, guards
    bhi \beyond
\beyond\()_noted:
    ldr r5, [sp, #\add]
    adds r4, r4, r5
    strh r4, [vertex, #\field]
.endm

/* The bit if it is below 0, and twice that if it is above. */
.macro noted bit, beyond
\beyond:
    movs r5, #\bit
    cmp r4, #0
    blt 1f
    lsls r5, r5, #1
1:  ldrh r6, [vertex, #6]
    orrs r6, r5
    strh r6, [vertex, #6]
    movs r5, #1
    str r5, [sp, #ANY]
    b \beyond\()_noted
.endm

    function glint_mesh_vertices_parallel
    enter FRAME
    mov r7, sp
    movs r2, #GLINT_AT_DRAWN_LIGHT
1:  ldrsh r3, [r1, r2]
    stmia r7!, {r3}
    adds r2, #2
    cmp r2, #GLINT_AT_DRAWN_SCALE
    bne 1b
    add r7, sp, #TURN + 12 /* y is down */
    ldmia r7!, {r3-r5}
    negs r3, r3
    negs r4, r4
    negs r5, r5
    subs r7, #12
    stmia r7!, {r3-r5}
    add r7, sp, #ACROSS
    ldrh r3, [r0, #GLINT_AT_FRAME_W]
    lsls r3, r3, #3
    ldrh r4, [r0, #GLINT_AT_FRAME_W + 2]
    lsls r4, r4, #3
    ldr r2, [r1, #GLINT_AT_DRAWN_MESH]
    ldr r5, [r2, #GLINT_AT_MESH_PLACES]
    stmia r7!, {r3-r5}
    ldr r6, [r2, #GLINT_AT_MESH_NORMALS8]
    mov normals, r6
    ldr vertex, [r1, #GLINT_AT_DRAWN_VERTICES]
    ldrh r3, [r2, #GLINT_AT_MESH_VERTEX_COUNT]
    lsls r3, r3, #4
    adds r3, r3, vertex
    str r3, [r7]
    movs r3, #0
    str r3, [sp, #ANY]
    ldrh r3, [r1, #GLINT_AT_DRAWN_SCALE]
    mov scale, r3
    movs r4, #14
    movs r5, #15
    lsrs r3, r3, #14
    beq 1f
    movs r4, #16
    movs r5, #13
1:  mov first_down, r4
    mov then_down, r5
    ldr r3, =GLINT_MESH_GUARD
    mov guard, r3
    lsls r3, r3, #1
    mov guards, r3
    b .Lvertices_test

.Lvertices:
    movs r5, #0
    strh r5, [vertex, #6]
    ldr r6, [sp, #PLACES]
    ldrsh r1, [r6, r5]
    movs r5, #2
    ldrsh r2, [r6, r5]
    movs r5, #4
    ldrsh r3, [r6, r5]
    adds r6, #6
    str r6, [sp, #PLACES]
    add r7, sp, #TURN
    turned
    ldr r5, [sp, #POSITION]
    adcs r4, r5
    placed ACROSS, 0, .Lbeside
    turned
    ldr r5, [sp, #POSITION + 4]
    adcs r4, r5
    placed DOWN, 2, .Labove
    turned
    ldr r5, [sp, #POSITION + 8]
    adcs r4, r5
    ldr r5, =32767
    subs r4, r5, r4
    lsls r5, r5, #1
    cmp r4, r5
    bhi .Ldeep
.Ldeep_held:
    strh r4, [vertex, #4]
    mov r1, normals
    movs r5, #0
    ldrsb r2, [r1, r5]
    movs r5, #1
    ldrsb r3, [r1, r5]
    movs r5, #2
    ldrsb r4, [r1, r5]
    adds r1, #3
    mov normals, r1
    ldr r5, =258
    muls r2, r5
    muls r3, r5
    muls r4, r5
    mov r7, sp
    ldmia r7!, {r1, r5, r6}
    muls r1, r2
    muls r5, r3
    muls r6, r4
    adds r6, r6, r5
    adds r6, r6, r1
    str r6, [vertex, #12]
    ldmia r7!, {r1, r5, r6}
    subs r1, r2, r1
    muls r1, r1
    lsrs r1, r1, #1
    subs r5, r3, r5
    muls r5, r5
    lsrs r5, r5, #1
    subs r6, r4, r6
    muls r6, r6
    lsrs r6, r6, #1
    adds r1, r1, r5
    adds r1, r1, r6
    str r1, [vertex, #8]
    adds vertex, #16
.Lvertices_test:
    ldr r5, [sp, #END]
    cmp vertex, r5
    bne .Lvertices
    ldr r0, [sp, #ANY]
    leave FRAME

    noted 1, .Lbeside
    noted 4, .Labove
.Ldeep: /* to 0..65534 */
    cmp r4, #0
    blt 1f
    movs r4, r5
    b .Ldeep_held
1:  movs r4, #0
    b .Ldeep_held
    .ltorg
#endif
