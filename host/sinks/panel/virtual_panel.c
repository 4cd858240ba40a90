/* SPDX-License-Identifier: MIT */
#include "sinks/panel/virtual_panel.h"

#include <string.h>

/* Magenta, which no picture has: pixels that were never written stand out. */
enum { NOISE = 0xf81f };

static unsigned rows_of(const struct virtual_panel *panel)
{
    return panel->glass.rows ? panel->glass.rows : PANEL_ROWS;
}

static unsigned columns_of(const struct virtual_panel *panel)
{
    return panel->glass.columns ? panel->glass.columns : PANEL_COLUMNS;
}

void virtual_panel_reset(struct virtual_panel *panel)
{
    panel->columns[0] = panel->rows[0] = panel->column = panel->row = 0;
    panel->columns[1] = (uint16_t)(columns_of(panel) - 1);
    panel->rows[1] = (uint16_t)(rows_of(panel) - 1);
    panel->command = PANEL_NOP;
    panel->held = 0;
    panel->madctl = panel->brightness = 0;
    panel->format = PANEL_FORMAT_666;
    panel->awake = panel->on = panel->inverted = false;
    if (!panel->glass.paged)
        return;
    panel->columns[1] = PANEL_PAGED_COLUMNS - 1;
    panel->rows[1] = PANEL_PAGED_ROWS / PANEL_PAGE - 1;
    panel->paged_rows = PANEL_PAGED_ROWS - 1;
    panel->mode = 2; /* page addressing */
    panel->first_segment = panel->from_top = true;
}

void virtual_panel_init(struct virtual_panel *panel, const struct virtual_glass *glass)
{
    panel->glass = *glass;
    panel->lit = true;
    for (unsigned row = 0; row < rows_of(panel); row++)
        for (unsigned column = 0; column < columns_of(panel); column++)
            panel->memory[row][column] = NOISE;
    virtual_panel_reset(panel);
}

/* ---- writing ---- */

static bool hold(struct virtual_panel *panel, uint8_t byte, unsigned whole);

/* ---- an SSD1306: rows are its pages; a page's byte lies in the memory as 8 of ours ---- */

/* How many bytes a command has behind it. */
static unsigned paged_parameters(uint8_t command)
{
    switch (command) {
    case PANEL_PAGED_COLUMNS_ARE:
    case PANEL_PAGED_PAGES_ARE:
        return 2;
    case PANEL_PAGED_MODE:
    case PANEL_PAGED_CONTRAST:
    case PANEL_PAGED_PUMP:
    case PANEL_PAGED_ROWS_ARE:
    case PANEL_PAGED_CURRENT:
    case PANEL_PAGED_OFFSET:
    case PANEL_PAGED_CLOCK:
    case PANEL_PAGED_PRECHARGE:
    case PANEL_PAGED_PINS:
    case PANEL_PAGED_DESELECT:
        return 1;
    default:
        return 0;
    }
}

static void paged_do(struct virtual_panel *panel, uint8_t command, const uint8_t *bytes)
{
    switch (command) {
    case PANEL_PAGED_MODE:
        panel->mode = bytes[0] & 3;
        break;
    case PANEL_PAGED_COLUMNS_ARE:
        panel->column = panel->columns[0] = bytes[0] & 127;
        panel->columns[1] = bytes[1] & 127;
        break;
    case PANEL_PAGED_PAGES_ARE:
        panel->row = panel->rows[0] = bytes[0] & 7;
        panel->rows[1] = bytes[1] & 7;
        break;
    case PANEL_PAGED_ROWS_ARE:
        panel->paged_rows = bytes[0] & 63;
        break;
    case PANEL_PAGED_PUMP:
        panel->awake = bytes[0] & 4;
        break;
    case PANEL_PAGED_SEGMENTS:
    case PANEL_PAGED_SEGMENTS + 1:
        panel->first_segment = command == PANEL_PAGED_SEGMENTS;
        break;
    case PANEL_PAGED_SCAN:
    case PANEL_PAGED_SCAN + 8:
        panel->from_top = command == PANEL_PAGED_SCAN;
        break;
    case PANEL_PAGED_NORMAL:
    case PANEL_PAGED_NORMAL + 1:
        panel->inverted = command != PANEL_PAGED_NORMAL;
        break;
    case PANEL_PAGED_OFF:
    case PANEL_PAGED_ON:
        panel->on = command == PANEL_PAGED_ON;
        break;
    default:
        break;
    }
}

static void paged_command(struct virtual_panel *panel, uint8_t byte)
{
    if (panel->command == PANEL_NOP) {
        panel->command = byte;
        panel->held = 0;
        if (paged_parameters(byte))
            return;
    } else if (!hold(panel, byte, paged_parameters(panel->command))) {
        return;
    }
    paged_do(panel, panel->command, panel->bytes);
    panel->command = PANEL_NOP;
}

static void advance(struct virtual_panel *panel);

/* Horizontal addressing alone is decoded. */
static void paged_take(struct virtual_panel *panel, uint8_t byte)
{
    const unsigned column = panel->first_segment ? panel->column : PANEL_PAGED_COLUMNS - 1u - panel->column;
    if (panel->mode != 0 || panel->row * PANEL_PAGE >= PANEL_PAGED_ROWS || panel->column >= PANEL_PAGED_COLUMNS)
        return;
    for (unsigned bit = 0; bit < PANEL_PAGE; bit++)
        panel->memory[panel->row * PANEL_PAGE + bit][column] = byte >> bit & 1 ? 0xffff : 0;
    advance(panel);
}

void virtual_panel_command(struct virtual_panel *panel, uint8_t command)
{
    if (panel->glass.paged) {
        paged_command(panel, command);
        return;
    }
    panel->command = command;
    panel->held = 0; /* half a pixel or parameter is dropped */
    switch (command) {
    case PANEL_SOFTWARE_RESET:
        virtual_panel_reset(panel);
        break;
    case PANEL_SLEEP_IN:
    case PANEL_SLEEP_OUT:
        panel->awake = command == PANEL_SLEEP_OUT;
        break;
    case PANEL_INVERSION_OFF:
    case PANEL_INVERSION_ON:
        panel->inverted = command == PANEL_INVERSION_ON;
        break;
    case PANEL_DISPLAY_OFF:
    case PANEL_DISPLAY_ON:
        panel->on = command == PANEL_DISPLAY_ON;
        break;
    case PANEL_MEMORY_WRITE:
        panel->column = panel->columns[0];
        panel->row = panel->rows[0];
        break;
    default:
        break; /* what does not change the picture's geometry or colour order */
    }
}

/* One more byte of something that is `whole` bytes long: is it complete? */
static bool hold(struct virtual_panel *panel, uint8_t byte, unsigned whole)
{
    panel->bytes[panel->held++] = byte;
    if (panel->held < whole)
        return false;
    panel->held = 0;
    return true;
}

static void set_range(struct virtual_panel *panel, uint16_t range[2])
{
    const uint16_t first = (uint16_t)(panel->bytes[0] << 8 | panel->bytes[1]);
    const uint16_t last = (uint16_t)(panel->bytes[2] << 8 | panel->bytes[3]);
    if (first <= last) { /* "must be": another pair changes nothing */
        range[0] = first;
        range[1] = last;
    }
    panel->command = PANEL_NOP; /* more bytes are ignored */
}

/* The address counter: columns first, and from the window's last pixel to its first. */
static void advance(struct virtual_panel *panel)
{
    if (panel->column++ < panel->columns[1])
        return;
    panel->column = panel->columns[0];
    if (panel->row++ >= panel->rows[1])
        panel->row = panel->rows[0];
}

static void store(struct virtual_panel *panel, uint16_t color)
{
    const bool exchanged = panel->madctl & PANEL_MADCTL_MV;
    unsigned column = exchanged ? panel->row : panel->column, row = exchanged ? panel->column : panel->row;
    if (column < columns_of(panel) && row < rows_of(panel)) { /* "data of out of range will be ignored" */
        if (panel->madctl & PANEL_MADCTL_MX)
            column = columns_of(panel) - 1 - column;
        if (panel->madctl & PANEL_MADCTL_MY)
            row = rows_of(panel) - 1 - row;
        panel->memory[row][column] = color;
    }
    advance(panel);
}

static void take_pixel_byte(struct virtual_panel *panel, uint8_t byte)
{
    const uint8_t *bytes = panel->bytes;
    switch (panel->format & 7) { /* the high half is of the RGB interface */
    case PANEL_FORMAT_565 & 7:
        if (hold(panel, byte, 2))
            store(panel, (uint16_t)(bytes[0] << 8 | bytes[1]));
        break;
    case PANEL_FORMAT_666 & 7:
        if (hold(panel, byte, 3))
            store(panel, (uint16_t)((bytes[0] >> 3) << 11 | (bytes[1] >> 2) << 5 | bytes[2] >> 3));
        break;
    default:
        break; /* 12 bits a pixel is not decoded */
    }
}

static void take(struct virtual_panel *panel, uint8_t byte)
{
    switch (panel->command) {
    case PANEL_COLUMN_ADDRESS:
        if (hold(panel, byte, 4))
            set_range(panel, panel->columns);
        break;
    case PANEL_ROW_ADDRESS:
        if (hold(panel, byte, 4))
            set_range(panel, panel->rows);
        break;
    case PANEL_MEMORY_WRITE:
    case PANEL_MEMORY_CONTINUE:
        take_pixel_byte(panel, byte);
        break;
    case PANEL_MADCTL:
        panel->madctl = byte;
        panel->command = PANEL_NOP;
        break;
    case PANEL_PIXEL_FORMAT:
        panel->format = byte;
        panel->command = PANEL_NOP;
        break;
    case PANEL_BRIGHTNESS:
        panel->brightness = byte;
        break;
    default:
        break;
    }
}

void virtual_panel_data(struct virtual_panel *panel, const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (panel->glass.paged)
            paged_take(panel, bytes[i]);
        else
            take(panel, bytes[i]);
}

/* ---- looking ---- */

static uint16_t on_glass(const struct virtual_panel *panel, unsigned x, unsigned y)
{
    const struct virtual_glass *glass = &panel->glass;
    if (glass->paged) { /* row 0 of the glass is the last that is scanned */
        const unsigned row = panel->from_top ? (unsigned)panel->paged_rows - y : y;
        const uint16_t bits = panel->memory[row % PANEL_PAGED_ROWS][PANEL_PAGED_COLUMNS - 1 - glass->x - x];
        return panel->inverted != glass->inverted ? (uint16_t)~bits : bits;
    }
    const unsigned column = glass->x + x;
    uint16_t color = panel->memory[glass->y + y][glass->mirrored ? columns_of(panel) - 1 - column : column];
    if (panel->inverted != glass->inverted)
        color = (uint16_t)~color;
    if (((panel->madctl & PANEL_MADCTL_BGR) != 0) != glass->bgr)
        color = (uint16_t)(color << 11 | (color & 0x07e0) | color >> 11);
    return color;
}

static uint8_t shown(unsigned level, unsigned max) /* as pictures in files show levels: nearest of 255 */
{
    return (uint8_t)((level * 255 + max / 2) / max);
}

/* Does the circle touch the pixel? Its nearest corner to the middle tells. */
static bool is_seen(const struct virtual_glass *glass, unsigned x, unsigned y)
{
    const double middle = glass->width / 2.0;
    const double across = x < middle ? middle - x - 1 : x - middle, down = y < middle ? middle - y - 1 : y - middle;
    return !glass->round || across * across + down * down < middle * middle;
}

void virtual_panel_look(const struct virtual_panel *panel, unsigned rotation, uint8_t *rgb)
{
    const unsigned right = panel->glass.width - 1u, bottom = panel->glass.height - 1u;
    const unsigned width = rotation % 2 ? bottom + 1 : right + 1, height = rotation % 2 ? right + 1 : bottom + 1;
    if (!panel->awake || !panel->on || !panel->lit || (panel->glass.emits && !panel->brightness)) {
        memset(rgb, 0, (size_t)width * height * 3);
        return;
    }
    for (unsigned y = 0; y < height; y++) {
        for (unsigned x = 0; x < width; x++, rgb += 3) {
            const unsigned across[4] = {x, right - y, right - x, y}, down[4] = {y, x, bottom - y, bottom - x};
            const unsigned at_x = across[rotation % 4], at_y = down[rotation % 4];
            const unsigned color = is_seen(&panel->glass, at_x, at_y) ? on_glass(panel, at_x, at_y) : 0;
            rgb[0] = shown(color >> 11, 31);
            rgb[1] = shown(color >> 5 & 63, 63);
            rgb[2] = shown(color & 31, 31);
        }
    }
}

/* ---- for panel.c ---- */

struct virtual_glass virtual_glass_of(const struct panel *panel)
{
    const bool turned = panel->rotation % 2;
    return (struct virtual_glass){.width = turned ? panel->height : panel->width,
                                  .height = turned ? panel->width : panel->height,
                                  .x = panel->x_offset,
                                  .y = panel->y_offset,
                                  .mirrored = panel->controller == PANEL_ILI9341 || panel->controller == PANEL_GC9A01,
                                  .paged = panel_is_paged(panel),
                                  .emits = panel->controller == PANEL_CO5300,
                                  .bgr = panel->bgr,
                                  .inverted = panel->inverted,
                                  .round = panel->round,
                                  .columns = panel->controller == PANEL_CO5300 ? PANEL_QSPI_COLUMNS : PANEL_COLUMNS,
                                  .rows = panel->controller == PANEL_GC9A01   ? 240
                                          : panel->controller == PANEL_CO5300 ? PANEL_QSPI_ROWS
                                                                              : PANEL_ROWS};
}

static bool bus_command(void *context, uint8_t command)
{
    virtual_panel_command(context, command);
    return true;
}

static bool bus_data(void *context, const uint8_t *bytes, size_t count)
{
    virtual_panel_data(context, bytes, count);
    return true;
}

static bool bus_reset(void *context, bool active)
{
    if (active)
        virtual_panel_reset(context);
    return true;
}

static bool bus_backlight(void *context, uint8_t percent)
{
    ((struct virtual_panel *)context)->lit = percent != PANEL_OFF;
    return true;
}

static void bus_wait_ms(void *context, unsigned ms)
{
    (void)context; /* it is ready at once */
    (void)ms;
}

struct panel_bus virtual_panel_bus(struct virtual_panel *panel)
{
    return (struct panel_bus){bus_command, bus_data, NULL, bus_reset, bus_backlight, bus_wait_ms, panel};
}
