/* SPDX-License-Identifier: MIT
 * A program that uses the installed library: a value of each model, as each build system must print it. */
#include <glint.h>

#ifdef BARE /* on a board without an operating system, started by firmware/ports */
#include "machine.h"
static void put(char c)
{
    machine_put(c);
}
#else
#include <stdio.h>
static void put(char c)
{
    putchar(c);
}
#endif

static void put_number(uint32_t value)
{
    if (value >= 10)
        put_number(value / 10);
    put((char)('0' + value % 10));
}

static void put_values(void)
{
    for (uint32_t model = 0; model < GLINT_MODEL_COUNT; model++) {
        put_number(glint_eval((enum glint_model)model, 60, 65000));
        put(' ');
    }
    put('\n');
}

#ifdef BARE
bool machine_run(volatile uint8_t *floor)
{
    (void)floor;
    put_values();
    return true;
}
#else
int main(void)
{
    put_values();
    return 0;
}
#endif
