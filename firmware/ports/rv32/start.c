/* SPDX-License-Identifier: MIT
 * RV32 on QEMU's machine virt: output by its UART, exit by its test device. */
#include "bare.h"

void run(void);

void machine_put(char c)
{
    *(volatile uint8_t *)0x10000000 = (uint8_t)c;
}

__attribute__((used)) void run(void)
{
    bare_begin();
    *(volatile uint32_t *)0x100000 = machine_run(stack_floor) ? 0x5555 : 0x13333; /* exit status 0 or 1 */
    for (;;)
        ;
}

__asm__(".section .vectors, \"ax\"\n"
        ".global start\n"
        "start: la sp, stack_top\n"
        "       j run\n");
