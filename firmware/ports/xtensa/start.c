/* SPDX-License-Identifier: MIT
 * Xtensa lx106 on QEMU's machine sim: output and exit by its simulator calls. */
#include "bare.h"

enum { CALL_EXIT = 1, CALL_WRITE = 4, STANDARD_OUTPUT = 1 };

void run(void);
void fault(void);

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

static void end(bool well) /* exit status 0 or 1 */
{
    simulator(CALL_EXIT, !well, 0, 0);
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
        "       movi a2, run\n"
        "       jx a2\n"
        ".align 4\n"
        "trap:  movi a1, stack_top\n"
        "       movi a2, fault\n"
        "       jx a2\n");
