/* SPDX-License-Identifier: MIT
 *
 * MIPI-DCS panels: how to start one, where the next pixels go, how to leave it. Bytes go out through a bus that the
 * caller provides: the firmware's SPI, or the host's GPIO lines. */
#ifndef PANEL_H
#define PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Stored as uint8_t. Both have 240 columns and 320 rows of memory, of which a smaller glass shows a part. */
enum panel_controller { PANEL_ST7789, PANEL_ILI9341, PANEL_CONTROLLERS };
enum { PANEL_COLUMNS = 240, PANEL_ROWS = 320 };

/* The commands of the MIPI Display Command Set that both know. */
enum panel_command {
    PANEL_NOP = 0x00,
    PANEL_SOFTWARE_RESET = 0x01,
    PANEL_SLEEP_IN = 0x10,
    PANEL_SLEEP_OUT = 0x11,
    PANEL_INVERSION_OFF = 0x20,
    PANEL_INVERSION_ON = 0x21,
    PANEL_DISPLAY_OFF = 0x28,
    PANEL_DISPLAY_ON = 0x29,
    PANEL_COLUMN_ADDRESS = 0x2a, /* CASET: first and last, 16 bits each, high byte first */
    PANEL_ROW_ADDRESS = 0x2b,    /* RASET */
    PANEL_MEMORY_WRITE = 0x2c,   /* RAMWR: from the window's first pixel */
    PANEL_TEARING_OFF = 0x34,
    PANEL_TEARING_ON = 0x35, /* a byte, 0: the line is high while no row is scanned */
    PANEL_MADCTL = 0x36,
    PANEL_PIXEL_FORMAT = 0x3a,   /* COLMOD */
    PANEL_MEMORY_CONTINUE = 0x3c /* RAMWRC: from where the last write stopped */
};
enum {
    PANEL_MADCTL_MY = 0x80, /* rows from the last */
    PANEL_MADCTL_MX = 0x40, /* columns from the last */
    PANEL_MADCTL_MV = 0x20, /* columns and rows exchanged, before MX and MY */
    PANEL_MADCTL_BGR = 0x08,
    PANEL_FORMAT_565 = 0x55,
    PANEL_FORMAT_666 = 0x66 /* after a reset: a byte a channel */
};

enum { PANEL_OFF = 0, PANEL_BRIGHTEST = 100 }; /* percent */

/* What panel.c needs of a board. Functions return false where the bus failed; then the panel call does, too. */
struct panel_bus {
    bool (*command)(void *context, uint8_t command);                 /* one byte, D/C low */
    bool (*data)(void *context, const uint8_t *bytes, size_t count); /* D/C high */
    bool (*reset)(void *context, bool active);                       /* the reset line; NULL: reset by command */
    /* 0..100 percent; a backlight that cannot be dimmed is on above 0. NULL: no backlight. */
    bool (*backlight)(void *context, uint8_t percent);
    void (*wait_ms)(void *context, unsigned ms);
    void *context;
};

/* Config, set by you. */
struct panel {
    const struct panel_bus *bus;
    uint8_t controller;          /* enum panel_controller */
    uint8_t rotation;            /* quarter turns of the picture on the glass, clockwise, 0..3 */
    uint16_t width, height;      /* of the picture, after the rotation */
    uint16_t x_offset, y_offset; /* where the glass starts in the controller's memory, before the rotation */
    bool bgr, inverted;          /* how the glass is wired; IPS glass needs inversion */
    bool tearing_line;           /* it is wired: the controller must drive it */
};

/* Sets all but the bus to the usual values for a glass of this size: ST7789 as 240x320, 240x280, 240x240, 172x320, 170x320 or
 * 135x240 with its offset, ILI9341 as 240x320. False: no glass of this size is known; the offset is then 0, 0. */
bool panel_defaults(struct panel *panel, enum panel_controller controller, uint8_t rotation, uint16_t width,
                    uint16_t height);
/* Whether the glass lies within the controller's memory and the other fields are valid. */
bool panel_fits(const struct panel *panel);

/* Reset and initialisation, a quarter of a second: awake, RGB565, still dark, since the memory holds noise. */
bool panel_start(const struct panel *panel);
/* Display and backlight, after the first picture: on, at so many percent of its brightness, 1..100; or off, 0. */
bool panel_show(const struct panel *panel, uint8_t percent);
/* A window and the command that takes its pixels: width x height RGB565, high byte first, follow by bus->data, in as many
 * calls as you like. False also if the window is empty or leaves the picture; then nothing is sent. */
bool panel_window(const struct panel *panel, uint16_t x, uint16_t y, uint16_t width, uint16_t height);
/* Dark and asleep, also in the middle of pixels. panel_start wakes it again. */
bool panel_stop(const struct panel *panel);

#endif
