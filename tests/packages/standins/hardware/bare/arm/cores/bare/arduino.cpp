/* SPDX-License-Identifier: MIT
 * Runs a sketch: setup, then loop, on the host WORDS[1] times, on a board 8 times. */
#include "Arduino.h"

#ifdef BARE /* started by firmware/ports */
extern "C" {
#include "machine.h"
}
static void put(char c)
{
    machine_put(c);
}
#else
#include <stdio.h>
#include <stdlib.h>
static void put(char c)
{
    putchar(c);
}
#endif

Stub_Serial Serial;

void Stub_Serial::print(char c)
{
    put(c);
}

void Stub_Serial::print(const char *text)
{
    for (; *text; text++)
        put(*text);
}

void Stub_Serial::print(unsigned long value, int base)
{
    const unsigned radix = (unsigned)base;
    if (value >= radix)
        print(value / radix, base);
    put("0123456789ABCDEF"[value % radix]);
}

void Stub_Serial::print(long value, int base)
{
    if (value < 0 && base == DEC)
        put('-');
    print(value < 0 && base == DEC ? 0 - (unsigned long)value : (unsigned long)value, base);
}

static void run(int loops)
{
    setup();
    for (; loops > 0; loops--)
        loop();
}

#ifdef BARE
extern "C" bool machine_run(volatile uint8_t *)
{
    run(8);
    return true;
}
#else
int main(int argc, char **argv)
{
    run(argc > 1 ? atoi(argv[1]) : 0);
    return 0;
}
#endif
