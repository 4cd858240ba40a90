/* SPDX-License-Identifier: MIT
 * RV32 on QEMU's machine virt: output by its UART, exit by its test device. */
#include "bare.h"

void run(void);
void fault(void);

void machine_put(char c)
{
    *(volatile uint8_t *)0x10000000 = (uint8_t)c;
}

static void end(bool well) /* exit status 0 or 1 */
{
    *(volatile uint32_t *)0x100000 = well ? 0x5555 : 0x13333;
    for (;;)
        ;
}

__attribute__((used)) void run(void)
{
    bare_begin();
    end(machine_run(stack_floor));
}

__attribute__((used)) void fault(void)
{
    static const char text[] = "fault\n";
    for (const char *at = text; *at; at++)
        machine_put(*at);
    end(false);
}

/* Without mtvec a trap would go to address 0, and trap there, for ever. */
__asm__(".section .vectors, \"ax\"\n"
        ".option arch, +zicsr\n"
        ".global start\n"
        "start: la sp, stack_top\n"
        "       la t0, trap\n"
        "       csrw mtvec, t0\n"
        "       j run\n"
        ".balign 4\n"
        "trap:  la sp, stack_top\n"
        "       j fault\n");
