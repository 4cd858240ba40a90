/* SPDX-License-Identifier: MIT
 * Functions whose cycles are known from the Cortex-M0+ manual (RP2040: muls in 1), by which the emulator's counts are
 * checked before anything is measured. The expected counts stand in calibrate.mjs; the return by bx lr takes 2. */
    .syntax unified
    .cpu cortex-m0plus
    .thumb

.macro function name
    .section .text.\name, "ax"
    .global \name
    .type \name, %function
    .thumb_func
\name:
.endm

    function calibrate_empty
    bx lr

    function calibrate_muls /* 10 muls of 1 */
    .rept 10
    muls r0, r1
    .endr
    bx lr

    function calibrate_alu /* 12 of 1 */
    .rept 4
    lsls r0, r0, #1
    adds r0, r0, r1
    uxth r0, r0
    .endr
    bx lr

    function calibrate_memory /* 5 loads and 3 stores of 2, 1 mov */
    mov r3, sp
    str r0, [r3]
    ldr r0, [r3]
    strh r0, [r3]
    ldrh r0, [r3]
    strb r0, [r3]
    ldrb r0, [r3]
    ldr r0, =0x12345678
    ldr r1, [r3]
    bx lr
    .ltorg

    function calibrate_loop /* movs 1; 100 times subs 1; 99 branches taken, 2; one not, 1 */
    movs r0, #100
1:  subs r0, #1
    bne 1b
    bx lr

    function calibrate_call /* push of 2 registers 3; bl 3, bx lr 2; pop of 2 registers, one of them pc, 5 */
    push {r4, lr}
    bl calibrate_empty
    pop {r4, pc}

    function calibrate_stack /* push of 3 registers 4, pop of 3 registers 4 */
    push {r4-r6}
    pop {r4-r6}
    bx lr

    function calibrate_jump /* b 2 over one that is not executed, beq not taken 1, bne taken 2, movs 1 */
    b 1f
    nop
1:  movs r0, #1
    beq 2f
    bne 2f
    nop
2:  bx lr

    function calibrate_multiple /* ldm and stm of N registers 1 + N, with writeback; push and pop as they; 5 of 1 */
    push {r4, r5}
    push {r4-r7}
    mov r3, sp
    mov r2, sp
    ldmia r3!, {r4-r7}
    stmia r2!, {r4, r5}
    mov r2, sp
    ldmia r2!, {r0, r1, r3, r4, r5}
    mov r2, sp
    adds r2, #0
    pop {r4-r7}
    pop {r4, r5}
    bx lr

    function calibrate_indexed /* 3 of 1; loads and stores with a register offset, 2 each */
    mov r3, sp
    movs r2, #0
    subs r3, #16
    strh r0, [r3, r2]
    ldrh r0, [r3, r2]
    strb r0, [r3, r2]
    ldrb r0, [r3, r2]
    ldrsb r0, [r3, r2]
    ldrsh r0, [r3, r2]
    str r0, [r3, r2]
    ldr r0, [r3, r2]
    bx lr

    function calibrate_sp /* by sp: 2 a load or store; 1 an add, sub, adr */
    sub sp, #16
    str r0, [sp]
    str r0, [sp, #4]
    str r0, [sp, #8]
    ldr r0, [sp]
    ldr r0, [sp, #4]
    ldr r0, [sp, #8]
    add r1, sp, #8
    nop
    add sp, #16
    bx lr

    function calibrate_high /* high registers: 1 each */
    mov r12, r0
    mov r8, r8
    add r12, r0
    add r0, r12
    add r12, r12
    cmp r12, r0
    cmp r0, r12
    cmp r8, r12
    mov r0, r12
    add r1, sp, #0
    adr r1, 1f
    negs r0, r0
    .balign 4
1:  bx lr

    function calibrate_conditions /* cmp 1; 7 branches taken, 2, 7 not, 1 */
.macro both yes no
    b\yes 1f
1:  b\no 1f
1:
.endm
    cmp r0, r0
    both eq ne
    both cs cc
    both pl mi
    both vc vs
    both ls hi
    both ge lt
    both le gt
    bx lr

    function calibrate_pointer /* as calibrate_call; ldr 2, blx 2 */
    push {r4, lr}
    ldr r3, =calibrate_empty
    blx r3
    pop {r4, pc}
    .ltorg
