/* SPDX-License-Identifier: MIT
 * What every start-up code leads to. */
#include "run.h"
#include "machine.h"
#include "memory.h"

void bare_run(void)
{
    bare_memory();
    machine_end(machine_run(stack_floor));
}

void bare_fault(void)
{
    static const char text[] = "fault\n";
    for (const char *at = text; *at; at++)
        machine_put(*at);
    machine_end(false);
}
