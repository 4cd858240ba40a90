/* SPDX-License-Identifier: MIT
 * Runs a sketch on the host: setup, then loop WORDS[1] times. */
#include "Arduino.h"

#include <stdio.h>

Stub_Serial Serial;

void Stub_Serial::print(long value)
{
    printf("%ld", value);
}

void Stub_Serial::print(char c)
{
    putchar(c);
}

void Stub_Serial::println(long value, int base)
{
    printf(base == HEX ? "%lX\n" : "%ld\n", value);
}

void Stub_Serial::println(const char *text)
{
    puts(text);
}

int main(int argc, char **argv)
{
    setup();
    for (int i = argc > 1 ? atoi(argv[1]) : 0; i > 0; i--)
        loop();
    return 0;
}
