/* SPDX-License-Identifier: MIT
 * A Cortex-A15 of QEMU's `virt`, whose data lie in memory as the image says. The compiler has no library for the order of big-endian data. */
#include "machine.h"
#include "run.h"

#include <stdint.h>

enum { UART = 0x09000000, POWER_OFF = (int)0x84000008 };

void machine_put(char c)
{
    *(volatile uint8_t *)UART = (uint8_t)c;
}

void machine_end(bool well)
{
    register int call __asm__("r0") = POWER_OFF;
    (void)well;
    for (;;)
        __asm__ volatile(".arch_extension virt\n hvc #0" : "+r"(call));
}

void _start(void);
__attribute__((naked, section(".start"))) void _start(void)
{
    __asm__("ldr sp, =stack_top\n b bare_run\n .ltorg");
}

/* ---- divisions, which compilers call ---- */

struct division {
    uint64_t quotient, rest;
};

void divide(uint64_t a, uint64_t b, struct division *out);
void divide(uint64_t a, uint64_t b, struct division *out)
{
    uint64_t quotient = 0, rest = 0;
    for (uint64_t bit = (uint64_t)1 << 63; bit; bit >>= 1) {
        rest = rest << 1 | ((a & bit) != 0);
        quotient |= rest >= b ? bit : 0;
        rest -= rest >= b ? b : 0;
    }
    out->quotient = quotient;
    out->rest = rest;
}

void divide_signed(int64_t a, int64_t b, struct division *out);
void divide_signed(int64_t a, int64_t b, struct division *out)
{
    divide(a < 0 ? 0 - (uint64_t)a : (uint64_t)a, b < 0 ? 0 - (uint64_t)b : (uint64_t)b, out);
    if ((a < 0) != (b < 0))
        out->quotient = 0 - out->quotient;
    if (a < 0)
        out->rest = 0 - out->rest;
}

/* The quotient in r0, r1, the rest in r2, r3. */
#define DIVISION(name, function)                                                                                       \
    void name(void);                                                                                                   \
    __attribute__((naked)) void name(void)                                                                             \
    {                                                                                                                  \
        __asm__("push {r4, lr}\n sub sp, #24\n add r4, sp, #8\n str r4, [sp]\n bl " #function                          \
                "\n ldrd r0, r1, [sp, #8]\n ldrd r2, r3, [sp, #16]\n add sp, #24\n pop {r4, pc}");                     \
    }
DIVISION(__aeabi_uldivmod, divide)
DIVISION(__aeabi_ldivmod, divide_signed)
