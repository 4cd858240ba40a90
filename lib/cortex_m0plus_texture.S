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

/* ---- Lines ----
 * glint_mesh_albedo_part(albedo, triangle, part, target, over), as fused_mesh.c has it, without perspective: a line's columns, then for up
 * to 16 pixels words and pixels by two routines that are chosen once, which keep to this frame. */
#define L_LEFT 0
#define L_RIGHT 4
#define L_STEPS 8 /* of left and right */
#define L_DEPTH 16
#define L_OFF 20
#define L_DEPTH_STEP 24
#define L_OFF_STEP 28
#define L_LINES 32
#define L_W 36
#define L_TRIANGLE 40
#define L_OVER 44
#define L_VALUES_X 48
#define L_OVER_X 52
#define L_WORDS 56
#define L_SHADE 60
#define L_DZ 64
#define L_DNL 68
#define L_DDT 72
#define L_LEVELS 76
#define L_SUMS 80
#define L_T_MAX 84
#define L_LIMIT 88
#define L_SHIFT 92
#define L_DARK 96
#define L_FROM 100
#define L_TO 104
#define L_COUNT 108
#define L_MEMORY 112
#define L_MASK 116
#define L_HALF 120
#define L_AT 124
#define L_RETURN 128
#define L_ALBEDO 132
#define L_PART 136
#define L_TARGET 140
#define L_GLOSSY 144
#define L_FRAME 148 /* with what is saved a multiple of 8 */

#define OVER_LINE (GLINT_AT_OVER_STEP + 12)

    function glint_mesh_albedo_part
    enter L_FRAME
    ldr r7, [sp, #L_FRAME + SAVED]
    str r0, [sp, #L_ALBEDO]
    str r1, [sp, #L_TRIANGLE]
    str r2, [sp, #L_PART]
    str r3, [sp, #L_TARGET]
    str r7, [sp, #L_OVER]
    ldr r4, [r7, #GLINT_AT_OVER_PICTURE - 8]
    str r4, [sp, #L_OVER_X]
    ldr r4, [r1, #GLINT_AT_TRIANGLE_X]
    str r4, [sp, #L_VALUES_X]
    ldmia r2!, {r4-r6} /* left, right, end */
    ldmia r4!, {r2}
    str r2, [sp, #L_LEFT]
    ldr r2, [r4]
    str r2, [sp, #L_STEPS]
    ldmia r5!, {r2}
    str r2, [sp, #L_RIGHT]
    ldr r2, [r5]
    str r2, [sp, #L_STEPS + 4]
    adds r1, #GLINT_AT_TRIANGLE_Y
    movs r4, #0
    ldrsh r2, [r1, r4]
    subs r4, r6, r2
    str r4, [sp, #L_LINES]
    strh r6, [r1]
    ldmia r3!, {r1, r4, r5, r6} /* surface, depth, w, y */
    str r5, [sp, #L_W]
    lsls r5, r5, #1
    str r5, [sp, #L_DEPTH_STEP]
    subs r2, r2, r6
    muls r5, r2
    adds r4, r4, r5
    str r4, [sp, #L_DEPTH]
    ldmia r1!, {r5, r6} /* pixels, stride */
    ldr r1, [sp, #L_DEPTH_STEP]
    subs r1, r6, r1
    str r1, [sp, #L_OFF_STEP]
    muls r6, r2
    adds r5, r5, r6
    subs r5, r5, r4
    str r5, [sp, #L_OFF]
    /* Steps and tables. */
    movs r1, r0
    adds r1, #GLINT_AT_SHADE_DZ
    add r2, sp, #L_DZ
    ldmia r1!, {r3-r6}
    stmia r2!, {r3-r6}
    ldmia r1!, {r3-r6}
    stmia r2!, {r3-r6}
    ldr r3, [r1]
    str r3, [r2]
    ldr r3, [r0, #GLINT_AT_SHADE_DARK + 12]
    str r3, [sp, #L_MEMORY]
    ldr r3, =0x07e0f81f
    str r3, [sp, #L_MASK]
    ldr r3, =0x02008010
    str r3, [sp, #L_HALF]
    /* Routines. */
    movs r1, #GLINT_AT_OVER_PICTURE + 16
    ldrb r2, [r7, r1]
    adds r1, #1
    ldrb r1, [r7, r1]
    ldr r3, [r7, #GLINT_AT_OVER_PICTURE + 4]
    ldr r4, =line_colours
    cmp r2, #3
    beq 1f
    ldr r4, =line_smooth
    cmp r1, #0
    bne 1f
    ldr r4, =line_nearest
    cmp r3, #0
    beq 1f
    ldr r4, =line_palette
1:  str r4, [sp, #L_WORDS]
    movs r1, #GLINT_AT_SHADE_DARK + 16
    ldrh r1, [r0, r1] /* is_glossy, is_swapped */
    lsls r4, r1, #31
    str r4, [sp, #L_GLOSSY]
    ldr r4, =line_matt
    cmp r1, #1
    blo 1f
    ldr r4, =line_glossy
    beq 1f
    ldr r4, =line_matt_swapped
    lsrs r1, r1, #1
    bcc 1f
    ldr r4, =line_glossy_swapped
1:  str r4, [sp, #L_SHADE]

.Lline:
    mov r7, sp
    ldmia r7!, {r0-r3}
    asrs r4, r0, #16
    bpl 1f
    movs r4, #0
1:  asrs r5, r1, #16
    adds r0, r0, r2
    adds r1, r1, r3
    mov r7, sp
    stmia r7!, {r0, r1}
    ldr r6, [sp, #L_W]
    cmp r5, r6
    ble 1f
    movs r5, r6
1:  subs r6, r5, r4
    ble .Lline_next
    str r5, [sp, #L_TO]
.Lline_more: /* r4: from, r6: how many are left */
    cmp r6, #16
    bls 1f
    movs r6, #16
1:  str r6, [sp, #L_COUNT]
    str r4, [sp, #L_FROM]
    ldr r7, [sp, #L_WORDS]
    blx r7
    ldr r7, [sp, #L_SHADE]
    blx r7
    ldr r4, [sp, #L_FROM]
    ldr r5, [sp, #L_COUNT]
    ldr r6, [sp, #L_TO]
    adds r4, r4, r5
    subs r6, r6, r4
    bne .Lline_more
.Lline_next:
    ldr r7, [sp, #L_OVER]
    movs r6, r7
    adds r6, #OVER_LINE
    ldmia r6!, {r0-r2} /* of a texture the third is not looked at */
    ldr r3, [r7, #8]
    adds r0, r0, r3
    ldr r3, [r7, #20]
    adds r1, r1, r3
    ldr r3, [r7, #32]
    adds r2, r2, r3
    subs r6, #12
    stmia r6!, {r0-r2}
    ldr r6, [sp, #L_TRIANGLE]
    ldr r7, [sp, #L_GLOSSY]
    cmp r7, #0
    bne 1f
    ldmia r6!, {r0, r1} /* z, nl */
    ldr r2, [r6, #GLINT_AT_TRIANGLE_ZY - 8]
    adds r0, r0, r2
    ldr r2, [r6, #GLINT_AT_TRIANGLE_NLY - 8]
    adds r1, r1, r2
    subs r6, #8
    stmia r6!, {r0, r1}
    b 2f
1:  ldmia r6!, {r0-r4} /* z, nl, t, tx, ty */
    adds r2, r2, r4
    ldmia r6!, {r5, r7} /* zy, nly */
    adds r0, r0, r5
    adds r1, r1, r7
    ldmia r6!, {r5, r7} /* txy, tyy */
    adds r3, r3, r5
    adds r4, r4, r7
    subs r6, #36
    stmia r6!, {r0-r4}
2:
    add r6, sp, #L_DEPTH
    ldmia r6!, {r0-r4}
    adds r0, r0, r2
    adds r1, r1, r3
    subs r6, #20
    stmia r6!, {r0, r1}
    subs r4, r4, #1
    str r4, [sp, #L_LINES]
    bne .Lline
    ldr r2, [sp, #L_PART]
    ldmia r2!, {r0, r1}
    ldr r3, [sp, #L_LEFT]
    str r3, [r0]
    ldr r3, [sp, #L_RIGHT]
    str r3, [r1]
    leave L_FRAME
    .ltorg

/* Words. From column r4. */
.macro line_begin u, v
    ldr r7, [sp, #L_OVER_X]
    subs r4, r4, r7
    ldr r7, [sp, #L_OVER]
    adds r7, #GLINT_AT_OVER_STEP
    ldmia r7!, {\u, \v}
    mov r8, \u
    mov r9, \v
    muls \u, r4
    muls \v, r4
    ldr r4, [r7, #4]
    adds \u, \u, r4
    ldr r4, [r7, #8]
    adds \v, \v, r4
    subs r7, #GLINT_AT_OVER_STEP + 8 - GLINT_AT_OVER_PICTURE
.endm

.macro line_memory
    ldr r3, [sp, #L_MEMORY]
    ldr r4, [sp, #L_COUNT]
    lsls r4, r4, #2
    adds r4, r4, r3
    mov r10, r4
    ldr r4, [sp, #L_MASK]
    mov r11, r4
.endm

.macro line_place
    lsrs r4, r1, #16
    muls r4, r6
    lsrs r4, r4, #16
    muls r4, r5
    lsrs r7, r0, #16
    muls r7, r5
    lsrs r7, r7, #16
    adds r4, r4, r7
.endm

.macro line_texel
    lsls r7, r4, #16
    orrs r4, r7
    mov r7, r11
    ands r4, r7
    stmia r3!, {r4}
    add r0, r8
    add r1, r9
    cmp r3, r10
    blo 1b
    bx lr
.endm

    .type line_nearest, %function
    .thumb_func
line_nearest:
    line_begin r0, r1
    ldmia r7!, {r2, r3, r5, r6}
    line_memory
1:  line_place
    lsls r4, r4, #1
    ldrh r4, [r2, r4]
    line_texel

    .type line_palette, %function
    .thumb_func
line_palette:
    line_begin r0, r1
    ldmia r7!, {r2, r3, r5, r6}
    mov r12, r3
    line_memory
1:  line_place
    ldrb r4, [r2, r4]
    lsls r4, r4, #1
    mov r7, r12
    ldrh r4, [r7, r4]
    line_texel

    .type line_smooth, %function
    .thumb_func
line_smooth: /* by its function */
    mov r0, lr
    str r0, [sp, #L_RETURN]
    line_begin r0, r1
    push {r0, r1}
    mov r1, sp
    movs r0, r7
    subs r0, #GLINT_AT_OVER_PICTURE
    ldr r2, [sp, #L_MEMORY + 8]
    ldr r3, [sp, #L_COUNT + 8]
    lsls r3, r3, #2
    adds r3, r3, r2
    bl glint_mesh_words_smooth
    add sp, #8
    ldr r0, [sp, #L_RETURN]
    bx r0

/* Red, green and blue: r0, r1, r2; r5-r7: their steps. Where one leaves its range, the line goes back to C. */
    .type line_colours, %function
    .thumb_func
line_colours:
    ldr r7, [sp, #L_OVER_X]
    subs r4, r4, r7
    ldr r3, [sp, #L_OVER]
    adds r3, #GLINT_AT_OVER_STEP
    ldmia r3!, {r5-r7}
    movs r0, r5
    muls r0, r4
    movs r1, r6
    muls r1, r4
    movs r2, r7
    muls r2, r4
    ldr r4, [r3]
    adds r0, r0, r4
    ldr r4, [r3, #4]
    adds r1, r1, r4
    ldr r4, [r3, #8]
    adds r2, r2, r4
    mov r8, r7
    mov r9, r0
    ldr r3, [sp, #L_TO]
    ldr r4, [sp, #L_FROM]
    subs r3, r3, r4
    subs r3, #1
    muls r7, r3
    adds r7, r7, r2
    orrs r7, r2
    movs r4, r5
    muls r4, r3
    adds r4, r4, r0
    orrs r7, r4
    orrs r7, r0
    muls r3, r6
    adds r3, r3, r1
    orrs r3, r1
    lsrs r3, r3, #27
    lsrs r7, r7, #26
    orrs r3, r7
    bne .Lheld
    ldr r3, [sp, #L_MEMORY]
    ldr r4, [sp, #L_COUNT]
    lsls r4, r4, #2
    adds r4, r4, r3
    mov r10, r4
1:  lsrs r4, r0, #21
    lsls r4, r4, #11
    lsrs r7, r1, #21
    lsls r7, r7, #21
    orrs r4, r7
    lsrs r7, r2, #21
    orrs r4, r7
    stmia r3!, {r4}
    adds r0, r0, r5
    adds r1, r1, r6
    add r2, r8
    cmp r3, r10
    blo 1b
    bx lr
.Lheld: /* glint_mesh_albedo_held(albedo, triangle, target, over, depth, from, to, y) */
    ldr r0, [sp, #L_ALBEDO]
    ldr r1, [sp, #L_OFF]
    str r1, [r0, #24]
    ldr r1, [sp, #L_PART]
    ldr r7, [r1, #8]
    ldr r1, [sp, #L_LINES]
    subs r7, r7, r1
    ldr r4, [sp, #L_DEPTH]
    ldr r5, [sp, #L_FROM]
    ldr r6, [sp, #L_TO]
    ldr r1, [sp, #L_TRIANGLE]
    ldr r2, [sp, #L_TARGET]
    ldr r3, [sp, #L_OVER]
    push {r4-r7}
    bl glint_mesh_albedo_held
    add sp, #16
    b .Lline_next
    .ltorg

/* Pixels. z, nl and what follows, r5: column after the triangle's; the depth and its end. */
.macro line_values
    mov r7, lr
    str r7, [sp, #L_RETURN]
    ldr r4, [sp, #L_FROM]
    ldr r5, [sp, #L_VALUES_X]
    subs r5, r4, r5
    ldr r0, [sp, #L_DEPTH]
    lsls r4, r4, #1
    adds r0, r0, r4
    ldr r4, [sp, #L_COUNT]
    lsls r4, r4, #1
    adds r4, r4, r0
    mov lr, r4
    ldr r6, [sp, #L_TRIANGLE]
    ldmia r6!, {r1, r2}
    ldr r7, [sp, #L_DZ]
    mov r8, r7
    muls r7, r5
    adds r1, r1, r7
    ldr r7, [sp, #L_DNL]
    mov r9, r7
    muls r7, r5
    adds r2, r2, r7
    ldr r4, [sp, #L_MASK]
    mov r10, r4
    ldr r4, [sp, #L_HALF]
    mov r11, r4
    ldr r4, [sp, #L_OFF]
    mov r12, r4
.endm

.macro line_matt_pixels swap
    line_values
.Lmisses\swap:
    ldr r3, [sp, #L_MEMORY]
    ldr r7, [sp, #L_LEVELS]
1:  ldmia r3!, {r4}
    lsrs r5, r1, #16
    ldrh r6, [r0]
    cmp r5, r6
    bhs 3f
    strh r5, [r0]
    asrs r5, r2, #GLINT_ALBEDO_LEVEL_SHIFT
    bmi 4f
    mvns r5, r5
    ldrb r5, [r7, r5]
2:  lit
    put \swap
3:  adds r0, #2
    add r1, r8
    add r2, r9
    cmp r0, lr
    blo 1b
    ldr r7, [sp, #L_RETURN]
    bx r7
4:  ldr r5, [sp, #L_DARK]
    b 2b
.endm

    .type line_matt, %function
    .thumb_func
line_matt:
    line_matt_pixels 0
    .type line_matt_swapped, %function
    .thumb_func
line_matt_swapped:
    line_matt_pixels 1
/* r3: back, r7: dt. */
.macro line_glossy_pixels swap
    line_values
    ldmia r6!, {r3, r4} /* t, tx */
    movs r7, r4
    muls r7, r5
    adds r3, r3, r7
    ldr r6, [sp, #L_DDT]
    subs r7, r5, #1
    muls r7, r5
    asrs r7, r7, #1
    muls r7, r6
    adds r3, r3, r7
    muls r6, r5
    adds r7, r4, r6
    ldr r4, [sp, #L_T_MAX]
    subs r3, r4, r3
    bpl .Lhits\swap
    /* Past t_max here, and at all pixels if it is at the last one and t only grows or only falls (cortex_m0plus_mesh.S): r5: the pixels less 1. */
    ldr r5, [sp, #L_COUNT]
    subs r5, #1
    ldr r6, [sp, #L_DDT]
    asrs r4, r6, #31
    eors r4, r6
    lsrs r4, r4, #26
    bne .Lhits\swap
    subs r4, r5, #1
    muls r4, r5
    asrs r4, r4, #1
    muls r4, r6
    muls r6, r5
    adds r6, r6, r7
    muls r5, r7
    adds r4, r4, r5
    subs r4, r3, r4
    bpl .Lhits\swap
    asrs r5, r7, #31
    eors r6, r5
    eors r5, r7
    orrs r6, r5
    lsrs r6, r6, #26
    bne .Lhits\swap
    b .Lmisses\swap
.Lhits\swap:
    ldr r4, [sp, #L_MEMORY]
    str r4, [sp, #L_AT]
1:  lsrs r5, r1, #16
    ldrh r6, [r0]
    cmp r5, r6
    bhs 3f
    strh r5, [r0]
    ldr r4, [sp, #L_AT]
    ldr r4, [r4]
    asrs r5, r2, #GLINT_ALBEDO_LEVEL_SHIFT
    bmi 4f
    mvns r5, r5
    ldr r6, [sp, #L_LEVELS]
    ldrb r5, [r6, r5]
    lit
    ldr r6, [sp, #L_LIMIT]
    cmp r3, r6
    bls 5f
2:  put \swap
3:  ldr r5, [sp, #L_AT]
    adds r5, #4
    str r5, [sp, #L_AT]
    adds r0, #2
    add r1, r8
    add r2, r9
    subs r3, r3, r7
    ldr r5, [sp, #L_DDT]
    adds r7, r7, r5
    cmp r0, lr
    blo 1b
    ldr r7, [sp, #L_RETURN]
    bx r7
4:  ldr r5, [sp, #L_DARK]
    lit
    b 2b
5:  movs r5, r3
    ldr r6, [sp, #L_T_MAX]
    cmp r3, r6
    bls 6f
    movs r5, r6
6:  ldr r6, [sp, #L_SHIFT]
    lsrs r5, r6
    lsls r5, r5, #2
    ldr r6, [sp, #L_SUMS]
    ldr r5, [r6, r5]
    adds r4, r4, r5
    mov r6, r10
    movs r5, r4
    bics r5, r6
    beq 2b
    lsrs r6, r5, #6
    orrs r4, r6
    lsrs r6, r5, #5
    subs r5, r5, r6
    orrs r4, r5
    mov r6, r10
    ands r4, r6
    b 2b
.endm

    .type line_glossy, %function
    .thumb_func
line_glossy:
    line_glossy_pixels 0
    .type line_glossy_swapped, %function
    .thumb_func
line_glossy_swapped:
    line_glossy_pixels 1
    .ltorg
#endif
