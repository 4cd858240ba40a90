/* SPDX-License-Identifier: MIT
 * Cortex-M under QEMU, where with -icount shift=0 an instruction takes 1 ns of the machine's time: the SysTick of a 25 MHz
 * clock falls by 1 in 40 instructions; that of a Cortex-M55 board, of 32 MHz, by 4 in 125; on the AN505, of ARMv8-M, that of a 20 MHz clock
 * in 50. */
#include "clock.h"

#define SYST_CSR (*(volatile uint32_t *)0xe000e010)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018)
#define CPACR (*(volatile uint32_t *)0xe000ed88)
#if defined(__ARM_FEATURE_MVE)
enum { INSTRUCTIONS = 125, TICKS = 4, WRAP = 1 << 24 };
#elif defined(__ARM_ARCH_8M_MAIN__)
enum { INSTRUCTIONS = 50, TICKS = 1, WRAP = 1 << 24 };
#else
enum { INSTRUCTIONS = 40, TICKS = 1, WRAP = 1 << 24 };
#endif

void clock_begin(void)
{
#ifdef __ARM_FP
    CPACR |= UINT32_C(0xf) << 20; /* on with the floating-point unit */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
#endif
    SYST_RVR = WRAP - 1;
    SYST_CVR = 0;
    SYST_CSR = 5;
}

/* Steps of less than 2^24 ticks, 671 million instructions, between calls. */
uint32_t clock_now(void)
{
    static uint32_t ticks, last; /* the counter begins at 0, and falls */
    const uint32_t now = SYST_CVR;
    ticks += (last - now) & (WRAP - 1);
    last = now;
    return ticks / TICKS * INSTRUCTIONS + ticks % TICKS * INSTRUCTIONS / TICKS;
}
