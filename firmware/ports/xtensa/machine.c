/* SPDX-License-Identifier: MIT
 * QEMU's machine sim for Xtensa: output and exit by its simulator calls. */
#include "machine.h"

enum { CALL_EXIT = 1, CALL_WRITE = 4, STANDARD_OUTPUT = 1 };

static void simulator(uint32_t call, uint32_t first, const void *second, uint32_t third)
{
    register uint32_t a2 __asm__("a2") = call;
    register uint32_t a3 __asm__("a3") = first;
    register const void *a4 __asm__("a4") = second;
    register uint32_t a5 __asm__("a5") = third;
    __asm__ volatile("simcall" : "+r"(a2), "+r"(a3) : "r"(a4), "r"(a5) : "memory");
}

void machine_put(char c)
{
    simulator(CALL_WRITE, STANDARD_OUTPUT, &c, 1);
}

void machine_end(bool well)
{
    simulator(CALL_EXIT, !well, 0, 0);
    for (;;)
        ;
}
