/* SPDX-License-Identifier: MIT
 * glint_mesh_hide_face(target, face), as mesh_cells.c has hide of a whole strip where the outlines that it asks are kept; it leaves no register as it was.
 * glint_mesh_rim_set(rim, drawn, face, corner, window), as mesh_edges.c has it. And glint_mesh_blend_matt(blend), as mesh_cells.c has it. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"
#include "cortex_m0plus_numbers.inc"

#define RIM_FLAT 1 /* as in glint_mesh_edges.h */
#define RIM_GROWS 2
#define RIM_TURNED 4
#define RIM_ENDS_LOG 4

/* ---- Cells that a face leaves out ---- */

/* The frame. */
#define LINE_BYTES 0
#define DEPTHS 4 /* where they are kept, and the end of the room */
#define FULL 8
#define BETWEEN 12 /* the ends of the edge beside a neighbour; 0: the face's own outlines */
#define EDGES_AT 20
#define RIMS_AT 24
#define KEPT_RIMS 28
#define VERTICES_AT 32
#define OTHERS 36 /* the face's neighbours and corners: what is left of them */
#define CORNERS_AT 40
#define FACE_COUNT 44
#define FIRST_CORNER 48
#define NUMBER 52
#define ALL_KEPT 56 /* 1: no outlines of the strip are not kept */
#define HIDE_FRAME 60 /* and a return address */

#define e r0
#define depth r2
#define kept r7
#define along r8 /* bytes */
#define step r9
#define rim r10
#define limit r11
#define end r12

/* Cells up to the end; r3: across, in bytes, r6: 0. skip: where e is not a cell whose middle is inside. */
.macro hide_cells skip
1:  lsls r4, e, #16
    cmp r4, limit
    \skip 2f
    asrs r4, e, #16
    muls r4, r3
    adds r4, r4, depth
    ldrh r5, [r4]
    strh r6, [r4]
    stmia kept!, {r4, r5}
2:  add e, step
    add depth, along
    cmp depth, end
    bne 1b
.endm

/* edges: of a face that is not listed, in the upper byte: it may have outlines that are not kept. */
.macro unkept edges
    lsls \edges, \edges, #5
    beq 9f
    ldr r5, [sp, #ALL_KEPT]
    cmp r5, #0
    beq .Lno_room
9:
.endm

    function glint_mesh_hide_face
    push {lr}
    sub sp, #HIDE_FRAME
    ldr r2, [r0, #GLINT_AT_TARGET_FRAME + 4]
    ldr r3, [r2, #GLINT_AT_DRAWN_OUTLINES]
    ldr r4, =GLINT_AT_OUTLINES_REST
    adds kept, r3, r4
    ldrh r5, [kept]
    adds r5, #1
    lsrs r5, r5, #16
    str r5, [sp, #ALL_KEPT]
    adds kept, #GLINT_AT_OUTLINES_DEPTHS - GLINT_AT_OUTLINES_REST
    str kept, [sp, #DEPTHS]
    ldr r5, =GLINT_MESH_HIDDEN * 8
    adds r5, r5, kept
    str r5, [sp, #FULL]
    str r3, [sp, #KEPT_RIMS]
    ldr r5, [r0, #8]
    lsls r5, r5, #1
    str r5, [sp, #LINE_BYTES]
    ldr r6, [r2, #GLINT_AT_DRAWN_EDGES]
    str r6, [sp, #EDGES_AT]
    ldr r5, [r2, #GLINT_AT_DRAWN_OUTLINES + 4]
    str r5, [sp, #RIMS_AT]
    ldr r5, [r2, #GLINT_AT_DRAWN_VERTICES]
    str r5, [sp, #VERTICES_AT]
    ldrb r6, [r6, r1]
    ldr r4, [r2, #GLINT_AT_DRAWN_MESH]
    ldrh r3, [r4, #GLINT_AT_MESH_VERTEX_COUNT + 2]
    str r3, [sp, #FACE_COUNT]
    movs r3, #6
    muls r3, r1
    ldr r5, [r4, #GLINT_AT_MESH_FACES]
    adds r5, r5, r3
    str r5, [sp, #CORNERS_AT]
    ldr r5, [r4, #GLINT_AT_MESH_NEIGHBOURS]
    adds r5, r5, r3
    str r5, [sp, #OTHERS]
    lsls r3, r6, #31 - 3
    asrs r3, r3, #31 /* BESIDE */
    movs r5, #3
    ands r3, r5
    str r3, [sp, #NUMBER]
    movs r3, #0
    str r3, [sp, #BETWEEN]
    lsls r6, r6, #24
    bpl 1f
    bl .Lrims
    b .Lneighbour
1:  unkept r6
.Lneighbour:
    ldr r3, [sp, #NUMBER]
    subs r3, #1
    bmi .Lhidden
    str r3, [sp, #NUMBER]
    lsls r2, r3, #1
    ldr r1, [sp, #OTHERS]
    ldrh r1, [r1, r2]
    ldr r4, [sp, #FACE_COUNT]
    cmp r1, r4
    bhs .Lneighbour
    ldr r4, [sp, #EDGES_AT]
    ldrb r4, [r4, r1]
    lsls r4, r4, #24
    bmi 1f
    unkept r4
    b .Lneighbour
1:  ldr r5, [sp, #CORNERS_AT]
    ldrh r6, [r5, r2]
    adds r2, #2
    cmp r3, #2
    bne 1f
    movs r2, #0
1:  ldrh r5, [r5, r2]
    ldr r4, [sp, #VERTICES_AT]
    lsls r6, r6, #4
    lsls r5, r5, #4
    adds r6, r6, r4
    adds r5, r5, r4
    str r6, [sp, #BETWEEN]
    str r5, [sp, #BETWEEN + 4]
    bl .Lrims
    b .Lneighbour

.Lhidden:
    ldr r3, [sp, #DEPTHS]
    subs r4, kept, r3
    lsrs r4, r4, #3
    subs r3, #2
    strh r4, [r3]
    movs r0, #1
    b 2f
.Lno_room:
    ldr r3, [sp, #DEPTHS]
    b 1f
0:  subs kept, #8
    ldr r4, [kept]
    ldr r5, [kept, #4]
    strh r5, [r4]
1:  cmp kept, r3
    bne 0b
    movs r0, #0
2:  add sp, #HIDE_FRAME
    pop {pc}

/* Those of face r1. */
.Lrims:
    ldr r4, [sp, #RIMS_AT]
    lsls r1, r1, #1
    ldrh r4, [r4, r1]
    movs r1, #GLINT_MESH_RIM_BYTES
    muls r4, r1
    ldr r1, [sp, #KEPT_RIMS]
    adds r4, r4, r1
.Lrim:
    ldmia r4!, {e, r1, depth}
    mov step, r1
    mov rim, r4
    ldr r3, [r4]
    sxth r6, r3      /* at */
    asrs r3, r3, #16 /* its end */
    ldrb r5, [r4, #4]
    ldr r4, [sp, #LINE_BYTES]
    movs r1, #2
    lsls r5, r5, #31 /* flat */
    bmi 1f
    mov along, r4
    mov limit, r1 /* across */
    b 2f
1:  mov along, r1
    mov limit, r4
2:  ldr r4, [sp, #BETWEEN]
    cmp r4, #0
    beq 5f
    ldr r1, [sp, #BETWEEN + 4]
    cmp r5, #0
    bne 3f
    adds r4, #2
    adds r1, #2
3:  ldrh r4, [r4]
    sxth r4, r4
    ldrh r1, [r1]
    sxth r1, r1
    cmp r4, r1
    ble 4f
    movs r5, r4
    movs r4, r1
    movs r1, r5
4:  asrs r4, r4, #4
    subs r4, #1
    asrs r1, r1, #4
    adds r1, #2
    cmp r3, r1
    ble 4f
    movs r3, r1
4:  subs r1, r4, r6
    ble 5f
    movs r6, r4
    mov r5, step
    muls r5, r1
    adds e, e, r5
    mov r5, along
    muls r5, r1
    adds depth, depth, r5
5:  subs r3, r3, r6
    ble .Lrim_next
    lsls r4, r3, #3
    adds r4, r4, kept
    ldr r5, [sp, #FULL]
    cmp r4, r5
    bhi .Lno_room
    mov r4, along
    muls r4, r3
    adds r4, r4, depth
    mov end, r4
    mov r3, limit
    mov r4, rim
    ldrb r4, [r4, #4]
    movs r6, #0
    lsls r4, r4, #30 /* grows */
    bpl .Lleft
    movs r4, #256 - GLINT_CELL_LEFT_OUT
    lsls r4, r4, #24
    mov limit, r4
    hide_cells bhs
.Lrim_next:
    mov r4, rim
    ldrb r5, [r4, #4]
    adds r4, #GLINT_MESH_RIM_BYTES - 12
    lsls r5, r5, #28 /* more */
    bmi .Lrim
    bx lr
.Lleft:
    movs r4, #GLINT_CELL_LEFT_OUT
    lsls r4, r4, #24
    mov limit, r4
    hide_cells blo
    b .Lrim_next
    .ltorg

#undef e
#undef depth
#undef kept
#undef along
#undef step
#undef rim
#undef limit
#undef end

/* ---- An outline ----
 * r0: the rim; r6, r7: its upper corner and the lower one: along it in the lower half, across it in the upper one; r5: the window's least and,
 * 8 behind it, the end across it. */
    function glint_mesh_rim_set
    push {r4-r7, lr}
    strb r3, [r0, #GLINT_AT_RIM_IS + 1]
    strh r2, [r0, #GLINT_AT_RIM_IS + 2]
    lsls r5, r2, #1
    adds r5, r5, r2
    adds r5, r5, r3
    lsls r5, r5, #1
    ldr r4, [r1, #GLINT_AT_DRAWN_MESH]
    ldr r4, [r4, #GLINT_AT_MESH_FACES]
    ldrh r6, [r4, r5]
    cmp r3, #2
    bne 1f
    subs r5, #6
1:  adds r5, #2
    ldrh r7, [r4, r5]
    ldr r4, [r1, #GLINT_AT_DRAWN_VERTICES]
    lsls r6, r6, #4
    lsls r7, r7, #4
    ldr r6, [r4, r6]
    ldr r7, [r4, r7]
    asrs r1, r6, #16 /* does it end above the window's bottom? */
    asrs r2, r7, #16
    cmp r1, r2
    bge 1f
    movs r1, r2
1:  ldr r5, [sp, #20]
    ldr r2, [r5, #12]
    lsls r2, r2, #4
    adds r1, #1
    subs r1, r1, r2
    lsrs r1, r1, #31
    lsls r1, r1, #RIM_ENDS_LOG
    mov r12, r1
    sxth r1, r7
    sxth r2, r6
    subs r1, r1, r2 /* dx */
    asrs r2, r7, #16
    asrs r3, r6, #16
    subs r2, r2, r3 /* dy */
    asrs r3, r1, #31
    movs r4, r1
    eors r4, r3
    subs r4, r4, r3
    asrs r3, r2, #31
    movs r5, r2
    eors r5, r3
    subs r5, r5, r3
    cmp r5, r4
    ldr r5, [sp, #20]
    blt 1f
    movs r3, #16
    rors r6, r3
    rors r7, r3
    movs r1, r2
    movs r3, #RIM_GROWS
    ldr r2, [r5, #4]
    ldr r4, [r5, #12]
    b 2f
1:  movs r3, #RIM_FLAT
    ldr r2, [r5]
    ldr r4, [r5, #8]
    adds r5, #4
2:  cmp r1, #0
    bge 3f
    movs r1, r6
    movs r6, r7
    movs r7, r1
    movs r1, #RIM_TURNED + RIM_GROWS
    eors r3, r1
3:  mov r1, r12
    orrs r3, r1
    strb r3, [r0, #GLINT_AT_RIM_IS]
    sxth r1, r6
    adds r1, #7
    asrs r1, r1, #4 /* first */
    sxth r3, r7
    adds r3, #7
    asrs r3, r3, #4
    cmp r2, r1
    bge 1f
    movs r2, r1
1:  cmp r4, r3
    ble 1f
    movs r4, r3
1:  cmp r2, r4
    bge .Lno_cell
    strh r2, [r0, #GLINT_AT_RIM_AT]
    strh r4, [r0, #GLINT_AT_RIM_AT + 2]
    mov r12, r1
    asrs r1, r6, #16
    asrs r3, r7, #16
    cmp r1, r3
    ble 1f
    movs r2, r1
    movs r1, r3
    movs r3, r2
1:  ldr r2, [r5, #8]
    lsls r2, r2, #4
    subs r1, #1
    cmp r1, r2
    bge .Lno_cell
    ldr r2, [r5]
    lsls r2, r2, #4
    adds r3, #1
    cmp r3, r2
    blt .Lno_cell
    sxth r1, r6
    sxth r3, r7
    subs r3, r3, r1 /* the length, 15 bits */
    mov r4, r12
    lsls r4, r4, #4
    adds r4, #8
    subs r4, r4, r1 /* from the corner to the first middle */
    asrs r1, r6, #16
    asrs r2, r7, #16
    subs r2, r2, r1
    stmia r0!, {r1, r2}
    movs r6, #14 /* 31 - zeros(length) */
    lsls r3, r3, #17
    up_by_15 r3, r6, r7
    inverse_of r3, r1, r2, r7
    str r3, [r0, #GLINT_MESH_RIM_BYTES - 12]
    movs r7, #31
    subs r7, r7, r6
    strb r7, [r0, #GLINT_MESH_RIM_BYTES - 9]
    subs r0, #8
    ldmia r0!, {r1, r2}
    muls r2, r3
    asrs r2, r6 /* the step */
    asrs r3, r2, #4
    muls r3, r4
    lsls r1, r1, #12
    adds r1, r1, r3
    subs r0, #8
    movs r4, #GLINT_AT_RIM_AT
    ldrsh r4, [r0, r4]
    movs r6, #GLINT_AT_RIM_AT + 2
    ldrsh r6, [r0, r6]
    mov r3, r12
    subs r3, r4, r3
    muls r3, r2
    adds r1, r1, r3 /* e */
    subs r3, r6, r4
    subs r3, #1
    muls r3, r2
    adds r3, r3, r1
    mov r12, r3 /* e of the last one */
    ldr r7, [r5, #8]
    ldr r5, [r5]
    subs r7, r7, r5 /* room */
1:  asrs r3, r1, #16
    subs r3, r3, r5
    cmp r3, r7
    blo 2f
    adds r1, r1, r2
    adds r4, #1
    cmp r4, r6
    blt 1b
.Lno_cell:
    movs r0, #0
    pop {r4-r7, pc}
2:  stmia r0!, {r1, r2}
    mov r1, r12
1:  asrs r3, r1, #16
    subs r3, r3, r5
    cmp r3, r7
    blo 2f
    subs r1, r1, r2
    subs r6, #1
    cmp r4, r6
    blt 1b
    b .Lno_cell
2:  strh r4, [r0, #GLINT_AT_RIM_AT - 8]
    strh r6, [r0, #GLINT_AT_RIM_AT - 6]
    movs r0, #1
    pop {r4-r7, pc}
    .ltorg

/* ---- Cells that are blended ---- */

/* The frame: what struct glint_mesh_blend has from end on, and more. */
#define END 0
#define OFF 4 /* what a pixel is beyond its depth */
#define COLOURS 8
#define DARK 12
#define GROWS 16 /* 255, or 0 */
#define OUT 20
#define GREEN 24
#define BLEND_FRAME 28

#define e r0
#define z r1
#define line r2
#define nl r8
#define across r9
#define step r10
#define dz r11
#define dnl r12
#define along lr

.macro blend_cells
1:  asrs r7, e, #16
    mov r4, across
    muls r7, r4
    adds r7, r7, line
    ldrh r4, [r7]
    lsrs r5, z, #16
    cmp r5, r4
    blo 3f
2:  add e, step
    add z, dz
    add nl, dnl
    add line, along
    ldr r3, [sp, #END]
    cmp line, r3
    bne 1b
    leave BLEND_FRAME
3:  lsls r4, e, #16 /* the part */
    lsrs r4, r4, #24
    ldr r5, [sp, #GROWS]
    eors r4, r5
    ldr r6, [sp, #OFF]
    adds r7, r7, r6
    str r7, [sp, #OUT]
    ldrh r6, [r7]
    mov r5, nl
    asrs r5, r5, #GLINT_COLOUR_ROW_SHIFT
    bmi 5f
    lsls r5, r5, #GLINT_COLOUR_ROW_BYTES_LOG
    ldr r3, [sp, #COLOURS]
    ldrh r5, [r3, r5]
4:
.endm

/* r5 over r6: green, then red and blue in one word. q + m (p - q), times 255. */
.macro blend_mixed
    lsls r3, r5, #21
    lsrs r3, r3, #26
    lsls r7, r6, #21
    lsrs r7, r7, #26
    subs r3, r3, r7
    muls r3, r4
    subs r3, r3, r7
    lsls r7, r7, #8
    adds r3, r3, r7
    adds r3, #128
    lsrs r7, r3, #8
    adds r3, r3, r7
    lsrs r3, r3, #8
    str r3, [sp, #GREEN]
    lsls r3, r5, #5
    orrs r3, r5
    lsls r5, r6, #5
    orrs r5, r6
    ldr r6, =0x001f001f
    ands r3, r6
    ands r5, r6
    subs r3, r3, r5
    muls r3, r4
    subs r3, r3, r5
    lsls r5, r5, #8
    adds r3, r3, r5
    ldr r5, =0x00800080
    adds r3, r3, r5
    lsrs r5, r3, #8
    ands r5, r6 /* a field is below 32 2^8 */
    adds r3, r3, r5
    lsrs r3, r3, #8
    ands r3, r6
    lsrs r5, r3, #5
    orrs r3, r5
    ldr r5, [sp, #GREEN]
    lsls r5, r5, #5
    orrs r3, r5
.endm

.macro blend_put
    ldr r7, [sp, #OUT]
    strh r3, [r7]
    b 2b
5:  ldr r5, [sp, #DARK]
    b 4b
.endm

    function glint_mesh_blend_matt
    enter BLEND_FRAME
    ldmia r0!, {r1-r7} /* is_swapped, nl, across, step, dz, dnl, along */
    mov nl, r2
    mov across, r3
    mov step, r4
    mov dz, r5
    mov dnl, r6
    mov along, r7
    ldmia r0!, {r3-r7}
    mov r2, sp
    stmia r2!, {r3-r7}
    movs r3, r1
    ldmia r0!, {z, line, r4}
    movs e, r4
    cmp r3, #0
    bne .Lswapped
    blend_cells
    blend_mixed
    blend_put
    .ltorg
.Lswapped:
    blend_cells
    rev16 r5, r5
    rev16 r6, r6
    blend_mixed
    rev16 r3, r3
    blend_put
    .ltorg
#endif
