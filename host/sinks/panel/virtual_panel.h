/* SPDX-License-Identifier: MIT
 * A virtual panel: it takes a panel's bytes as its controller does, and shows what the glass would. Written
 * from the controllers' data sheets, not from panel.c, whose work it judges. Takes any bytes in any order. */
#ifndef GLINT_VIRTUAL_PANEL_H
#define GLINT_VIRTUAL_PANEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "panel.h"

/* How the glass is wired. Config, set by you. */
struct virtual_glass {
    uint16_t width, height; /* as it hangs, unturned */
    uint16_t x, y;          /* where its top left pixel lies in the memory (mirrored: counted from the last column) */
    bool mirrored;          /* column 0 of the memory is at the right */
    bool bgr, inverted;
    bool paged;             /* an SSD1306: x counts from the last segment, as its modules hang */
    bool round;             /* what no part of the circle touches is black */
    uint16_t rows, columns; /* of the memory; 0: PANEL_ROWS, PANEL_COLUMNS */
    bool emits;             /* light: its brightness is a command, 0 after a reset */
};

struct virtual_panel {
    struct virtual_glass glass;
    /* State, ours. */
    uint16_t memory[PANEL_QSPI_ROWS][PANEL_QSPI_COLUMNS]; /* RGB565 */
    uint16_t columns[2], rows[2];                         /* the window: first, last */
    uint16_t column, row;                                 /* of the next pixel */
    uint8_t command;                                      /* that the data belong to */
    uint8_t bytes[4];                                     /* of a parameter or pixel that is not whole yet */
    uint8_t held;                                         /* how many */
    uint8_t madctl, format, brightness;
    bool awake, on, inverted, lit;
    uint8_t paged_rows;           /* that are scanned, less 1 */
    bool first_segment, from_top; /* its column 0 is segment 0; it scans from row 0 */
    uint8_t mode;
};

/* As after power-on: asleep, off, and noise in the memory. The backlight is lit at first. The glass must fit the
 * memory. */
void virtual_panel_init(struct virtual_panel *panel, const struct virtual_glass *glass);
void virtual_panel_reset(struct virtual_panel *panel); /* the line, and the command: the memory stays as it is */
void virtual_panel_command(struct virtual_panel *panel, uint8_t command);
void virtual_panel_data(struct virtual_panel *panel, const uint8_t *bytes, size_t count);

/* The picture as seen after the panel is turned back by `rotation` quarter turns, so that a picture turned by as many stands
 * upright: RGB, width x height, exchanged where the rotation is odd. Black where asleep, off or unlit. */
void virtual_panel_look(const struct virtual_panel *panel, unsigned rotation, uint8_t *rgb);

/* The glass that a panel's configuration describes, and a bus to it. The panel must outlive the bus. */
struct virtual_glass virtual_glass_of(const struct panel *panel);
struct panel_bus virtual_panel_bus(struct virtual_panel *panel);

#endif
