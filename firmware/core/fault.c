/* SPDX-License-Identifier: MIT */
#include "fault.h"

const char *fault_text(enum fault fault)
{
    static const char *const texts[FAULTS] = {
        "",
        "the program hung and the watchdog restarted it",
        "the supply voltage dipped",
        "the map in flash is damaged: load the image again",
        "the panel's bus failed",
        "the library refused the material",
        "the image was built for an unknown panel",
    };
    return texts[fault < FAULTS ? fault : FAULT_NONE];
}

void fault_line(uint16_t *pixels, uint16_t width, uint16_t height, uint16_t y, enum fault fault)
{
    const unsigned ninth = 9u * y / height; /* the bar takes three ninths, the blocks one */
    const bool in_bar = ninth / 3 == 1, in_blocks = ninth == 4;
    const unsigned slots = 2 * (FAULTS - 1) + 1; /* blocks, the gaps between them, and a gap at each end */
    for (unsigned x = 0; x < width; x++) {
        const unsigned slot = x * slots / width;
        const bool in_block = in_blocks && slot % 2 && slot / 2 < (unsigned)fault;
        pixels[x] = in_block ? FAULT_WHITE : in_bar ? FAULT_RED : FAULT_BLACK;
    }
}

static void sent(void *argument)
{
    *(volatile uint8_t *)argument = 1;
}

bool fault_draw(const struct hal *hal, const struct panel *panel, uint16_t *line, enum fault fault)
{
    if (!panel_window(panel, 0, 0, panel->width, panel->height))
        return false;
    for (uint16_t y = 0; y < panel->height; y++) {
        volatile uint8_t is_sent = 0; /* no bool: with -fsanitize=bool gcc 12 reads a volatile one once */
        fault_line(line, panel->width, panel->height, y, fault);
        hal->flush(hal->context, line, panel->width, sent, (void *)&is_sent);
        while (!is_sent)
            ;
    }
    return true;
}
