/* SPDX-License-Identifier: MIT
 * The conformance image of a bare machine. */
#include "conformance.h"
#include "conformance_expected.h"
#include "machine.h"

enum { PAINT = 0xa5, FRAME = 96 /* at most, of machine_run itself */ };

bool machine_run(volatile uint8_t *floor)
{
    const uintptr_t top = (uintptr_t)__builtin_frame_address(0);
    volatile uint8_t *lowest = floor;
    for (volatile uint8_t *at = floor; (uintptr_t)at < top - FRAME; at++)
        *at = PAINT;
    const struct conformance_sum sum = conformance_run(conformance_expected);
    while (*lowest == PAINT)
        lowest++;
    conformance_say("# stack: ");
    conformance_say_number((uint32_t)(top - FRAME - (uintptr_t)lowest));
    conformance_say(" bytes\n");
    conformance_say_number(sum.passed);
    conformance_say(" passed, ");
    conformance_say_number(sum.failed);
    conformance_say(" failed");
    if (sum.skipped) {
        conformance_say(", ");
        conformance_say_number(sum.skipped);
        conformance_say(" skipped");
    }
    conformance_say("\n");
    return sum.failed == 0;
}
