/* SPDX-License-Identifier: MIT
 * A Cortex-M0+ whose emulator calls start and then shows machine_text. */
#include "machine.h"

extern uint8_t stack_floor[]; /* from the linker script */
extern char machine_text[128];
char machine_text[128];
void start(void);

void machine_put(char c)
{
    static unsigned count;
    if (count < sizeof machine_text - 1)
        machine_text[count++] = c;
}

void start(void)
{
    machine_run(stack_floor);
}
