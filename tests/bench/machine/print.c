/* SPDX-License-Identifier: MIT */
#include "clock.h"

#include "machine.h"

void print_text(const char *text)
{
    while (*text)
        machine_put(*text++);
    machine_put(';');
}

void print_number(uint32_t number)
{
    char digits[11];
    unsigned count = 0;
    do
        digits[count++] = (char)('0' + number % 10);
    while (number /= 10);
    while (count)
        machine_put(digits[--count]);
    machine_put(';');
}

void print_end(void)
{
    machine_put('\n');
}

void print_calibration(void)
{
    const uint32_t start = clock_now();
    calibration_loop();
    const uint32_t counted = clock_now() - start;
    print_text("calibration");
    print_number(CALIBRATION);
    print_number(counted);
    print_end();
}
