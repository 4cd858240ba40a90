/* SPDX-License-Identifier: MIT
 *
 * What a board shows and says when something is wrong. On the panel: a red bar across black, with as many white blocks as
 * the fault's number, from the left. */
#ifndef FAULT_H
#define FAULT_H

#include "hal.h"

enum fault {
    FAULT_NONE,
    FAULT_HUNG,   /* the program hung and the watchdog restarted it */
    FAULT_SUPPLY, /* the supply voltage dipped while it ran */
    FAULT_MAP,    /* the checksum of the normal map in flash is wrong */
    FAULT_BUS,    /* the panel's bus failed */
    FAULT_TABLES, /* the library refused the material */
    FAULT_BUILD,  /* the image was built for an unknown panel, or its memory is too small */
    FAULTS
};
enum { FAULT_BLACK = 0x0000, FAULT_RED = 0xf800, FAULT_WHITE = 0xffff };

const char *fault_text(enum fault fault);
/* Line y of the picture, `width` pixels. */
void fault_line(uint16_t *pixels, uint16_t width, uint16_t height, uint16_t y, enum fault fault);
/* The picture on the panel; returns when it is complete. `line`: a line's memory. False: the bus failed. */
bool fault_draw(const struct hal *hal, const struct panel *panel, uint16_t *line, enum fault fault);

#endif
