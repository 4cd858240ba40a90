/* SPDX-License-Identifier: MIT
 * Functions whose cycles are known from the Cortex-M0+ manual (RP2040: muls in 1), by which the emulator's counts are
 * checked before anything is measured. The expected counts stand in m0plus.mjs; the return by bx lr takes 2. */
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
