/* SPDX-License-Identifier: MIT
 *
 * Pixels that follow each other to the panel without a gap on the bus: an interrupt sends what waits next. */
#ifndef PIECES_H
#define PIECES_H

#include "hal.h"

enum { PIECES_MAX = 32 }; /* that wait or are on their way */

/* Whole lines of a picture of the panel's size, from the top. Of a round panel's what can be seen is sent, line by line. */
struct piece {
    const uint16_t *pixels;
    uint16_t y, lines;
};

struct pieces {
    /* Config, set by you. */
    const struct hal *hal;
    const struct panel *panel;

    /* State, ours; zeros at first. */
    volatile struct piece queue[PIECES_MAX];
    volatile uint32_t added; /* counted */
    uint32_t sent;           /* likewise; other cores may read it */
    uint16_t line;           /* of the piece on its way, if the panel is round: the one that is sent */
    volatile bool is_sending, has_failed;
};

/* Returns the count of `sent` from which on its pixels may be overwritten. At most PIECES_MAX may wait. */
uint32_t pieces_add(struct pieces *pieces, const uint16_t *pixels, unsigned y, unsigned lines);
/* Have as many been sent? */
bool pieces_are_sent(const struct pieces *pieces, uint32_t count);

#endif
