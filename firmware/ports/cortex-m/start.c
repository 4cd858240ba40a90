/* SPDX-License-Identifier: MIT
 * Cortex-M starts by itself from this table. Only integers are used, so the floating-point unit of a Cortex-M4F stays off: an
 * instruction of it would fault. */
#include "run.h"

/* Initial stack pointer, reset, NMI, HardFault: others lead to HardFault while they are off. */
__attribute__((section(".vectors"), used)) static const void *const vectors[] = {stack_top, bare_run, bare_fault,
                                                                                 bare_fault};
