/* SPDX-License-Identifier: MIT
 * Triangles by ALBEDO tables with a texture or colours of vertices, as fused_albedo.c has them: loops over pixels side by side, one for each
 * place that albedo comes from, matt or glossy, bytes swapped or not; and a triangle's lines, which a strip calls by itself. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#define LINES_FRAME 132 /* and a return address */
#include "cortex_m0plus_mesh.inc"
#include "cortex_m0plus_numbers.inc"

/* The frame's other part, from 40 on. First as in struct glint_mesh_pixels. */
#define LEVELS 40
#define SUMS 44
#define LAST_T 48
#define LAST_BACK 52
#define COLUMN_SHIFT 56
#define UNLIT 60
#define TEXELS 64
#define PALETTE 68
#define PICTURE_W 72
#define PICTURE_H 76
#define ROW_END 80   /* of depths */
#define DT_STEP 84   /* -ddt */
#define DNL 88       /* -dnl */
#define DBLUE 92     /* and of blue: of colours */
#define FETCH 96     /* of bilinear texels, what makes one, and where that goes on */
#define FETCHED 100
#define RETURN 104   /* where loops go on */
#define MATT 108     /* loops */
#define GLOSSY 112
#define NOW 116
#define COLUMN 120   /* from the triangle's */
#define SOURCE 124
#define DEPTH_NOW 128
#define MATT_THEN FETCH /* of colours, which fetch nothing: loops behind those that make blue */
#define GLOSSY_THEN FETCHED

/* And of the struct glint_mesh_lines behind it. */
#define PIXELS_AT COLOURS
#define TARGET_OF DARK
#define TEXTURE_OF SHIFT

#define FIELDS 0x07e0f81f
#define HALF 0x02008010

/* ---- Pixels ----
 * r0: depth, r1: z, r2: ~nl, r3: u or red, r4: v or green; r8: dz, r9: -dnl or blue, r10, r11: steps of r3 and r4. Matt: r12: HALF, lr: end.
 * Glossy: r12: t_max - t, lr: -dt. Albedo is r5: fetched, then fields with FIELDS in r7; r6 and r7 are free, but r6 then is the level. */

.macro place
    ldr r7, [sp, #PICTURE_H]
    lsrs r5, r4, #16
    muls r5, r7
    lsrs r5, r5, #16
    ldr r7, [sp, #PICTURE_W]
    muls r5, r7
    lsrs r6, r3, #16
    muls r6, r7
    lsrs r6, r6, #16
    adds r5, r5, r6
    ldr r7, [sp, #TEXELS]
.endm

.macro fetch_nearest
    place
    lsls r5, r5, #1
    ldrh r5, [r7, r5]
.endm
/* Of a picture whose width and height are one power of two: PICTURE_H is 32 less that power. */
.macro fetch_square
    ldr r7, [sp, #PICTURE_H]
    movs r5, r4
    lsrs r5, r7
    rors r5, r7
    movs r6, r3
    lsrs r6, r7
    adds r5, r5, r6
    ldr r7, [sp, #TEXELS]
    lsls r5, r5, #1
    ldrh r5, [r7, r5]
.endm
.macro fetch_palette
    place
    ldrb r5, [r7, r5]
    lsls r5, r5, #1
    ldr r7, [sp, #PALETTE]
    ldrh r5, [r7, r5]
.endm
.macro fetch_colours
    lsrs r5, r3, #21
    lsls r5, r5, #11
    lsrs r6, r4, #21
    lsls r6, r6, #21
    orrs r5, r6
    mov r6, r9
    lsrs r6, r6, #21
    orrs r5, r6
.endm

.macro fields_nearest
    lsls r7, r5, #16
    orrs r5, r7
    ldr r7, =FIELDS
    ands r5, r7
.endm
.macro fields_square
    fields_nearest
.endm
.macro fields_palette
    fields_nearest
.endm
.macro fields_colours
    ldr r7, =FIELDS
.endm
.macro fields_smooth
    ldr r7, =FIELDS
.endm

.macro lit source, is_glossy
    fields_\source
    muls r5, r6
    .if \is_glossy
    ldr r6, =HALF
    adds r5, r5, r6
    .else
    add r5, r12
    .endif
    lsrs r5, r5, #5
    ands r5, r7
.endm

.macro pixels source, is_glossy, is_swapped
    .type pixels_\source\()_\is_glossy\is_swapped, %function
    .thumb_func
pixels_\source\()_\is_glossy\is_swapped:
    .ifc \source, smooth
    ldr r5, =7f + 1
    str r5, [sp, #FETCHED]
    .endif
1:  in_front 3f
    .ifc \source, smooth
    ldr r7, [sp, #FETCH]
    bx r7
7:
    .else
    fetch_\source
    .endif
    asrs r6, r2, #GLINT_ALBEDO_LEVEL_SHIFT
    bpl 4f
    ldr r7, [sp, #LEVELS]
    ldrb r6, [r7, r6]
8:  lit \source, \is_glossy
    .if \is_glossy
    mov r6, r12
    cmp r6, #0
    bge 5f /* LAST_BACK < 2^31 */
    .endif
2:  lsrs r6, r5, #16
    orrs r5, r6
    .if \is_swapped
    rev16 r5, r5
    .endif
    ldr r6, [sp, #OFF]
    strh r5, [r0, r6]
3:  adds r0, #2
    add r1, r8
    .ifc \source, colours
    ldr r5, [sp, #DNL]
    adds r2, r2, r5
    ldr r5, [sp, #DBLUE]
    add r9, r5
    .else
    add r2, r9
    .endif
    add r3, r10
    add r4, r11
    .if \is_glossy
    add r12, lr
    ldr r5, [sp, #DT_STEP]
    add lr, r5
    ldr r5, [sp, #ROW_END]
    cmp r0, r5
    .else
    cmp r0, lr
    .endif
    blo 1b
    ldr r7, [sp, #RETURN]
    bx r7
4:  ldr r6, [sp, #UNLIT]
    .if \is_glossy
    lit \source, 1
    b 2b
5:  ldr r7, [sp, #LAST_T]
    cmp r6, r7
    bls 6f
    ldr r7, [sp, #LAST_BACK]
    cmp r6, r7
    bhi 2b
    ldr r6, [sp, #LAST_T]
6:  ldr r7, [sp, #COLUMN_SHIFT]
    lsrs r6, r7
    lsls r6, r6, #2
    ldr r7, [sp, #SUMS]
    ldr r6, [r7, r6]
    adds r5, r5, r6
    ldr r7, =FIELDS
    movs r6, r5
    bics r6, r7 /* fields that overflow */
    beq 2b
    lsrs r7, r6, #6
    orrs r5, r7
    lsrs r7, r6, #5
    subs r6, r6, r7
    orrs r5, r6
    ldr r7, =FIELDS
    ands r5, r7
    b 2b
    .else
    b 8b
    .endif
.endm

.macro loops_of source
    pixels \source, 0, 0
    pixels \source, 1, 0
    pixels \source, 0, 1
    pixels \source, 1, 1
    .ltorg
.endm
.macro addresses_of source
    .word pixels_\source\()_00, pixels_\source\()_10, pixels_\source\()_01, pixels_\source\()_11
.endm

    .section .text.glint_mesh_albedo_loops, "ax", %progbits
    .balign 4
loops:
    addresses_of colours
    addresses_of nearest
    addresses_of square
    addresses_of palette
    addresses_of smooth
    loops_of colours
    loops_of nearest
    loops_of square
    loops_of palette
    loops_of smooth

/* Texels at bytes r0-r3 of the picture, which they become. r6: texels. */
.macro texels_of_rgb565
    .irp at, r0, r1, r2, r3
    ldrh \at, [r6, \at]
    .endr
.endm
.macro texels_of_palette
    ldr r7, [sp, #PALETTE + 20]
    .irp at, r0, r1, r2, r3
    ldrb \at, [r6, \at]
    lsls \at, \at, #1
    ldrh \at, [r7, \at]
    .endr
.endm

/* r5: fields of four texels around u, v: r0-r3 from the upper left one to the lower right one; r4, r5: how far away it is, of 32. By what the others are
 * more than it: 32 a + x (b - a) + y (c - a) + xy (d - c - b + a). */
.macro smooth kind, log
    .type smooth_\kind, %function
    .thumb_func
smooth_\kind:
    push {r0-r4}
    lsrs r0, r3, #16
    ldr r6, [sp, #PICTURE_W + 20]
    muls r0, r6 /* x, Q16 */
    lsrs r2, r4, #16
    ldr r7, [sp, #PICTURE_H + 20]
    muls r2, r7 /* y */
    lsls r4, r0, #16
    lsrs r4, r4, #27
    lsls r5, r2, #16
    lsrs r5, r5, #27
    lsrs r0, r0, #16
    lsrs r2, r2, #16
    .if \log
    lsls r0, r0, #\log
    lsls r6, r6, #\log
    .endif
    adds r1, r0, #1 << \log
    cmp r1, r6
    bne 1f
    movs r1, #0
1:  adds r3, r2, #1
    cmp r3, r7
    bne 1f
    movs r3, #0
1:  muls r2, r6
    muls r3, r6
    adds r6, r0, r3 /* below, left */
    adds r3, r3, r1 /* below, right */
    adds r1, r1, r2
    adds r0, r0, r2
    movs r2, r6
    ldr r6, [sp, #TEXELS + 20]
    texels_of_\kind
    ldr r6, =FIELDS
    .irp at, r0, r1, r2, r3
    lsls r7, \at, #16
    orrs \at, r7
    ands \at, r6
    .endr
    movs r7, r4
    muls r7, r5
    adds r7, #16
    lsrs r7, r7, #5 /* both */
    subs r3, r3, r2
    subs r3, r3, r1
    adds r3, r3, r0
    muls r3, r7
    subs r1, r1, r0
    muls r1, r4
    subs r2, r2, r0
    muls r5, r2
    lsls r0, r0, #5
    adds r0, r0, r1
    adds r0, r0, r3
    adds r5, r5, r0
    ldr r0, =HALF
    adds r5, r5, r0
    lsrs r5, r5, #5
    ands r5, r6
    pop {r0-r4}
    ldr r7, [sp, #FETCHED]
    bx r7
.endm
    smooth rgb565, 1
    smooth palette, 0
    .ltorg

/* r2, r3: by the palette in r1 and the loop's number in r5, what makes a bilinear texel; and a pointer to the loop. r5: the source. */
.macro chosen
    ldr r2, =smooth_rgb565
    cmp r1, #0
    beq 1f
    ldr r2, =smooth_palette
1:  str r2, [sp, #FETCH]
    ldr r3, =loops
    lsls r2, r5, #2
    adds r3, r3, r2
    lsrs r5, r5, #2
    str r5, [sp, #SOURCE]
.endm

#define PIXELS_FRAME (OFF + 8)

    function glint_mesh_albedo_pixels
    enter PIXELS_FRAME
    movs r7, r0
    adds r7, #GLINT_AT_PIXELS_DDT
    ldmia r7!, {r1-r4} /* ddt, depth, end, off */
    negs r1, r1
    str r1, [sp, #DT_STEP]
    str r2, [sp, #DEPTH_NOW]
    str r3, [sp, #ROW_END]
    str r4, [sp, #OFF]
    add r6, sp, #LEVELS
    ldmia r7!, {r1-r5}
    stmia r6!, {r1-r5}
    ldmia r7!, {r1-r5}
    stmia r6!, {r1-r5}
    ldrb r5, [r7]
    lsls r1, r5, #31
    str r1, [sp, #COLUMN]
    movs r1, r3
    chosen
    ldr r3, [r3]
    str r3, [sp, #NOW]
    ldr r3, =.Lpixels_end + 1
    str r3, [sp, #RETURN]
    movs r7, r0
    adds r7, #GLINT_AT_PIXELS_DZ
    movs r0, r5
    ldmia r7!, {r1-r5} /* dz, dnl, step */
    mov r8, r1
    negs r2, r2
    mov r9, r2
    str r2, [sp, #DNL]
    mov r10, r3
    mov r11, r4
    str r5, [sp, #DBLUE]
    subs r7, #GLINT_AT_PIXELS_DZ + 20
    ldmia r7!, {r1-r6} /* z, nl, now, back */
    mvns r2, r2
    cmp r0, #0
    bne 1f
    mov r9, r5
1:  mov r12, r6
    ldr r7, [r7] /* dt */
    negs r7, r7
    mov lr, r7
    ldr r0, [sp, #COLUMN]
    cmp r0, #0
    bne 1f
    ldr r7, =HALF
    mov r12, r7
    ldr r7, [sp, #ROW_END]
    mov lr, r7
1:  ldr r0, [sp, #DEPTH_NOW]
    ldr r7, [sp, #NOW]
    bx r7
.Lpixels_end:
    leave PIXELS_FRAME
    .ltorg

/* ---- Lines ---- */

/* From the edges' columns, r2: the first, r6: how many: r0: the depth, and where it ends; r5: the column from the triangle's; r7: the triangle. */
.macro row_begin
    ldr r0, [sp, #DEPTH]
    lsls r4, r2, #1
    adds r0, r0, r4
    lsls r3, r6, #1
    adds r3, r3, r0
    str r3, [sp, #ROW_END]
    mov lr, r3
    ldr r7, [sp, #TRIANGLE]
    ldr r1, [r7, #GLINT_AT_TRIANGLE_X]
    subs r5, r2, r1
.endm

/* z, nl, and u and v of it, or red and green; then the loop. */
.macro row_of loop
    ldmia r7!, {r1, r2}
    mvns r2, r2
    mov r6, r8
    muls r6, r5
    adds r1, r1, r6
    mov r6, r9
    muls r6, r5
    adds r2, r2, r6
    adds r7, #GLINT_MESH_KEPT_SIZE - 8
    ldmia r7!, {r3, r4}
    mov r6, r10
    muls r6, r5
    adds r3, r3, r6
    mov r6, r11
    muls r6, r5
    adds r4, r4, r6
    ldr r6, [sp, #\loop]
    bx r6
.endm

/* To the next line; r6: the triangle + passed. */
.macro laid_next passed
    adds r6, #GLINT_MESH_KEPT_SIZE - \passed
    ldmia r6!, {r0-r3}
    adds r0, r0, r2
    adds r1, r1, r3
    subs r6, #16
    stmia r6!, {r0, r1}
.endm
/* And blue before that. */
.macro blue_next
    ldr r6, [sp, #DNL]
    mov r9, r6
    ldr r6, [sp, #TRIANGLE]
    adds r6, #GLINT_MESH_KEPT_SIZE + 24
    ldmia r6!, {r0, r1}
    adds r0, r0, r1
    subs r6, #8
    str r0, [r6]
.endm

.macro returns_to of_texture, of_colours
    ldr r0, =\of_texture + 1
    ldr r1, [sp, #SOURCE]
    cmp r1, #0
    bne 1f
    ldr r0, =\of_colours + 1
1:  str r0, [sp, #RETURN]
.endm

/* A colour in r6 with its step in r7, held to 0..2^bits - 1 on r5 + 1 pixels; r0 is lost. */
.macro held bits
    movs r0, r7
    muls r0, r5
    adds r0, r0, r6
    orrs r0, r6
    lsrs r0, r0, #\bits
    beq 2f
    movs r7, #0
    lsrs r0, r6, #\bits
    beq 2f
    movs r0, #0
    cmp r6, #0
    blt 1f
    mvns r0, r0
    lsrs r0, r0, #32 - \bits
1:  movs r6, r0
2:
.endm

/* Blue, too, before a loop; r7: in what is laid, behind `at`, r5: the column. Where one leaves its range, it is held. */
.macro blue_of name, loop
.L\name\()_blue:
    ldr r6, [sp, #DBLUE]
    muls r5, r6
    ldr r7, [r7, #16]
    adds r7, r7, r5
    mov r9, r7
    ldr r5, [sp, #ROW_END]
    subs r5, r5, r0
    lsrs r5, r5, #1
    subs r5, #1
    muls r6, r5
    adds r6, r6, r7
    orrs r6, r7
    mov r7, r10
    muls r7, r5
    adds r7, r7, r3
    orrs r6, r7
    orrs r6, r3
    lsrs r6, r6, #26
    mov r7, r11
    muls r7, r5
    adds r7, r7, r4
    orrs r7, r4
    lsrs r7, r7, #27
    orrs r6, r7
    ldr r7, [sp, #\loop]
    beq 1f
    b .Lleaves
1:  bx r7
.endm

/* What is laid, of slopes that were: the frame, before its part from 40 on is made. u, v, u_x, v_x, u_y, v_y, vertices, e - 18. */
#define SLOPES 40
#define VERTICES 64
#define STEEP_AT 76
#define UP 80
#define LAID_AT 84
#define OF_VERTICES 88 /* and of b and c: uv or colours */
#define FIRST 100      /* what bilinear texels begin before a */
#define SKIPPED 108    /* lines of the triangle */

/* One number: r0: a's, r1, r2: how much more b's and c's are, r3: up. Becomes r0, r6: a step to the right, r7: one down. */
    .section .text.laid_number, "ax", %progbits
    .type laid_number, %function
    .balign 4
    .thumb_func
laid_number:
    pair_of r1, r2, r5, r6, r7
    adds r3, r3, r5
    ldr r6, [sp, #STEEP_AT]
    adds r6, #18 - GLINT_MESH_STEEP
    bmi .Lsteep
    adds r6, #GLINT_MESH_STEEP - 1
    subs r5, r6, r3 /* as shift_to_nearest takes it for steps */
    add r7, sp, #SLOPES
    ldmia r7!, {r3, r6}
    muls r3, r1
    muls r6, r2
    adds r6, r6, r3
    subs r3, r5, #1
    shift_to_nearest r3, r6
    adds r0, r0, r6
    ldmia r7!, {r3, r6}
    muls r3, r1
    muls r6, r2
    adds r6, r6, r3
    ldr r3, [r7]
    ldr r7, [r7, #4]
    muls r3, r1
    muls r7, r2
    adds r7, r7, r3
    shift_to_nearest r5, r6, r7
    bx lr
.Lsteep: /* one for all of it */
    lsls r1, r1, #1
    adds r1, r1, r2
    movs r6, #0
    movs r7, #0
    subs r3, #2
    bmi 1f
    lsls r1, r3
    adds r0, r0, r1
    bx lr
1:  negs r3, r3
    asrs r1, r3
    adds r0, r0, r1
    bx lr

/* r0-r2: number `at` of three corners. */
.macro corner_numbers load, at
    add r3, sp, #OF_VERTICES
    ldmia r3!, {r0-r2}
    \load r0, [r0, #\at]
    \load r1, [r1, #\at]
    \load r2, [r2, #\at]
    subs r1, r1, r0
    subs r2, r2, r0
.endm

.macro number_laid to, apart
    bl laid_number
    ldr r3, [sp, #SKIPPED]
    muls r3, r7
    adds r0, r0, r3
    ldr r3, [sp, #LAID_AT]
    str r0, [r3, #\to]
    str r7, [r3, #\to + \apart]
    str r6, [r3, #\to + 2 * \apart]
.endm

.macro laid_uv at, before, to
    corner_numbers ldrh, \at
    ldr r3, [sp, #UP]
    lsls r0, r3
    ldr r4, [sp, #\before]
    subs r0, r0, r4
    number_laid \to, 8
.endm

.macro laid_colour at, one, to, apart
    corner_numbers ldrb, \at
    ldr r3, =\one
    muls r0, r3
    muls r1, r3
    muls r2, r3
    ldr r3, =1 << GLINT_MESH_OVER_HALF_LOG
    adds r0, r0, r3
    movs r3, #0
    number_laid \to, \apart
.endm

    .section .text.albedo_lines, "ax", %progbits
    .type albedo_laid_lines, %function
    .balign 4
    .thumb_func
albedo_laid_lines:
    push {lr}
    sub sp, #LINES_FRAME
    str r0, [sp, #TRIANGLE]
    movs r4, r0
.Llaid: /* r4: the triangle */
    ldr r7, [sp, #PIXELS_AT]
    adds r7, #GLINT_AT_PIXELS_DDT + 16
    add r6, sp, #LEVELS
    ldmia r7!, {r0-r3}
    stmia r6!, {r0-r3}
    ldmia r7!, {r0-r3} /* shift, dark, pixels, palette */
    stmia r6!, {r0, r1}
    ldrb r5, [r7, #8]
    movs r7, r4
    adds r7, #GLINT_MESH_KEPT_SIZE + 24
    ldmia r7, {r0, r7} /* how much is passed, w and h */
    adds r0, r0, r2
    movs r1, r3
    uxth r2, r7
    lsrs r3, r7, #16
    stmia r6!, {r0-r3}
    chosen
    ldmia r3!, {r0, r1}
    cmp r5, #0
    bne 1f
    str r0, [sp, #MATT_THEN]
    str r1, [sp, #GLOSSY_THEN]
    ldr r0, =.Lmatt_blue + 1
    ldr r1, =.Lglossy_blue + 1
1:  str r0, [sp, #MATT]
    str r1, [sp, #GLOSSY]
    ldr r0, [r4, #GLINT_AT_TRIANGLE_ZX]
    mov r8, r0
    ldr r0, [r4, #GLINT_AT_TRIANGLE_NLX]
    negs r0, r0
    mov r9, r0
    str r0, [sp, #DNL]
    movs r7, r4
    adds r7, #GLINT_MESH_KEPT_SIZE
    ldr r0, [r7, #16]
    mov r10, r0
    ldr r0, [r7, #20]
    mov r11, r0
    ldr r0, [r7, #32]
    str r0, [sp, #DBLUE]
    ldr r0, [r4, #GLINT_AT_TRIANGLE_TXX]
    negs r1, r0
    str r1, [sp, #DT_STEP]
    longest_of
    movs r0, r4
    triangle_parts
    add r7, sp, #LEFT
    stmia r7!, {r2-r5}
    lsls r6, r6, #7
    bcc .Lmatt
    b .Lglossy
    triangle_edges

.Lmatt_hold:
    hold r2, r3, r6, .Lmatt_held, .Lempty
.Lempty:
    ldr r7, [sp, #RETURN]
    bx r7
.Lmatt:
    returns_to .Lmatt_end, .Lmatt_colours_end
    ldr r0, =HALF
    mov r12, r0
.Lmatt_line:
    edges_begin .Lmatt_hold, .Lempty
.Lmatt_held:
    row_begin
.Lmatt_row:
    row_of MATT
.Lmatt_colours_end:
    blue_next
.Lmatt_end:
    plain_values_next
    laid_next 8
    next_line .Lmatt_line
.Lpart_end:
    ldr r0, [sp, #LEFT]
    ldr r1, [sp, #RIGHT]
    b .Ledges
    blue_of matt, MATT_THEN
    .ltorg

.Lglossy_hold:
    hold r2, r3, r6, .Lglossy_held, .Lnone
.Lnone:
    ldr r7, [sp, #RETURN]
    bx r7
.Lglossy:
    returns_to .Lglossy_end, .Lglossy_colours_end
.Lglossy_line:
    edges_begin .Lglossy_hold, .Lnone
.Lglossy_held:
    row_begin
    str r5, [sp, #COLUMN]
    adds r7, #GLINT_AT_TRIANGLE_T
    ldmia r7!, {r3, r4} /* t, tx */
    ldr r1, [r7, #GLINT_AT_TRIANGLE_TXX - 16]
    movs r2, r4
    muls r2, r5
    adds r3, r3, r2
    subs r2, r5, #1
    muls r2, r5
    asrs r2, r2, #1
    muls r2, r1
    adds r3, r3, r2
    muls r5, r1
    adds r4, r4, r5
    ldr r2, [sp, #LAST_T]
    subs r3, r2, r3
    bmi .Lmay_miss
.Lhits:
    mov r12, r3
    negs r4, r4
    mov lr, r4
    ldr r5, [sp, #COLUMN]
    ldr r7, [sp, #TRIANGLE]
    row_of GLOSSY
.Lglossy_colours_end:
    blue_next
.Lglossy_end:
    values_next
    laid_next 20
    next_line .Lglossy_next
    b .Lpart_end
.Lglossy_next:
    b .Lglossy_line
    blue_of glossy, GLOSSY_THEN
.Lmay_miss:
    movs r5, r1
    misses .Lhits
    ldr r5, =HALF
    mov r12, r5
    ldr r5, [sp, #COLUMN]
    ldr r7, [sp, #TRIANGLE]
    b .Lmatt_row

.Lleaves: /* one of them its range on this line; r7: the loop */
    str r7, [sp, #NOW]
    str r0, [sp, #DEPTH_NOW]
    movs r6, r3
    mov r7, r10
    held 26
    movs r3, r6
    mov r10, r7
    movs r6, r4
    mov r7, r11
    held 27
    movs r4, r6
    mov r11, r7
    mov r6, r9
    ldr r7, [sp, #DBLUE]
    held 26
    mov r9, r6
    str r7, [sp, #DBLUE]
    ldr r0, [sp, #RETURN]
    str r0, [sp, #COLUMN]
    ldr r0, =.Lheld + 1
    str r0, [sp, #RETURN]
    ldr r0, [sp, #DEPTH_NOW]
    ldr r7, [sp, #NOW]
    bx r7
.Lheld: /* steps as they were */
    ldr r7, [sp, #TRIANGLE]
    adds r7, #GLINT_MESH_KEPT_SIZE
    ldr r0, [r7, #16]
    mov r10, r0
    ldr r0, [r7, #20]
    mov r11, r0
    ldr r0, [r7, #32]
    str r0, [sp, #DBLUE]
    ldr r7, [sp, #COLUMN]
    str r7, [sp, #RETURN]
    bx r7
    .ltorg

/* The triangle in r0; sp: to the struct glint_mesh_lines. Registers are lost. */
    .type albedo_lines, %function
    .balign 4
    .thumb_func
albedo_lines:
.Lalbedo_lines:
    push {lr}
    sub sp, #LINES_FRAME
    str r0, [sp, #TRIANGLE]
    movs r4, r0
    adds r0, #GLINT_AT_TRIANGLE_SHINE
    ldrb r0, [r0]
    lsrs r0, r0, #GLINT_MESH_LAID_LOG + 1
    bcc 1f
    b .Llaid
1:  lsrs r0, r0, #1 /* slopes are there */
    bcc .Lby_c
    movs r7, r4
    adds r7, #GLINT_MESH_KEPT_SIZE
    str r7, [sp, #LAID_AT]
    add r6, sp, #SLOPES
    ldmia r7!, {r0-r3, r5}
    stmia r6!, {r0-r3, r5}
    ldmia r7!, {r0-r3, r5}
    stmia r6!, {r0-r3, r5}
    movs r0, #2
    ldrsh r0, [r1, r0]
    adds r0, #7
    asrs r0, r0, #4
    movs r5, #GLINT_AT_TRIANGLE_Y
    ldrsh r5, [r4, r5]
    subs r5, r5, r0
    str r5, [sp, #SKIPPED]
    ldr r7, [sp, #TARGET_OF]
    ldr r7, [r7, #GLINT_AT_TARGET_FRAME + 4]
    ldr r5, [r7, #GLINT_AT_DRAWN_MESH]
    ldr r6, [r7, #GLINT_AT_DRAWN_VERTICES]
    subs r1, r1, r6
    subs r2, r2, r6
    subs r3, r3, r6
    add r6, sp, #OF_VERTICES
    ldr r7, [sp, #TEXTURE_OF]
    cmp r7, #0
    beq .Lcolours_laid
    ldrb r0, [r7, #GLINT_AT_TEXTURE_LEVELS]
    cmp r0, #1
    bne .Lby_c
    ldr r0, [r5, #GLINT_AT_MESH_UV]
    lsrs r1, r1, #2
    lsrs r2, r2, #2
    lsrs r3, r3, #2
    adds r1, r1, r0
    adds r2, r2, r0
    adds r3, r3, r0
    stmia r6!, {r1-r3}
    movs r0, #GLINT_AT_MESH_UV_BITS
    ldrb r0, [r5, r0]
    movs r1, #32
    subs r1, r1, r0
    str r1, [sp, #UP]
    ldr r7, [sp, #PIXELS_AT]
    ldr r0, [r7, #GLINT_AT_PIXELS_NOW]
    ldr r1, [r7, #GLINT_AT_PIXELS_NOW + 4]
    stmia r6!, {r0, r1} /* FIRST */
    laid_uv 0, FIRST, 0
    laid_uv 2, FIRST + 4, 4
    movs r0, #0
    str r0, [r3, #24]
    ldr r0, [sp, #PIXELS_AT]
    ldr r0, [r0, #GLINT_AT_PIXELS_NOW + 8]
    str r0, [r3, #28]
.Lis_laid:
    ldr r4, [sp, #TRIANGLE]
    movs r1, r4
    adds r1, #GLINT_AT_TRIANGLE_SHINE
    ldrb r0, [r1]
    movs r2, #1 << GLINT_MESH_LAID_LOG
    orrs r0, r2
    strb r0, [r1]
    b .Llaid
.Lby_c:
    ldr r0, [sp, #TARGET_OF]
    ldr r1, [sp, #TRIANGLE]
    ldr r2, [sp, #TEXTURE_OF]
    bl glint_mesh_albedo_laid
    ldr r4, [sp, #TRIANGLE]
    b .Llaid
.Lcolours_laid:
    ldr r0, [r5, #GLINT_AT_MESH_OF_VERTICES]
    cmp r0, #0
    beq .Lby_c
    movs r7, #3
    .irp vertex, r1, r2, r3
    lsrs \vertex, \vertex, #4
    muls \vertex, r7
    adds \vertex, \vertex, r0
    .endr
    stmia r6!, {r1-r3}
    laid_colour 0, GLINT_MESH_OVER_RED, 0, 8
    laid_colour 1, GLINT_MESH_OVER_GREEN, 4, 8
    laid_colour 2, GLINT_MESH_OVER_RED, 24, 4
    b .Lis_laid
    .ltorg

    function glint_mesh_albedo_draws
    ldr r1, =.Lalbedo_lines + 1 /* not by name: loops of pixels do not reach it */
    str r1, [r0, #GLINT_AT_LINES_DRAW]
    bx lr
    .ltorg

/* A triangle that a strip of C draws, which is laid: glint_mesh_albedo_triangle(strip, triangle, tables, texture). */
#define TRIANGLE_FRAME (GLINT_MESH_LINES_BYTES + 4)
    function glint_mesh_albedo_triangle
    enter TRIANGLE_FRAME
    movs r4, r1
    movs r1, r2
    movs r2, r3
    mov r3, sp
    bl glint_mesh_albedo_lines_set
    movs r0, r4
    bl albedo_laid_lines
    leave TRIANGLE_FRAME
#endif
