/* SPDX-License-Identifier: MIT */
#include "panel.h"

/* Times from the data sheets of the controllers. */
enum {
    RESET_PULSE_MS = 1,   /* at least 10 us */
    AFTER_RESET_MS = 120, /* 5 where it was asleep before, 120 where it was awake: who knows */
    AFTER_AWAKE_MS = 120, /* until the supplies stand and the display may be switched on */
    AFTER_ASLEEP_MS = 5   /* before any other command, or before the power goes */
};

/* ---- controllers and glass ---- */

/* Each: the command, the number of its bytes, the bytes. Ends with 0. */
/* The maker's application notes for 2.2 to 2.8 inch glass, which other drivers send, too; the reset values leave the picture pale. */
static const uint8_t ili9341_values[] = {
    0xcf, 3,    0x00, 0xc1, 0x30,             /* power control B: equalising on */
    0xed, 4,    0x64, 0x03, 0x12, 0x81,       /* power-on sequence: soft start */
    0xe8, 3,    0x85, 0x00, 0x78,             /* driver timing A */
    0xea, 2,    0x00, 0x00,                   /* driver timing B */
    0xcb, 5,    0x39, 0x2c, 0x00, 0x34, 0x02, /* power control A: core 1.6 V, step-up 5.6 V */
    0xf7, 1,    0x20,                         /* pump: twice VCI */
    0xc0, 1,    0x23,                         /* power control 1: greys from 4.6 V */
    0xc1, 1,    0x10,                         /* power control 2: gates at 7 and -4 times VCI */
    0xc5, 2,    0x3e, 0x28,                   /* common electrode: 4.25 V and -1.5 V ... */
    0xc7, 1,    0x86,                         /* ... shifted by -58 steps: least flicker */
    0xb1, 2,    0x00, 0x1b,                   /* 70 frames a second */
    0xb6, 3,    0x08, 0x82, 0x27,             /* normally white glass, 320 lines */
    0xf2, 1,    0x00,                         /* gamma: the curve below, not three of them */
    0xe0, 15,   0x0f, 0x31, 0x2b, 0x0c, 0x0e, 0x08, 0x4e, 0xf1, 0x37, 0x07, 0x10, 0x03, 0x0e, 0x09, 0x00, 0xe1,
    15,   0x00, 0x0e, 0x14, 0x03, 0x11, 0x07, 0x31, 0xc1, 0x48, 0x08, 0x0f, 0x0c, 0x31, 0x36, 0x0f, 0};

/* clang-format off */
/* The maker's values for its 1.28 inch glass, which its drivers send (Adafruit_GC9A01A, Waveshare's, TFT_eSPI); its data sheet names
 * a part of these registers only. */
static const uint8_t gc9a01_values[] = {
    0xfe, 0, 0xef, 0, /* inner registers may be written */
    0xeb, 1, 0x14,
    0x84, 1, 0x40, 0x85, 1, 0xff, 0x86, 1, 0xff, 0x87, 1, 0xff, 0x88, 1, 0x0a, 0x89, 1, 0x21,
    0x8a, 1, 0x00, 0x8b, 1, 0x80, 0x8c, 1, 0x01, 0x8d, 1, 0x01, 0x8e, 1, 0xff, 0x8f, 1, 0xff,
    0xb6, 2, 0x00, 0x00, /* columns and rows are scanned from the first */
    0x90, 4, 0x08, 0x08, 0x08, 0x08,
    0xbd, 1, 0x06,
    0xbc, 1, 0x00,
    0xff, 3, 0x60, 0x01, 0x04,
    0xc3, 1, 0x13, 0xc4, 1, 0x13, 0xc9, 1, 0x22, /* voltages of the greys */
    0xbe, 1, 0x11,
    0xe1, 2, 0x10, 0x0e,
    0xdf, 3, 0x21, 0x0c, 0x02,
    0xf0, 6, 0x45, 0x09, 0x08, 0x08, 0x26, 0x2a, /* gamma, four curves */
    0xf1, 6, 0x43, 0x70, 0x72, 0x36, 0x37, 0x6f,
    0xf2, 6, 0x45, 0x09, 0x08, 0x08, 0x26, 0x2a,
    0xf3, 6, 0x43, 0x70, 0x72, 0x36, 0x37, 0x6f,
    0xed, 2, 0x1b, 0x0b,
    0xae, 1, 0x77,
    0xcd, 1, 0x63,
    0x70, 9, 0x07, 0x07, 0x04, 0x0e, 0x0f, 0x09, 0x07, 0x08, 0x03,
    0xe8, 1, 0x34, /* columns are inverted in turn, four dots at a time */
    0x62, 12, 0x18, 0x0d, 0x71, 0xed, 0x70, 0x70, 0x18, 0x0f, 0x71, 0xef, 0x70, 0x70,
    0x63, 12, 0x18, 0x11, 0x71, 0xf1, 0x70, 0x70, 0x18, 0x13, 0x71, 0xf3, 0x70, 0x70,
    0x64, 7, 0x28, 0x29, 0xf1, 0x01, 0xf1, 0x00, 0x07,
    0x66, 10, 0x3c, 0x00, 0xcd, 0x67, 0x45, 0x45, 0x10, 0x00, 0x00, 0x00,
    0x67, 10, 0x00, 0x3c, 0x00, 0x00, 0x00, 0x01, 0x54, 0x10, 0x32, 0x98,
    0x74, 7, 0x10, 0x85, 0x80, 0x00, 0x00, 0x4e, 0x00,
    0x98, 2, 0x3e, 0x07,
    0};
/* clang-format on */

/* What drivers have in common. Brightness 0 until panel_show. */
static const uint8_t co5300_values[] = {0xfe,
                                        1,
                                        0x00, /* the usual page of commands */
                                        0xc4,
                                        1,
                                        0x80, /* pixels may come by four lines */
                                        0x53,
                                        1,
                                        0x20, /* brightness is that of the command ... */
                                        PANEL_BRIGHTNESS,
                                        1,
                                        0x00, /* ... this */
                                        0};

struct controller {
    uint16_t columns, rows;
    bool bgr, inverted, mirrored;
    uint8_t bus, step, least; /* a step is a power of 2 */
    const uint8_t *values;    /* NULL: none beside those of all */
};
static const struct controller controllers[] = {
#define CONTROLLER(id, name, columns, rows, bgr, inverted, mirrored, clk_hz, values, bus, step, least)                 \
    {columns, rows, bgr, inverted, mirrored, PANEL_ON_##bus, step, least, values},
#include "panels.def"
};

enum shape { RECTANGULAR, ROUND, MIDDLE };
struct glass {
    uint8_t controller;
    uint16_t width, height;
    uint8_t x_offset, y_offset, shape;
};
static const struct glass glasses[] = {
#define GLASS(controller, width, height, x, y, shape) {PANEL_##controller, width, height, x, y, shape},
#include "panels.def"
};

static bool is_on_qspi(const struct panel *panel)
{
    return controllers[panel->controller].bus == PANEL_ON_QSPI;
}

static uint16_t glass_width(const struct panel *panel)
{
    return panel->rotation % 2 ? panel->height : panel->width;
}

static uint16_t glass_height(const struct panel *panel)
{
    return panel->rotation % 2 ? panel->width : panel->height;
}

/* The row that the panel is of; NULL: none. */
static const struct glass *find_glass(const struct panel *panel)
{
    const struct glass *glass = glasses;
    while (glass->controller != panel->controller || glass->width != glass_width(panel) ||
           glass->height != glass_height(panel))
        if (++glass == glasses + sizeof glasses / sizeof *glasses)
            return NULL;
    return glass;
}

bool panel_defaults(struct panel *panel, enum panel_controller controller, uint8_t rotation, uint16_t width,
                    uint16_t height)
{
    panel->controller = (uint8_t)controller;
    panel->rotation = rotation;
    panel->width = width;
    panel->height = height;
    panel->x_offset = 0;
    panel->y_offset = 0;
    panel->tearing_line = false;
    panel->round = false;
    panel->bgr = controller < PANEL_CONTROLLERS && controllers[controller].bgr;
    panel->inverted = controller < PANEL_CONTROLLERS && controllers[controller].inverted;
    const struct glass *glass = find_glass(panel);
    if (!glass)
        return false;
    panel->x_offset = glass->x_offset;
    panel->y_offset = glass->y_offset;
    panel->round = glass->shape == ROUND;
    return panel_fits(panel);
}

/* On QSPI windows are even, and nothing is turned. */
static bool is_even(const struct panel *panel)
{
    return !is_on_qspi(panel) ||
           (panel->rotation == 0 && (panel->x_offset | panel->y_offset | panel->width | panel->height) % 2 == 0);
}

bool panel_fits(const struct panel *panel)
{
    if (panel_is_paged(panel))
        return panel->rotation < 4 && panel->rotation % 2 == 0 && panel->width && panel->height &&
               (uint32_t)panel->x_offset + panel->width <= PANEL_PAGED_COLUMNS && panel->y_offset == 0 &&
               panel->height <= PANEL_PAGED_ROWS && panel->height % PANEL_PAGE == 0;
    return panel->controller < PANEL_CONTROLLERS && panel->rotation < 4 && panel->width && panel->height &&
           (uint32_t)panel->x_offset + glass_width(panel) <= controllers[panel->controller].columns &&
           (uint32_t)panel->y_offset + glass_height(panel) <= controllers[panel->controller].rows &&
           (!panel->round || panel->width == panel->height) && is_even(panel);
}

/* In half pixels from the middle, the nearest of a line's or a column's edges: 0 in the middle. */
static unsigned from_middle(unsigned at, unsigned size)
{
    const unsigned edges = 2 * at + 1;
    return (edges > size ? edges - size : size - edges) - (edges != size);
}

/* A column is to be seen where the circle touches its pixel in the line that is nearest to the middle. */
struct panel_columns panel_visible(const struct panel *panel, unsigned y, unsigned lines)
{
    const unsigned size = panel->width, last = y + lines - 1, middle = size / 2;
    const unsigned nearest = y > middle ? y : last < middle ? last : middle;
    struct panel_columns columns = {0, panel->width};
    if (!panel->round)
        return columns;
    const unsigned down = from_middle(nearest, size);
    unsigned outside = 0, inside = middle; /* the first column that is seen lies between */
    while (outside < inside) {
        const unsigned at = (outside + inside) / 2, across = from_middle(at, size);
        if (across * across + down * down < size * size)
            inside = at;
        else
            outside = at + 1;
    }
    inside &= ~(controllers[panel->controller].step - 1u);
    columns.first = (uint16_t)inside;
    columns.count = (uint16_t)(size - 2 * inside);
    return columns;
}

unsigned panel_band(const struct panel *panel, unsigned y)
{
    const unsigned end = panel->round ? (y / PANEL_BAND + 1) * PANEL_BAND : panel->height;
    return (end < panel->height ? end : panel->height) - y;
}

/* ---- start, show, stop ---- */

static bool send(const struct panel *panel, uint8_t command, const uint8_t *data, size_t count)
{
    const struct panel_bus *bus = panel->bus;
    return bus->command(bus->context, command) && (count == 0 || bus->data(bus->context, data, count)) &&
           (!bus->end || command == PANEL_MEMORY_WRITE || bus->end(bus->context));
}

static bool send_byte(const struct panel *panel, uint8_t command, uint8_t byte)
{
    return send(panel, command, &byte, 1);
}

static bool send_range(const struct panel *panel, uint8_t command, unsigned first, unsigned count)
{
    const unsigned last = first + count - 1;
    const uint8_t bytes[] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};
    return send(panel, command, bytes, sizeof bytes);
}

static void wait_ms(const struct panel *panel, unsigned ms)
{
    panel->bus->wait_ms(panel->bus->context, ms);
}

static bool send_values(const struct panel *panel, const uint8_t *at)
{
    for (; *at; at += 2 + at[1])
        if (!send(panel, at[0], at + 2, at[1]))
            return false;
    return true;
}

/* The corner where the picture begins, and the way it runs. */
static uint8_t madctl(const struct panel *panel)
{
    static const uint8_t turns[4] = {0, PANEL_MADCTL_MV | PANEL_MADCTL_MX, PANEL_MADCTL_MX | PANEL_MADCTL_MY,
                                     PANEL_MADCTL_MV | PANEL_MADCTL_MY};
    const unsigned mirror = controllers[panel->controller].mirrored ? PANEL_MADCTL_MX : 0;
    return (uint8_t)((turns[panel->rotation] ^ mirror) | (panel->bgr ? PANEL_MADCTL_BGR : 0));
}

static bool reset(const struct panel *panel)
{
    const struct panel_bus *bus = panel->bus;
    if (!bus->reset) /* an SSD1306 has no such command: all that matters is set */
        return panel_is_paged(panel) || send(panel, PANEL_SOFTWARE_RESET, NULL, 0);
    if (!bus->reset(bus->context, true))
        return false;
    wait_ms(panel, RESET_PULSE_MS);
    return bus->reset(bus->context, false);
}

static bool backlight(const struct panel *panel, uint8_t percent)
{
    const struct panel_bus *bus = panel->bus;
    if (is_on_qspi(panel))
        return send_byte(panel, PANEL_BRIGHTNESS, (uint8_t)(percent * 653u >> 8)); /* 100: 255 */
    return !bus->backlight || bus->backlight(bus->context, percent);
}

/* Commands whose bytes all go with D/C low. */
static bool send_commands(const struct panel *panel, const uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!panel->bus->command(panel->bus->context, bytes[i]))
            return false;
    return true;
}

/* The order and values of the maker's application note for 128x64 with a charge pump; precharge and deselect level as drivers in wide
 * use have them for it. Modules hang such that column 0 is the last segment, and rows run from the last. Glass of 72x40 has no resistor
 * that sets the current of its segments: without the last command it is all but dark (u8g2 and MicroPython send it; SSD1306s that do not
 * know it ignore it). */
static bool start_paged(const struct panel *panel)
{
    static const uint8_t own_current[] = {PANEL_PAGED_CURRENT, 0x30};
    const bool turned = panel->rotation == 2;
    const uint8_t bytes[] = {PANEL_PAGED_OFF,
                             PANEL_PAGED_CLOCK,
                             0x80,
                             PANEL_PAGED_ROWS_ARE,
                             (uint8_t)(panel->height - 1),
                             PANEL_PAGED_OFFSET,
                             0,
                             PANEL_PAGED_START_LINE,
                             PANEL_PAGED_SEGMENTS | (turned ? 0 : 1),
                             PANEL_PAGED_SCAN | (turned ? 0 : 8),
                             PANEL_PAGED_PINS,
                             panel->width == 128 && panel->height <= 32 ? 0x02 : 0x12,
                             PANEL_PAGED_CONTRAST,
                             0x7f,
                             PANEL_PAGED_PRECHARGE,
                             0xf1,
                             PANEL_PAGED_DESELECT,
                             0x40,
                             PANEL_PAGED_FROM_MEMORY,
                             PANEL_PAGED_NORMAL | (panel->inverted ? 1 : 0),
                             PANEL_PAGED_MODE,
                             0,
                             PANEL_PAGED_PUMP,
                             0x14};
    return send_commands(panel, bytes, sizeof bytes) &&
           (panel->width != 72 || send_commands(panel, own_current, sizeof own_current));
}

/* The glass around a picture in its middle; of others nothing. */
static bool blacken(const struct panel *panel)
{
    static const uint8_t black[32];
    const struct glass *glass = find_glass(panel);
    const struct panel_bus *bus = panel->bus;
    if (!glass || glass->shape != MIDDLE)
        return true;
    glass--;
    if (!send_range(panel, PANEL_COLUMN_ADDRESS, glass->x_offset, glass->width) ||
        !send_range(panel, PANEL_ROW_ADDRESS, glass->y_offset, glass->height) ||
        !send(panel, PANEL_MEMORY_WRITE, NULL, 0))
        return false;
    size_t left = (size_t)glass->width * glass->height * 2;
    for (size_t some; left; left -= some) {
        some = left < sizeof black ? left : sizeof black;
        if (!bus->data(bus->context, black, some))
            return false;
    }
    return true;
}

bool panel_start(const struct panel *panel)
{
    if (!panel_fits(panel) || (!is_on_qspi(panel) && !backlight(panel, PANEL_OFF)) || !reset(panel))
        return false;
    wait_ms(panel, AFTER_RESET_MS);
    if (panel_is_paged(panel)) {
        const bool started = start_paged(panel);
        wait_ms(panel, AFTER_AWAKE_MS); /* the pump */
        return started;
    }
    const uint8_t *values = controllers[panel->controller].values;
    if (values && !send_values(panel, values))
        return false;
    if (!send_byte(panel, PANEL_PIXEL_FORMAT, PANEL_FORMAT_565) || !send_byte(panel, PANEL_MADCTL, madctl(panel)) ||
        (panel->tearing_line && !send_byte(panel, PANEL_TEARING_ON, 0)) ||
        !send(panel, panel->inverted ? PANEL_INVERSION_ON : PANEL_INVERSION_OFF, NULL, 0) ||
        !send(panel, PANEL_SLEEP_OUT, NULL, 0))
        return false;
    wait_ms(panel, AFTER_AWAKE_MS);
    return blacken(panel);
}

bool panel_show(const struct panel *panel, uint8_t percent)
{
    if (panel_is_paged(panel)) {
        const uint8_t on = percent == PANEL_OFF ? PANEL_PAGED_OFF : PANEL_PAGED_ON;
        return send_commands(panel, &on, 1) && backlight(panel, percent);
    }
    /* The light never shines on a display that is off: that is white on some glass. */
    if (percent == PANEL_OFF)
        return backlight(panel, PANEL_OFF) && send(panel, PANEL_DISPLAY_OFF, NULL, 0);
    return send(panel, PANEL_DISPLAY_ON, NULL, 0) && backlight(panel, percent);
}

bool panel_stop(const struct panel *panel)
{
    if (!panel_show(panel, PANEL_OFF))
        return false;
    if (!panel_is_paged(panel) && !send(panel, PANEL_SLEEP_IN, NULL, 0)) /* any command ends a write */
        return false;
    wait_ms(panel, AFTER_ASLEEP_MS);
    return true;
}

/* ---- windows ---- */

/* A glass that is narrower than the memory lies in its middle, so that its offset is the same from both sides. */
static bool window_paged(const struct panel *panel, unsigned x, unsigned y, unsigned width, unsigned height)
{
    const unsigned left =
        panel->rotation ? PANEL_PAGED_COLUMNS - panel->x_offset - (unsigned)panel->width : panel->x_offset;
    const uint8_t bytes[] = {PANEL_PAGED_COLUMNS_ARE,         (uint8_t)(left + x),
                             (uint8_t)(left + x + width - 1), PANEL_PAGED_PAGES_ARE,
                             (uint8_t)(y / PANEL_PAGE),       (uint8_t)((y + height - 1) / PANEL_PAGE)};
    return y % PANEL_PAGE == 0 && height % PANEL_PAGE == 0 && send_commands(panel, bytes, sizeof bytes);
}

bool panel_window(const struct panel *panel, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    if (width == 0 || height == 0 || x >= panel->width || y >= panel->height || width > panel->width - x ||
        height > panel->height - y)
        return false;
    if (panel_is_paged(panel))
        return window_paged(panel, x, y, width, height);
    /* What the memory holds beside the glass, on the side from which the turned picture counts. */
    const unsigned left = panel->x_offset, top = panel->y_offset;
    const struct controller *controller = &controllers[panel->controller];
    if (((x | y | width | height) & (controller->step - 1u)) || (uint32_t)width * height * 2 < controller->least)
        return false;
    const unsigned right = controller->columns - left - glass_width(panel);
    const unsigned bottom = controller->rows - top - glass_height(panel);
    const unsigned before_x[4] = {left, top, right, bottom}, before_y[4] = {top, right, bottom, left};
    return send_range(panel, PANEL_COLUMN_ADDRESS, before_x[panel->rotation] + x, width) &&
           send_range(panel, PANEL_ROW_ADDRESS, before_y[panel->rotation] + y, height) &&
           send(panel, PANEL_MEMORY_WRITE, NULL, 0);
}

/* Of 8 lines, the pixels x.. of each below the other. */
static void page_of(uint8_t out[PANEL_PAGED_COLUMNS], const uint8_t *lines, size_t stride, unsigned x, unsigned width)
{
    for (unsigned i = 0; i < width; i++) {
        const uint8_t *at = lines + (x + i) / 8;
        unsigned bits = 0;
        for (unsigned row = 0; row < PANEL_PAGE; row++, at += stride)
            bits |= ((unsigned)*at >> (7 - (x + i) % 8) & 1) << row;
        out[i] = (uint8_t)bits;
    }
}

bool panel_mono(const struct panel *panel, const uint8_t *lines, size_t stride, uint16_t x, uint16_t y, uint16_t width,
                uint16_t height)
{
    const struct panel_bus *bus = panel->bus;
    const unsigned top = y / PANEL_PAGE * PANEL_PAGE;
    const unsigned end = ((uint32_t)y + height + PANEL_PAGE - 1) / PANEL_PAGE * PANEL_PAGE;
    if (!panel_is_paged(panel) || height == 0 || end > panel->height ||
        !panel_window(panel, x, (uint16_t)top, width, (uint16_t)(end - top)))
        return false;
    for (unsigned line = top; line < end; line += PANEL_PAGE) {
        uint8_t page[PANEL_PAGED_COLUMNS];
        page_of(page, lines + stride * line, stride, x, width);
        if (!bus->data(bus->context, page, width))
            return false;
    }
    return true;
}
