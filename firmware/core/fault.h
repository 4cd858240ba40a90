/* SPDX-License-Identifier: MIT
 *
 * What a board shows and says where something is wrong. On the panel: a red bar across black, and on it as many white
 * blocks, from the left, as the fault's number. */
#ifndef FAULT_H
#define FAULT_H

#include "hal.h"

enum fault {
    FAULT_NONE,
    FAULT_HUNG,   /* the program stood still, and the watchdog has started it anew */
    FAULT_SUPPLY, /* the supply dipped while it ran */
    FAULT_MAP,    /* the normal map in flash is not the one that was baked */
    FAULT_BUS,    /* the panel's bus failed */
    FAULT_TABLES, /* the library refused the material */
    FAULT_BUILD,  /* there is no such panel, or its memory does not suffice */
    FAULTS
};
enum { FAULT_BLACK = 0x0000, FAULT_RED = 0xf800, FAULT_WHITE = 0xffff };

const char *fault_text(enum fault fault);
/* Line y of the picture, `width` pixels. */
void fault_line(uint16_t *pixels, uint16_t width, uint16_t height, uint16_t y, enum fault fault);
/* The picture on the panel; returns when it is there. `line`: a line's memory. False where the bus failed. */
bool fault_draw(const struct hal *hal, const struct panel *panel, uint16_t *line, enum fault fault);

#endif
