/* SPDX-License-Identifier: MIT */
#include "unit.h"

#include "lab.h"

#include <stdlib.h>

/* MIPI DCS */
enum {
    EXIT_SLEEP = 0x11,
    DISPLAY_OFF = 0x28,
    DISPLAY_ON = 0x29,
    COLUMNS = 0x2a,
    ROWS = 0x2b,
    WRITE = 0x2c,
    ADDRESS_MODE = 0x36,
    PIXEL_FORMAT = 0x3a,
    CONTINUE = 0x3c,
};

void screen_init(struct screen *screen, unsigned width, unsigned height)
{
    *screen = (struct screen){.width = width, .height = height, .column_last = width - 1, .row_last = height - 1};
    screen->pixels = calloc((size_t)width * height, sizeof *screen->pixels);
    assert_non_null(screen->pixels);
}

void screen_free(struct screen *screen)
{
    free(screen->pixels);
    *screen = (struct screen){0};
}

static void set_window(const bus_byte *data, size_t count, unsigned size, unsigned *first, unsigned *last)
{
    assert_int_equal(count, 4);
    *first = (data[0] & 0xffu) << 8 | (data[1] & 0xffu);
    *last = (data[2] & 0xffu) << 8 | (data[3] & 0xffu);
    if (*first > *last || *last >= size)
        fail_msg("a window from %u to %u in %u", *first, *last, size);
}

static void write_pixels(struct screen *screen, const bus_byte *data, size_t count)
{
    const unsigned width = screen->column_last - screen->column_first + 1,
                   height = screen->row_last - screen->row_first + 1;
    assert_int_equal(count % 2, 0);
    assert_true(count / 2 <= (size_t)width * height);
    for (size_t i = 0; i < count / 2; i++) {
        const size_t x = screen->column_first + i % width, y = screen->row_first + i / width;
        screen->pixels[y * screen->width + x] = (uint16_t)((data[2 * i] & 0xffu) << 8 | (data[2 * i + 1] & 0xffu));
    }
    screen->shown = screen->on;
    screen->writes++;
    screen->written += count / 2;
}

static void obey(struct screen *screen, unsigned command, const bus_byte *data, size_t count)
{
    switch (command) {
    case EXIT_SLEEP:
        screen->awake = true;
        break;
    case DISPLAY_OFF:
    case DISPLAY_ON:
        screen->on = command == DISPLAY_ON;
        screen->shown |= screen->on;
        break;
    case COLUMNS:
        set_window(data, count, screen->width, &screen->column_first, &screen->column_last);
        break;
    case ROWS:
        set_window(data, count, screen->height, &screen->row_first, &screen->row_last);
        break;
    case WRITE:
        write_pixels(screen, data, count);
        break;
    case CONTINUE:
        fail_msg("a write that continues another");
        break;
    case ADDRESS_MODE:
    case PIXEL_FORMAT:
        assert_int_equal(count, 1);
        *(command == ADDRESS_MODE ? &screen->madctl : &screen->colmod) = (uint8_t)data[0];
        break;
    default: /* the maker's: voltages, timing */
        break;
    }
}

/* Behind the data of the command that stands at start. */
static size_t command_end(const bus_byte *bytes, size_t count, size_t start)
{
    size_t end = start + 1;
    while (end < count && (bytes[end] & BUS_DATA))
        end++;
    return end;
}

void screen_show(struct screen *screen, const bus_byte *bytes, size_t count)
{
    for (size_t i = 0, end; i < count; i = end) {
        if (bytes[i] & BUS_DATA)
            fail_msg("byte %zu is data without a command", i);
        end = command_end(bytes, count, i);
        obey(screen, bytes[i], bytes + i + 1, end - i - 1);
    }
}

size_t frame_bytes(const bus_byte *bytes, size_t count, size_t pixels)
{
    size_t written = 0;
    for (size_t i = 0, end; i < count; i = end) {
        end = command_end(bytes, count, i);
        if (bytes[i] == WRITE && (written += (end - i - 1) / 2) >= pixels)
            return end;
    }
    fail_msg("%zu pixels of %zu are written", written, pixels);
    return 0;
}
