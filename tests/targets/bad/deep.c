/* SPDX-License-Identifier: MIT
 * Must be refused: two frames that are small enough each but not together, one called through a pointer. */
#include <stdint.h>

int bad_deep(int n);
int bad_call(int (*function)(int n), int n);

static int inner(int n)
{
    volatile uint8_t room[1000];
    room[n] = (uint8_t)n;
    return room[n];
}

__attribute__((noinline)) int bad_call(int (*function)(int n), int n)
{
    return function(n) + 1;
}

int bad_deep(int n)
{
    volatile uint8_t room[1000];
    room[n] = (uint8_t)n;
    return bad_call(inner, n) + room[n];
}
