/* SPDX-License-Identifier: MIT
 * Cortex-M: output and exit by semihosting, of QEMU or of a debug probe. Only integers are used, so the floating-point unit of a Cortex-M4F
 * stays off: an instruction of it would fault. */
#include "bare.h"

void start(void);

static void semihosting(int32_t operation, const void *argument)
{
    register int32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void machine_put(char c)
{
    semihosting(3, &c); /* SYS_WRITEC */
}

static void end(bool well) /* SYS_EXIT: ADP_Stopped_ApplicationExit, ADP_Stopped_RunTimeErrorUnknown */
{
    semihosting(0x18, (const void *)(well ? 0x20026 : 0x20023));
    for (;;)
        ;
}

void start(void)
{
    bare_begin();
    end(machine_run(stack_floor));
}

static void fault(void)
{
    static const char text[] = "fault\n";
    for (const char *at = text; *at; at++)
        machine_put(*at);
    end(false);
}

/* Initial stack pointer, reset, NMI, HardFault: others lead to HardFault while they are off. */
__attribute__((section(".vectors"), used)) static const void *const vectors[] = {stack_top, start, fault, fault};
