/* SPDX-License-Identifier: MIT
 * Some lines of the scene, in flash; and a loop of CALIBRATION instructions, on AVR cycles, by hand, but for its return. */
#ifdef __AVR__
    .section .progmem.data, "a"
#else
    .section .rodata, "a"
#endif
.macro stored name file
    .balign 4
    .global \name
\name:
    .incbin "\file"
.endm
#ifdef __AVR__ /* the sphere's */
    .global lines_int16
lines_int16:
    .incbin "lines-int16.bin", 0, 15 * 320 * 6
#else
    stored lines_int16 lines-int16.bin
    stored lines_int8 lines-int8.bin
    stored lines_palette_offsets lines-palette-offsets.bin
    stored stored_palette palette.bin
    .global stored_palette_end
stored_palette_end:
#endif

#if defined __AVR__
    .section .text.calibration_loop, "ax"
    .global calibration_loop
calibration_loop: /* 3 + 65536 x (sbiw 2, nop 1, brne 2) - 1 of the last brne = 327682 */
    ldi r24, 0
    ldi r25, 0
    nop
1:  sbiw r24, 1
    nop
    brne 1b
    ret
#elif defined __riscv
    .section .text.calibration_loop, "ax"
    .global calibration_loop
calibration_loop: /* 2 + 499999 x 2 */
    li a0, 499999 /* lui, addi */
1:  addi a0, a0, -1
    bnez a0, 1b
    ret
#else
    .syntax unified
    .thumb
    .section .text.calibration_loop, "ax"
    .global calibration_loop
    .type calibration_loop, %function
    .thumb_func
calibration_loop: /* 1 + 1 + 499999 x 2 */
    nop
    ldr r0, =499999
1:  subs r0, r0, #1
    bne 1b
    bx lr
    .ltorg
#endif
