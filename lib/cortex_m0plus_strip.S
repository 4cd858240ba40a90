/* SPDX-License-Identifier: MIT
 * glint_mesh_strip_lines(strip): what mesh_strip.c does with a mesh, new faces and kept triangles by number. Its state is in the frame, since
 * the routine that draws a triangle's lines, void (*draw)(void), leaves no register as it was; it uses the frame, too.
 * And what comes before it: glint_mesh_sort_faces, glint_mesh_clear. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"

#define NONE GLINT_MESH_NONE

/* The frame: a struct glint_mesh_lines first. */
#define DRAW GLINT_AT_LINES_DRAW
#define T_END (GLINT_MESH_LINES_BYTES + 0) /* of the part at hand; the face it ends before; its number */
#define FACES_END (GLINT_MESH_LINES_BYTES + 4)
#define NUMBER (GLINT_MESH_LINES_BYTES + 8)
#define FRAME_AT (GLINT_MESH_LINES_BYTES + 12)
#define DRAWN_AT (GLINT_MESH_LINES_BYTES + 16)
#define TARGET_AT (GLINT_MESH_LINES_BYTES + 20)
#define Y_OF_STRIP (GLINT_MESH_LINES_BYTES + 24)
#define END_OF_STRIP (GLINT_MESH_LINES_BYTES + 28)
#define KEPT_AT (GLINT_MESH_LINES_BYTES + 32)
#define LINKS_AT (GLINT_MESH_LINES_BYTES + 36)
#define FACES_AT (GLINT_MESH_LINES_BYTES + 40)
#define NEW_FACE (GLINT_MESH_LINES_BYTES + 44) /* the first of those not kept */
#define KEPT_FACE (GLINT_MESH_LINES_BYTES + 48) /* and of those kept, and its place */
#define KEPT_PLACE (GLINT_MESH_LINES_BYTES + 52)
#define KEPT_BYTES (GLINT_MESH_LINES_BYTES + 56) /* of a place */
#define TRIANGLE_NOW (GLINT_MESH_LINES_BYTES + 60) /* the triangle in work, and the place of that */
#define PLACE (GLINT_MESH_LINES_BYTES + 64)
#define KEEP (GLINT_MESH_LINES_BYTES + 68) /* lists, and their ends */
#define LATER (GLINT_MESH_LINES_BYTES + 72)
#define KEEP_LAST (GLINT_MESH_LINES_BYTES + 76)
#define LATER_LAST (GLINT_MESH_LINES_BYTES + 80)
#define INNER GLINT_AT_STRIP_INNER /* where there are outlines, what draws a triangle's lines; and where that returns to */
#define RETURN (GLINT_AT_STRIP_INNER + 4)
#define STRIP_FRAME (GLINT_AT_STRIP_INNER + 8)
#if INNER != LATER_LAST + 4
#error "GLINT_AT_STRIP_INNER"
#endif

/* to: the triangle of place r4. */
.macro place_at to, free
    ldr \to, [sp, #KEPT_BYTES]
    muls \to, r4
    ldr \free, [sp, #KEPT_AT]
    adds \to, \to, \free
.endm

/* Notes the kept triangle in place r4 as the next one. */
.macro kept_is_next
    str r4, [sp, #KEPT_PLACE]
    ldr r0, =NONE
    cmp r4, r0
    beq 1f
    place_at r0, r1
    adds r0, #GLINT_AT_KEPT_FACE
    ldrh r0, [r0]
1:  str r0, [sp, #KEPT_FACE]
.endm

/* The triangle in r0, which is TRIANGLE_NOW, if it begins in the strip, r2: its line; else to `below`. Then flags: its end to the strip's. */
.macro draw_here below
    ldr r3, [sp, #END_OF_STRIP]
    cmp r2, r3
    bge \below
    ldr r3, [sp, #DRAW]
    blx r3
    ldr r1, [sp, #TRIANGLE_NOW]
    adds r1, #GLINT_AT_TRIANGLE_Y_END
    ldrh r1, [r1] /* above 0 */
    ldr r2, [sp, #END_OF_STRIP]
    cmp r1, r2
.endm

    function glint_mesh_strip_lines
    enter STRIP_FRAME
    movs r6, r0 /* the target */
    ldr r4, [r6, #GLINT_AT_TARGET_FRAME]
    ldr r5, [r6, #GLINT_AT_TARGET_FRAME + 4]
    add r7, sp, #FRAME_AT
    ldr r1, [r6, #GLINT_AT_TARGET_Y]
    ldr r2, [r6, #GLINT_AT_TARGET_Y + 4]
    ldr r3, [r4, #GLINT_AT_FRAME_KEPT]
    stmia r7!, {r4-r6}
    stmia r7!, {r1-r3}
    ldr r3, [r5, #GLINT_AT_DRAWN_LINKS]
    ldr r4, [r5, #GLINT_AT_DRAWN_MESH]
    ldr r4, [r4, #GLINT_AT_MESH_FACES]
    stmia r7!, {r3, r4}
    ldr r3, [r6, #GLINT_AT_TARGET_FRAME]
    ldrh r3, [r3, #GLINT_AT_FRAME_KEPT_BYTES]
    str r3, [sp, #KEPT_BYTES]
    movs r0, r5
    bl glint_mesh_take
    str r0, [sp, #NEW_FACE]
    ldrh r4, [r5, #GLINT_AT_DRAWN_KEPT]
    kept_is_next
    movs r3, #0
    add r0, sp, #KEEP
    str r3, [r0]
    str r0, [sp, #KEEP_LAST]
    adds r0, #4
    str r3, [r0]
    str r0, [sp, #LATER_LAST]
    b .Lfaces

.Lbeyond: /* r0, r1: the next faces, of which the lower one is the next part's; or NONE both */
    ldr r3, =NONE
    cmp r0, r3
    bne 1f
    cmp r1, r3
    bne 1f
    b .Lall
1:  ldr r3, [sp, #NUMBER]
    adds r3, #1
.Lfaces: /* r3: the number of a part */
    str r3, [sp, #NUMBER]
    ldr r0, [sp, #TARGET_AT]
    movs r1, r3
    mov r2, sp
    bl glint_mesh_part_lines
    str r0, [sp, #T_END]
    ldr r4, [sp, #DRAWN_AT]
    ldr r4, [r4, #GLINT_AT_DRAWN_MESH]
    ldr r0, [sp, #NUMBER]
    adds r1, r0, #1
    ldr r2, =NONE
    ldrb r3, [r4, #GLINT_AT_MESH_VERTEX_COUNT + 4]
    cmp r1, r3
    bhs 1f
    ldr r3, [r4, #GLINT_AT_MESH_FACES + 4]
    lsls r0, r0, #1
    ldrh r2, [r3, r0]
1:  str r2, [sp, #FACES_END]

.Lnext:
    ldr r2, [sp, #FACES_END]
    ldr r0, [sp, #KEPT_FACE]
    ldr r1, [sp, #NEW_FACE]
    cmp r0, r1
    blo .Lkept
    cmp r1, r2
    bhs .Lbeyond
    lsls r3, r1, #1
    ldr r2, [sp, #LINKS_AT]
    ldrh r2, [r2, r3]
    str r2, [sp, #NEW_FACE]
    adds r3, r3, r1
    lsls r3, r3, #1
    ldr r2, [sp, #FACES_AT]
    adds r2, r2, r3
    ldr r6, [sp, #FRAME_AT]
    ldrh r4, [r6, #GLINT_AT_FRAME_FREE]
    str r4, [sp, #PLACE]
    adds r3, r4, #1
    lsrs r3, r3, #16
    bne .Lno_place
    place_at r0, r5
.Lplaced:
    str r0, [sp, #TRIANGLE_NOW]
    movs r5, r0
    adds r5, #GLINT_AT_KEPT_FACE
    strh r1, [r5]
    ldr r1, [sp, #DRAWN_AT]
    ldr r3, [sp, #T_END]
    bl glint_mesh_face_lines
    ldr r0, [sp, #TRIANGLE_NOW]
    movs r2, #GLINT_AT_TRIANGLE_Y
    ldrsh r2, [r0, r2]
    ldr r1, [sp, #Y_OF_STRIP]
    cmp r2, r1
    blt .Lskip
.Lskipped:
    draw_here .Lgoes_on
    ble .Lnext
.Lgoes_on:
    ldr r4, [sp, #PLACE]
    adds r0, r4, #1
    lsrs r0, r0, #16
    bne .Llater
    ldr r6, [sp, #FRAME_AT]
    ldr r5, [sp, #TRIANGLE_NOW]
    adds r5, #GLINT_AT_KEPT_FACE + 2
    ldrh r3, [r5]
    strh r3, [r6, #GLINT_AT_FRAME_FREE]
.Lkeep: /* r4: its place, r5: its link */
    ldr r7, [sp, #KEEP_LAST]
    strh r4, [r7]
    str r5, [sp, #KEEP_LAST]
    b .Lnext

.Lkept: /* r0 */
    cmp r0, r2
    bhs .Lbeyond
    ldr r4, [sp, #KEPT_PLACE]
    str r4, [sp, #PLACE]
    place_at r5, r1
    str r5, [sp, #TRIANGLE_NOW]
    movs r2, r5
    adds r2, #GLINT_AT_KEPT_FACE + 2
    ldrh r4, [r2]
    kept_is_next
    movs r0, r5
    movs r2, #GLINT_AT_TRIANGLE_Y
    ldrsh r2, [r0, r2]
    draw_here .Lstays
    ble .Lended
.Lstays:
    ldr r4, [sp, #PLACE]
    ldr r5, [sp, #TRIANGLE_NOW]
    adds r5, #GLINT_AT_KEPT_FACE + 2
    b .Lkeep
.Lended:
    ldr r4, [sp, #PLACE]
    ldr r5, [sp, #TRIANGLE_NOW]
    adds r5, #GLINT_AT_KEPT_FACE + 2
    ldr r6, [sp, #FRAME_AT]
    ldrh r3, [r6, #GLINT_AT_FRAME_FREE]
    strh r3, [r5]
    strh r4, [r6, #GLINT_AT_FRAME_FREE]
    b .Lnext

.Lno_place:
    ldr r0, [r6, #GLINT_AT_FRAME_KEPT - 4]
    ldr r5, =GLINT_AT_BENCH_FACE
    adds r0, r0, r5
    b .Lplaced
.Lskip: /* r1: to this line */
    bl glint_mesh_triangle_skip
    ldr r0, [sp, #TRIANGLE_NOW]
    ldr r2, [sp, #Y_OF_STRIP]
    b .Lskipped
.Llater:
    ldr r1, [sp, #TRIANGLE_NOW]
    adds r1, #GLINT_AT_KEPT_FACE
    ldrh r1, [r1]
    lsls r2, r1, #1
    ldr r3, [sp, #LINKS_AT]
    adds r3, r3, r2
    ldr r7, [sp, #LATER_LAST]
    strh r1, [r7]
    str r3, [sp, #LATER_LAST]
    b .Lnext

.Lall:
    ldr r0, [sp, #KEEP_LAST]
    strh r3, [r0]
    ldr r0, [sp, #LATER_LAST]
    strh r3, [r0]
    ldr r0, [sp, #DRAWN_AT]
    ldr r1, [sp, #KEEP]
    strh r1, [r0, #GLINT_AT_DRAWN_KEPT]
    ldr r2, [sp, #END_OF_STRIP]
    ldr r3, [sp, #FRAME_AT]
    ldrh r3, [r3, #GLINT_AT_FRAME_W + 2]
    cmp r2, r3
    bge 1f
    ldr r1, [sp, #LATER]
    bl glint_mesh_give
1:  leave STRIP_FRAME
    .ltorg

/* glint_mesh_outlined, a routine that draws a triangle's lines: where outlines ask nothing of its face it is INNER. Else it hides cells, and
 * shows them again. */
    function glint_mesh_outlined
    movs r4, r0
    adds r4, #GLINT_AT_KEPT_FACE
    ldrh r4, [r4]
    ldr r1, [sp, #DRAWN_AT]
    ldr r1, [r1, #GLINT_AT_DRAWN_EDGES]
    ldrb r1, [r1, r4]
    movs r2, #GLINT_EDGES_ASK
    ldr r3, [sp, #INNER]
    tst r1, r2
    bne 1f
    bx r3
1:  mov r2, lr
    str r2, [sp, #RETURN]
    movs r2, #GLINT_EDGES_NONE
    tst r1, r2
    bne 5f
    ldr r0, [sp, #TARGET_AT]
    movs r1, r4
    bl glint_mesh_hide_face
    cmp r0, #0
    beq 6f
2:  ldr r0, [sp, #TRIANGLE_NOW]
    ldr r3, [sp, #INNER]
    blx r3
    ldr r1, [sp, #DRAWN_AT]
    ldr r1, [r1, #GLINT_AT_DRAWN_OUTLINES]
    ldr r2, =GLINT_AT_OUTLINES_REST + 2
    adds r1, r1, r2
    ldrh r2, [r1]
    adds r1, #2
    lsls r2, r2, #3
    adds r2, r2, r1
    b 4f
3:  subs r2, #8
    ldr r3, [r2]
    ldr r4, [r2, #4]
    strh r4, [r3]
4:  cmp r2, r1
    bne 3b
5:  ldr r1, [sp, #RETURN]
    bx r1
6:  ldr r0, [sp, #TRIANGLE_NOW]
    ldr r1, [sp, #TARGET_AT]
    bl glint_mesh_hide
    cmp r0, #0
    bne 2b
    b 5b
    .ltorg

/* ---- a strip's faces ----
 * glint_mesh_sort_faces(frame, drawn, y), as mesh_strip.c has it: from the last face to the first. Half of them show their backs, which
 * is known as soon as the corners are loaded. And glint_mesh_clear(depth, bytes), as mesh_strip.c has it. */

#define face r0
#define number r7
#define vertices r8
#define from r9 /* y */
#define height r10
#define bands r11
#define links r12
#define is_cut lr

/* marks: edges, at the frame's first word, of each face, get its front or clipping. */
.macro sort_faces marks
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

.Lface\@:
    subs number, #1
    bmi .Lsorted\@
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
    bne .Lmay_be_out\@
.Lin\@: /* r5: 0 */
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
    bge .Lface\@
.if \marks
    ldr r4, [sp]
    movs r5, #GLINT_EDGES_IS_FRONT
    ldrb r6, [r4, number]
    orrs r5, r6
    strb r5, [r4, number]
.endif
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
    bge .Lface\@
    cmp r1, height
    bge .Lface\@
.Lband\@:
    lsrs r1, r1, #GLINT_MESH_BAND_LOG
    lsls r1, r1, #1
    add r1, bands
    ldrh r2, [r1]
    strh number, [r1]
    lsls r3, number, #1
    add r3, links
    strh r2, [r3]
    b .Lface\@

.Lmay_be_out\@:
    ldrh r4, [r1, #6]
    ldrh r5, [r2, #6]
    ldrh r6, [r3, #6]
    orrs r5, r4
    orrs r5, r6
    beq .Lin\@
.if \marks
    ldr r5, [sp]
    ldrb r6, [r5, number]
    movs r1, #GLINT_EDGES_IS_CLIPPED
    orrs r6, r1
    strb r6, [r5, number]
    ldrh r6, [r3, #6]
.endif
    /* Seen once it is clipped, unless one plane cuts all of it. */
    ldrh r5, [r2, #6]
    ands r4, r5
    tst r4, r6
    bne .Lface\@
    mov r1, from
    b .Lband\@
.Lsorted\@:
.endm

    function glint_mesh_sort_faces
    enter 4
    ldr r3, [r1, #GLINT_AT_DRAWN_EDGES]
    str r3, [sp]
    cmp r3, #0
    beq 1f
    b .Lmarked
1:  sort_faces 0
    leave 4
.Lmarked:
    sort_faces 1
    leave 4

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
