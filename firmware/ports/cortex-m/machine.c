/* SPDX-License-Identifier: MIT
 * Cortex-M: output and exit by semihosting, of QEMU or of a debug probe. */
#include "machine.h"

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

void machine_end(bool well) /* SYS_EXIT: ADP_Stopped_ApplicationExit, ADP_Stopped_RunTimeErrorUnknown */
{
    semihosting(0x18, (const void *)(well ? 0x20026 : 0x20023));
    for (;;)
        ;
}
