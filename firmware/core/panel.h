/* SPDX-License-Identifier: MIT
 *
 * MIPI-DCS panels, and the SSD1306: how to start one, where the next pixels go, how to leave it. Bytes go out through a bus that the
 * caller provides: the firmware's SPI, or the host's GPIO lines. */
#ifndef PANEL_H
#define PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Stored as uint8_t; panels.def describes each. A glass that is smaller than the memory shows a part. */
enum panel_controller {
#define CONTROLLER(id, ...) PANEL_##id,
#include "panels.def"
    PANEL_CONTROLLERS
};
/* SPI: D/C tells a command from data. QSPI: a select line frames each command, which goes by one line; pixels go by four. */
enum panel_bus_kind { PANEL_ON_SPI, PANEL_ON_QSPI };
enum panel_facts { /* PANEL_ST7789_ROWS, of its memory; PANEL_ST7789_HZ and _BUS, of its bus; and so on */
#define CONTROLLER(id, name, columns, rows, bgr, inverted, mirrored, clk_hz, values, bus, step, least)                 \
    PANEL_##id##_ROWS = rows, PANEL_##id##_HZ = clk_hz, PANEL_##id##_BUS = PANEL_ON_##bus,
#include "panels.def"
};
enum { PANEL_COLUMNS = 240, PANEL_ROWS = 320 };           /* the largest memory of those on SPI */
enum { PANEL_QSPI_COLUMNS = 480, PANEL_QSPI_ROWS = 480 }; /* and of all */
enum { PANEL_PAGED_COLUMNS = 128, PANEL_PAGED_ROWS = 64, PANEL_PAGE = 8 };
enum { PANEL_BAND = 8 }; /* lines of a round glass that share a window */

/* The commands of the MIPI Display Command Set that all but the SSD1306 know. */
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
    PANEL_PIXEL_FORMAT = 0x3a,    /* COLMOD */
    PANEL_MEMORY_CONTINUE = 0x3c, /* RAMWRC: from where the last write stopped */
    PANEL_BRIGHTNESS = 0x51       /* a byte, of glass that emits light */
};
enum {
    PANEL_MADCTL_MY = 0x80, /* rows from the last */
    PANEL_MADCTL_MX = 0x40, /* columns from the last */
    PANEL_MADCTL_MV = 0x20, /* columns and rows exchanged, before MX and MY */
    PANEL_MADCTL_BGR = 0x08,
    PANEL_FORMAT_565 = 0x55,
    PANEL_FORMAT_666 = 0x66 /* after a reset: a byte a channel */
};

/* Those of the SSD1306 (Solomon Systech, data sheet rev. 1.1, section 9). All of their bytes go with D/C low; data with D/C high are pixels. */
enum panel_paged_command {
    PANEL_PAGED_MODE = 0x20,        /* a byte: 0: column by column, then page by page, within the window */
    PANEL_PAGED_COLUMNS_ARE = 0x21, /* first and last */
    PANEL_PAGED_PAGES_ARE = 0x22,   /* first and last */
    PANEL_PAGED_START_LINE = 0x40,  /* 0x40 and the row of memory at the top */
    PANEL_PAGED_CONTRAST = 0x81,    /* a byte */
    PANEL_PAGED_PUMP = 0x8d,        /* a byte: 0x14: the panel's voltage is pumped from the logic's */
    PANEL_PAGED_SEGMENTS = 0xa0,    /* 0xa1: column 0 is the last segment */
    PANEL_PAGED_FROM_MEMORY = 0xa4,
    PANEL_PAGED_NORMAL = 0xa6,   /* 0xa7: a 1 is dark */
    PANEL_PAGED_ROWS_ARE = 0xa8, /* a byte: the number of rows, less 1 */
    PANEL_PAGED_CURRENT = 0xad,  /* a byte: 0x30: the segments' current is its own; in the SSD1315's data sheet alone */
    PANEL_PAGED_OFF = 0xae,
    PANEL_PAGED_ON = 0xaf,
    PANEL_PAGED_SCAN = 0xc0,      /* 0xc8: from the last row */
    PANEL_PAGED_OFFSET = 0xd3,    /* a byte */
    PANEL_PAGED_CLOCK = 0xd5,     /* a byte */
    PANEL_PAGED_PRECHARGE = 0xd9, /* a byte */
    PANEL_PAGED_PINS = 0xda,      /* a byte: 0x12: rows alternate between two sides, 0x02: one after the other */
    PANEL_PAGED_DESELECT = 0xdb   /* a byte */
};

enum { PANEL_OFF = 0, PANEL_BRIGHTEST = 100 }; /* percent */

/* What panel.c needs of a board. Functions return false where the bus failed; then the panel call does, too. */
struct panel_bus {
    bool (*command)(void *context, uint8_t command);                 /* one byte, D/C low */
    bool (*data)(void *context, const uint8_t *bytes, size_t count); /* D/C high */
    /* The end of a command and its data; not after those that take pixels. NULL: a bus without frames. */
    bool (*end)(void *context);
    bool (*reset)(void *context, bool active); /* the reset line; NULL: reset by command */
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
    bool round;                  /* a circle: of a picture as wide as high the corners cannot be seen */
    bool tearing_line;           /* it is wired: the controller must drive it */
};

/* Sets all but the bus to the usual values for a glass of this size, or a picture in the middle of one: those of panels.def. False: no
 * glass of this size is known; the offset is then 0, 0. */
bool panel_defaults(struct panel *panel, enum panel_controller controller, uint8_t rotation, uint16_t width,
                    uint16_t height);
/* Whether the glass lies within the controller's memory and the other fields are valid: of an SSD1306 only half turns, and whole pages;
 * on QSPI no turns, and even sizes and offsets. */
bool panel_fits(const struct panel *panel);
/* Is its memory in pages of 8 rows, one bit a pixel? */
static inline bool panel_is_paged(const struct panel *panel)
{
    return panel->controller == PANEL_SSD1306;
}

/* The columns that the glass shows of the lines y..y + lines - 1, inside the picture: all, or of a round glass those that the circle touches,
 * and one more at each end where windows must be even. */
struct panel_columns {
    uint16_t first, count;
};
struct panel_columns panel_visible(const struct panel *panel, unsigned y, unsigned lines);
/* The lines from y on that a picture sent from its top needs no new window for: all that follow, or of a round glass those of its band. */
unsigned panel_band(const struct panel *panel, unsigned y);

/* Reset and initialisation, a quarter of a second: awake, RGB565 or one bit a pixel, still dark, since the memory holds noise; but what
 * lies around a picture in the middle of a glass is black. */
bool panel_start(const struct panel *panel);
/* Display and backlight, after the first picture: on, at so many percent of its brightness, 1..100; or off, 0. An SSD1306 has no
 * backlight: 1..100 are the same. */
bool panel_show(const struct panel *panel, uint8_t percent);
/* A window and the command that takes its pixels: width x height RGB565, high byte first, follow by bus->data, in as many
 * calls as you like. Of an SSD1306 y and height are whole pages, and width x height / 8 bytes follow: 8 pixels below each other, the
 * uppermost in the lowest bit. False also if the window is empty or leaves the picture, or is one that the controller does not take: on
 * QSPI odd, or smaller than its smallest write; then nothing is sent. */
bool panel_window(const struct panel *panel, uint16_t x, uint16_t y, uint16_t width, uint16_t height);
/* Sends a part of a picture in GLINT_MONO, whose first line is `lines`, to an SSD1306: rows are rounded out to pages. False as above. */
bool panel_mono(const struct panel *panel, const uint8_t *lines, size_t stride, uint16_t x, uint16_t y, uint16_t width,
                uint16_t height);
/* Dark and asleep, also in the middle of pixels. panel_start wakes it again. */
bool panel_stop(const struct panel *panel);

#endif
