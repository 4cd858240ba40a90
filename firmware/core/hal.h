/* SPDX-License-Identifier: MIT
 *
 * What the portable device code needs of a board; a port fills in one of these. */
#ifndef HAL_H
#define HAL_H

#include "panel.h"

struct hal {
    struct panel_bus bus; /* commands and their data: they return when the bytes are on their way, in order */
    /* Pixels into the window that panel_window opened, RGB565 in the machine's order. Returns at once; done(argument) is
     * called, from an interrupt perhaps, when the pixels may be overwritten and the next flush may come. One at a
     * time: the next one waits; done() itself may start it. */
    void (*flush)(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument);
    /* Words from flash into RAM ahead of their use. Returns at once; fetched() is true when they are there. One at a time.
     * NULL: flash is as fast as RAM, and maps are read where they are. */
    void (*fetch)(void *context, uint32_t *to, const uint32_t *from, size_t words);
    bool (*fetched)(void *context);
    /* Asked before a frame's first pixels until it returns true: keeps in step with the panel's scan. NULL: at any time. */
    bool (*may_begin)(void *context);
    /* Runs job(argument) on another core and returns at once; join() returns when it is done. One at a time. NULL: one
     * core only. */
    void (*fork)(void *context, void (*job)(void *), void *argument);
    void (*join)(void *context);
    void *context;
};

#endif
