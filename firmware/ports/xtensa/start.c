/* SPDX-License-Identifier: MIT
 * Xtensa lx106 starts here: a place for its vectors, a stack, then run.h. */
/* The first byte is where the core starts. The same place serves as its vectors' base; each kind of exception has its
 * offset there (debug 0x10, NMI 0x20, kernel 0x30, user 0x50, double 0x70), and all lead to the fault. */
__asm__(".section .vectors, \"ax\"\n"
        ".global start\n"
        "start: j begin\n"
        ".org 0x10\n j trap\n"
        ".org 0x20\n j trap\n"
        ".org 0x30\n j trap\n"
        ".org 0x50\n j trap\n"
        ".org 0x70\n j trap\n"
        ".literal_position\n"
        ".align 4\n"
        "begin: movi a2, start\n"
        "       wsr a2, vecbase\n"
        "       movi a2, 0x20\n" /* user mode, no exception, all interrupts but the highest on: none is enabled */
        "       wsr a2, ps\n"
        "       isync\n"
        "       movi a1, stack_top\n"
        "       movi a0, 0\n"
        "       movi a2, bare_run\n"
        "       jx a2\n"
        ".align 4\n"
        "trap:  movi a1, stack_top\n"
        "       movi a2, bare_fault\n"
        "       jx a2\n");
