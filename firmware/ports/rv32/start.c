/* SPDX-License-Identifier: MIT
 * RV32 starts here: a stack, a place for traps, then run.h. */
/* Without mtvec a trap would go to address 0, and trap there, for ever. */
__asm__(".section .vectors, \"ax\"\n"
        ".option arch, +zicsr\n"
        ".global start\n"
        "start: la sp, stack_top\n"
        "       la t0, trap\n"
        "       csrw mtvec, t0\n"
        "       j bare_run\n"
        ".balign 4\n"
        "trap:  la sp, stack_top\n"
        "       j bare_fault\n");
