/* SPDX-License-Identifier: MIT
 * RV32: the counter of cycles. Under QEMU with -icount shift=0 it counts instructions, on Hazard3's Verilog cycles. */
#include "clock.h"

void clock_begin(void)
{
    __asm__ volatile(".option push\n\t.option arch, +zicsr\n\tcsrci mcountinhibit, 1\n\t.option pop" ::: "memory");
}

uint32_t clock_now(void)
{
    uint32_t cycles;
    __asm__ volatile(".option push\n\t.option arch, +zicsr\n\tcsrr %0, mcycle\n\t.option pop" : "=r"(cycles)::"memory");
    return cycles;
}
