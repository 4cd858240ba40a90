/* SPDX-License-Identifier: MIT
 * Cortex-M starts by itself from this table. Only integers are used, so the floating-point unit of a Cortex-M4F stays off: an
 * instruction of it would fault. Helium's vectors of integers lie in its registers: there it is on. */
#include "run.h"
#include <stdint.h>

#ifdef __ARM_FEATURE_MVE
static void start_vectors(void)
{
    *(volatile uint32_t *)0xe000ed88 |= (uint32_t)15 << 20; /* CPACR: CP10 and CP11 */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    bare_run();
}
#define START start_vectors
#else
#define START bare_run
#endif

/* Initial stack pointer, reset, NMI, HardFault: others lead to HardFault while they are off. */
__attribute__((section(".vectors"), used)) static const void *const vectors[] = {stack_top, START, bare_fault,
                                                                                 bare_fault};
