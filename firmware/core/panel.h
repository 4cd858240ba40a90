/* SPDX-License-Identifier: MIT
 *
 * MIPI-DCS panels: how to start one, where the next pixels go, how to leave it. Bytes go out through a bus that the
 * caller provides: the firmware's SPI, or the host's GPIO lines. */
#ifndef PANEL_H
#define PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum panel_controller { PANEL_ST7789, PANEL_ILI9341 };

/* What panel.c needs of a board. Functions return false where the bus failed; then the panel call does, too. */
struct panel_bus {
    bool (*command)(void *context, uint8_t command);                 /* one byte, D/C low */
    bool (*data)(void *context, const uint8_t *bytes, size_t count); /* D/C high */
    bool (*reset)(void *context, bool active); /* the reset line; NULL: there is none, the command does */
    bool (*backlight)(void *context, bool on); /* NULL: there is none */
    void (*wait_ms)(void *context, unsigned ms);
    void *context;
};

/* Config, set by you. */
struct panel {
    const struct panel_bus *bus;
    uint8_t controller;          /* enum panel_controller */
    uint8_t rotation;            /* quarter turns clockwise, 0..3 */
    uint16_t width, height;      /* as seen, after the rotation */
    uint16_t x_offset, y_offset; /* where the glass starts in the controller's memory, after the rotation */
    bool bgr, inverted;          /* how the glass is wired: see panel_defaults */
};

/* What is usual for a controller: 240x320, its wiring; ST7789 of 240x240 and 135x240 also get their offsets. Returns
 * false where the controller has no such glass. */
bool panel_defaults(struct panel *panel, enum panel_controller controller, uint8_t rotation, uint16_t width,
                    uint16_t height);
/* Reset, initialisation, RGB565, display on with a black picture, then the backlight. */
bool panel_start(const struct panel *panel);
/* A window and the command that takes its pixels: width x height RGB565, high byte first, follow by bus->data. */
bool panel_window(const struct panel *panel, uint16_t x, uint16_t y, uint16_t width, uint16_t height);
/* Ends what may be half-sent, black, backlight off, display off, asleep. */
bool panel_stop(const struct panel *panel);

#endif
