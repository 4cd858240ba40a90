/* SPDX-License-Identifier: MIT
 * The end of glint_mesh_triangle_set, whose frame it takes over: glint_mesh_values_set, as mesh_gradient.c has it: slopes, the depth, nl, and t
 * where it may shine. The slopes lie in the frame in the order in which sums of two products take them; e is kept 18 less, so that
 * its sign tells how what is linear is shifted. */
#if defined GLINT_CORTEX_M0PLUS_ASM && GLINT_CORTEX_M0PLUS_ASM
#include "cortex_m0plus_gradient.inc"

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
    b .Lmay_shine
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
    adds r1, #18 - 12
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
    movs r0, #1
    add sp, #FRAME
    pop {r4-r7, pc}

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

.Lmay_shine: /* Matt if t, which is lower between the corners by a side at most, stays beyond t_end. */
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
    bhi .Lwide
    ldr r1, [sp, #BEYOND]
    cmp r1, r0
    bls 1f
    movs r3, #GLINT_SHINE_MATT
    str r3, [sp, #SHINE]
1:  b .Lshine_known
.Lwide:
    movs r3, #FLAT
    str r3, [sp, #SHINE]
    b .Lshine_known

.Lt:
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
