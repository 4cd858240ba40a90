/* SPDX-License-Identifier: MIT
 * Pixels of a triangle's line by ALBEDO tables, GLINT_MESH_RUN of them at most, as fused_mesh.c has them: glint_mesh_words_* make words of
 * albedo, glint_mesh_shade_* pixels of these. */
#include "glint_port.h"
#if GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus.inc"
#include "glint_offsets.h"

.macro save
    push {r4-r7, lr}
    mov r4, r8
    mov r5, r9
    mov r6, r10
    mov r7, r11
    push {r4-r7}
.endm

.macro restore
    pop {r4-r7}
    mov r8, r4
    mov r9, r5
    mov r10, r6
    mov r11, r7
    pop {r4-r7, pc}
.endm

/* ---- Words: r0: over, r1: the numbers, r2: where they go, r3: where they end ---- */

/* Nearest. r0: u, r1: v, r2: words, r3: w, r4: h, r5: texels; r8: du, r9: dv, r10: end, r11: the mask of fields, r12: the palette. */
    function glint_mesh_words_nearest
    save
    mov r10, r3
    adds r0, #GLINT_AT_OVER_PICTURE
    ldmia r0!, {r3-r6} /* pixels, palette, w, h */
    mov r12, r4
    mov r11, r3
    adds r0, #GLINT_AT_OVER_STEP - GLINT_AT_OVER_PICTURE - 16
    ldmia r0!, {r3, r4}
    mov r8, r3
    mov r9, r4
    movs r3, r5
    movs r4, r6
    mov r5, r11
    ldr r6, =0x07e0f81f
    mov r11, r6
    ldmia r1!, {r0, r6}
    movs r1, r6
    mov r7, r12
    cmp r7, #0
    bne 2f
1:  lsrs r6, r1, #16
    muls r6, r4
    lsrs r6, r6, #16
    muls r6, r3
    lsrs r7, r0, #16
    muls r7, r3
    lsrs r7, r7, #16
    adds r6, r6, r7
    lsls r6, r6, #1
    ldrh r6, [r5, r6]
    lsls r7, r6, #16
    orrs r6, r7
    mov r7, r11
    ands r6, r7
    stmia r2!, {r6}
    add r0, r8
    add r1, r9
    cmp r2, r10
    blo 1b
    restore
2:  lsrs r6, r1, #16
    muls r6, r4
    lsrs r6, r6, #16
    muls r6, r3
    lsrs r7, r0, #16
    muls r7, r3
    lsrs r7, r7, #16
    adds r6, r6, r7
    ldrb r6, [r5, r6]
    lsls r6, r6, #1
    mov r7, r12
    ldrh r6, [r7, r6]
    lsls r7, r6, #16
    orrs r6, r7
    mov r7, r11
    ands r6, r7
    stmia r2!, {r6}
    add r0, r8
    add r1, r9
    cmp r2, r10
    blo 2b
    restore
    .ltorg

/* Red, green, blue: r0, r1, r4. */
    function glint_mesh_words_colours
    push {r4-r7, lr}
    mov r12, r3
    mov r3, r8
    push {r3}
    adds r0, #GLINT_AT_OVER_STEP
    ldmia r0!, {r5-r7}
    mov r8, r7
    ldmia r1!, {r0, r3, r4}
    movs r1, r3
1:  lsrs r3, r0, #21
    lsls r3, r3, #11
    lsrs r7, r1, #21
    lsls r7, r7, #21
    orrs r3, r7
    lsrs r7, r4, #21
    orrs r3, r7
    stmia r2!, {r3}
    adds r0, r0, r5
    adds r1, r1, r6
    add r4, r8
    cmp r2, r12
    blo 1b
    pop {r3}
    mov r8, r3
    pop {r4-r7, pc}

/* Bilinear. The frame: */
#define TEXELS 0
#define PALETTE 4
#define WIDTH 8
#define HEIGHT 12
#define DU 16
#define DV 20
#define SMOOTH_END 24
#define MASK 28
#define HALF 32
#define SMOOTH_FRAME 36

/* A texel's fields at index \at, which becomes them. r6 and r7 are lost. */
.macro texel_565 at
    lsls \at, \at, #1
    mov r6, r8
    ldrh \at, [r6, \at]
    lsls r7, \at, #16
    orrs \at, r7
    mov r7, r9
    ands \at, r7
.endm

.macro texel_palette at
    mov r6, r8
    ldrb \at, [r6, \at]
    lsls \at, \at, #1
    ldr r6, [sp, #PALETTE]
    ldrh \at, [r6, \at]
    lsls r7, \at, #16
    orrs \at, r7
    mov r7, r9
    ands \at, r7
.endm

/* r8: texels, r9: the mask, r10: u, r11: v, r12: words; lr: a x b. In r0-r3 the places of four texels, in r4, r5 weights. */
.macro smooth_pixels texel
1:  mov r0, r10
    lsrs r0, r0, #16
    ldr r6, [sp, #WIDTH]
    muls r0, r6 /* x, Q16 */
    mov r2, r11
    lsrs r2, r2, #16
    ldr r7, [sp, #HEIGHT]
    muls r2, r7 /* y */
    lsls r4, r0, #16
    lsrs r4, r4, #27
    lsls r5, r2, #16
    lsrs r5, r5, #27
    lsrs r0, r0, #16
    adds r1, r0, #1
    cmp r1, r6
    bne 2f
    movs r1, #0
2:  lsrs r2, r2, #16
    adds r3, r2, #1
    cmp r3, r7
    bne 3f
    movs r3, #0
3:  muls r2, r6
    muls r3, r6
    adds r6, r0, r3 /* below, left */
    adds r3, r3, r1 /* below, right */
    adds r1, r1, r2
    adds r0, r0, r2
    movs r2, r6
    \texel r0
    \texel r1
    \texel r2
    \texel r3
    movs r6, r4
    muls r6, r5
    adds r6, #16
    lsrs r6, r6, #5 /* both */
    muls r3, r6
    movs r7, #32
    subs r7, r7, r4
    subs r7, r7, r5
    adds r7, r7, r6
    muls r0, r7
    subs r4, r4, r6
    subs r5, r5, r6
    muls r1, r4
    muls r2, r5
    adds r0, r0, r1
    adds r0, r0, r2
    adds r0, r0, r3
    ldr r6, [sp, #HALF]
    adds r0, r0, r6
    lsrs r0, r0, #5
    mov r6, r9
    ands r0, r6
    mov r2, r12
    stmia r2!, {r0}
    mov r12, r2
    ldr r0, [sp, #DU]
    add r10, r0
    ldr r0, [sp, #DV]
    add r11, r0
    ldr r0, [sp, #SMOOTH_END]
    cmp r2, r0
    blo 1b
.endm

    function glint_mesh_words_smooth
    enter SMOOTH_FRAME
    mov r12, r2
    str r3, [sp, #SMOOTH_END]
    adds r0, #GLINT_AT_OVER_PICTURE
    ldmia r0!, {r4-r7}
    mov r8, r4
    mov r2, sp
    stmia r2!, {r4-r7}
    movs r3, r5
    adds r0, #GLINT_AT_OVER_STEP - GLINT_AT_OVER_PICTURE - 16
    ldmia r0!, {r4, r5}
    ldr r6, [sp, #SMOOTH_END]
    stmia r2!, {r4, r5}
    ldr r4, =0x07e0f81f
    mov r9, r4
    ldr r5, =0x02008010
    str r5, [sp, #HALF]
    ldmia r1!, {r4, r5}
    mov r10, r4
    mov r11, r5
    cmp r3, #0
    bne .Lsmooth_palette
    smooth_pixels texel_565
    leave SMOOTH_FRAME
    .ltorg
.Lsmooth_palette:
    smooth_pixels texel_palette
    leave SMOOTH_FRAME

/* ---- Pixels ---- */

/* What a pixel's word in r4 becomes from the level in r5: fields; r6: the mask. */
.macro lit
    muls r4, r5
    add r4, r11
    lsrs r4, r4, #5
    mov r6, r10
    ands r4, r6
.endm

.macro put swap
    lsrs r5, r4, #16
    orrs r4, r5
    .if \swap
    rev16 r4, r4
    .endif
    mov r5, r12
    strh r4, [r0, r5]
.endm

/* r0: depth, r1: z, r2: nl, r3: words, r7: levels; r8: dz, r9: dnl, r10: the mask, r11: half, r12: off, lr: end. */
.macro shade_matt swap
    save
    ldr r7, =0x07e0f81f
    mov r10, r7
    ldr r7, =0x02008010
    mov r11, r7
    movs r7, r0
    adds r7, #GLINT_AT_SHADE_DZ
    ldmia r7!, {r1, r2}
    mov r8, r1
    mov r9, r2
    ldr r5, [r0, #GLINT_AT_SHADE_DARK]
    mov r6, sp
    subs r6, #4
    mov sp, r6
    str r5, [sp]
    movs r6, r0
    ldmia r6!, {r1, r2}
    adds r6, #8
    ldmia r6!, {r0, r3, r4, r5} /* depth, end, off, words */
    mov lr, r3
    mov r12, r4
    ldr r7, [r6, #GLINT_AT_SHADE_LEVELS - 32]
    movs r3, r5
1:  lsrs r5, r1, #16
    ldrh r6, [r0]
    cmp r5, r6
    bhs 3f
    strh r5, [r0]
    ldr r4, [r3]
    asrs r5, r2, #GLINT_ALBEDO_LEVEL_SHIFT
    bmi 4f
    mvns r5, r5
    ldrb r5, [r7, r5]
2:  lit
    put \swap
3:  adds r3, #4
    adds r0, #2
    add r1, r8
    add r2, r9
    cmp r0, lr
    blo 1b
    add sp, #4
    restore
4:  ldr r5, [sp]
    b 2b
    .ltorg
.endm

    function glint_mesh_shade_matt
    shade_matt 0
    function glint_mesh_shade_matt_swapped
    shade_matt 1

/* r3: back, r7: dt. The frame: */
#define LEVELS 0
#define SUMS 4
#define T_MAX 8
#define LIMIT 12
#define SHIFT 16
#define DARK 20
#define DDT 24
#define WORDS 28
#define GLOSSY_FRAME 32

.macro shade_glossy swap
    enter GLOSSY_FRAME
    ldr r7, =0x07e0f81f
    mov r10, r7
    ldr r7, =0x02008010
    mov r11, r7
    movs r7, r0
    adds r7, #GLINT_AT_SHADE_DZ
    ldmia r7!, {r1-r3}
    mov r8, r1
    mov r9, r2
    str r3, [sp, #DDT]
    mov r6, sp
    ldmia r7!, {r1-r5} /* levels, sums, t_max, limit, shift */
    stmia r6!, {r1-r5}
    ldr r1, [r7]
    str r1, [sp, #DARK]
    ldmia r0!, {r1-r4, r5, r6, r7} /* z, nl, back, dt, depth, end, off */
    mov lr, r6
    mov r12, r7
    ldr r7, [r0]
    str r7, [sp, #WORDS]
    movs r7, r4
    movs r0, r5
1:  lsrs r5, r1, #16
    ldrh r6, [r0]
    cmp r5, r6
    bhs 3f
    strh r5, [r0]
    ldr r4, [sp, #WORDS]
    ldr r4, [r4]
    asrs r5, r2, #GLINT_ALBEDO_LEVEL_SHIFT
    bmi 4f
    mvns r5, r5
    ldr r6, [sp, #LEVELS]
    ldrb r5, [r6, r5]
    lit
    ldr r6, [sp, #LIMIT]
    cmp r3, r6
    bls 5f
2:  put \swap
3:  ldr r5, [sp, #WORDS]
    adds r5, #4
    str r5, [sp, #WORDS]
    adds r0, #2
    add r1, r8
    add r2, r9
    subs r3, r3, r7
    ldr r5, [sp, #DDT]
    adds r7, r7, r5
    cmp r0, lr
    blo 1b
    leave GLOSSY_FRAME
4:  ldr r5, [sp, #DARK]
    lit
    b 2b
5:  movs r5, r3
    ldr r6, [sp, #T_MAX]
    cmp r3, r6
    bls 6f
    movs r5, r6
6:  ldr r6, [sp, #SHIFT]
    lsrs r5, r6
    lsls r5, r5, #2
    ldr r6, [sp, #SUMS]
    ldr r5, [r6, r5]
    adds r4, r4, r5
    mov r6, r10
    movs r5, r4
    bics r5, r6 /* fields that overflow */
    beq 2b
    lsrs r6, r5, #6
    orrs r4, r6
    lsrs r6, r5, #5
    subs r5, r5, r6
    orrs r4, r5
    mov r6, r10
    ands r4, r6
    b 2b
    .ltorg
.endm

    function glint_mesh_shade_glossy
    shade_glossy 0
    function glint_mesh_shade_glossy_swapped
    shade_glossy 1
#endif
