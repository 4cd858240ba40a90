/* SPDX-License-Identifier: MIT
 * Fuzzes the virtual panel with what may be on its bus. Input: the glass (9 bytes), then commands (0, command) and data
 * (count, bytes). */
#include <string.h>

#include "fuzz.h"
#include "sinks/panel/virtual_panel.h"

static struct virtual_panel panel;

static void look(void)
{
    const size_t bytes = 3 * (size_t)panel.glass.width * panel.glass.height;
    uint8_t *const rgb = malloc(bytes);
    for (unsigned rotation = 0; rotation < 4; rotation++)
        virtual_panel_look(&panel, rotation, rgb);
    if (!(panel.awake && panel.on && panel.lit))
        for (size_t i = 0; i < bytes; i++)
            check(rgb[i] == 0);
    free(rgb);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    struct virtual_glass glass = {.width = (uint16_t)(1 + next_word(&input) % PANEL_COLUMNS),
                                  .height = (uint16_t)(1 + next_word(&input) % PANEL_ROWS)};
    glass.x = (uint16_t)(next_word(&input) % (unsigned)(PANEL_COLUMNS + 1 - glass.width));
    glass.y = (uint16_t)(next_word(&input) % (unsigned)(PANEL_ROWS + 1 - glass.height));
    const unsigned wiring = next_byte(&input);
    glass.mirrored = wiring & 1;
    glass.bgr = wiring & 2;
    glass.inverted = wiring & 4;
    virtual_panel_init(&panel, &glass);
    while (input.at < input.end) {
        size_t count = next_byte(&input);
        if (count == 0) {
            virtual_panel_command(&panel, (uint8_t)next_byte(&input));
            continue;
        }
        if (count == 255)
            virtual_panel_reset(&panel);
        if (count == 254)
            count = 1000; /* more than a line */
        uint8_t *const bytes = next_bytes(&input, &count);
        virtual_panel_data(&panel, bytes, count);
        free(bytes);
    }
    look();
    return 0;
}
