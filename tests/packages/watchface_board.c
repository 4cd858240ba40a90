/* SPDX-License-Identifier: MIT
 * The example watchface on a board that prints what a display would get, in hexadecimal. */
#include "machine.h"
#include "watchface.h"

void display_send(uint16_t y, uint16_t lines, const void *pixels, size_t bytes)
{
    static const char digits[] = "0123456789abcdef";
    const uint8_t *byte = (const uint8_t *)pixels;
    (void)y, (void)lines;
    for (size_t i = 0; i < bytes; i++) {
        machine_put(digits[byte[i] >> 4]);
        machine_put(digits[byte[i] & 15]);
    }
}

bool machine_run(volatile uint8_t *floor)
{
    static const int32_t to_light[3] = {-1, 1, 1}; /* that of glint render */
    (void)floor;
    return !watchface_init() && !watchface_draw(to_light);
}
