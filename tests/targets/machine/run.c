/* SPDX-License-Identifier: MIT */
#include "machine.h"

#include "../sweep.h"

enum { PAINT = 0xa5, FRAME = 64 /* at most, of machine_run itself */ };

void machine_run(volatile uint8_t *floor)
{
    const uintptr_t top = (uintptr_t)__builtin_frame_address(0);
    volatile uint8_t *lowest = floor;
    for (volatile uint8_t *at = floor; (uintptr_t)at < top - FRAME; at++)
        *at = PAINT;
    const uint64_t hash = sweep(&sweep_small);
    while (*lowest == PAINT)
        lowest++;
    sweep_print(hash, machine_put);
    sweep_print(top - FRAME - (uintptr_t)lowest, machine_put);
}
