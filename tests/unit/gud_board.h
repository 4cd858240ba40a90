/* SPDX-License-Identifier: MIT
 * A board around the GUD device, which draws into memory, and its host. */
#ifndef GLINT_GUD_BOARD_H
#define GLINT_GUD_BOARD_H

#include <lz4.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "unit.h"

#include "gud_device.h"

enum {
    WIDTH = 24,
    HEIGHT = 10,
    INTERFACE = 3,
    GUARD = 64,
    FRESH = 0xa5,
    PIXEL_MAX = 4,
    FRAME_MAX = WIDTH * HEIGHT * PIXEL_MAX
};
static const uint8_t all_formats[] = {GUD_RGB565, GUD_RGB888,   GUD_XRGB8888, GUD_ARGB8888,
                                      GUD_R8,     GUD_XRGB1111, GUD_RGB332,   GUD_R1};

/* A board whose panel is memory. */
static struct board {
    struct gud_device device;
    struct gud_device_config config;
    uint8_t lines[GUD_DEVICE_LINE_BYTES(WIDTH, 4, 3) + GUARD], window[FRAME_MAX + GUARD];
    uint8_t panel[WIDTH * HEIGHT * 3];
    struct glint_box box;
    unsigned row, windows, ends, whole, displays;
    bool busy, on;
    uint8_t brightness;
    const uint8_t *last; /* the line before, which must still be as it was */
    uint8_t last_copy[WIDTH * 3];
    size_t last_bytes;
} board;

static inline unsigned output_bytes(void)
{
    return board.config.output == GLINT_RGB888 ? 3 : 2;
}

static inline void window(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    assert_ptr_equal(context, &board);
    assert_int_equal(board.windows, board.ends);
    assert_true(width && height && x + width <= WIDTH && y + height <= HEIGHT);
    board.box = (struct glint_box){x, y, width, height};
    board.row = 0;
    board.windows++;
    board.last_bytes = 0;
}

static inline void line(void *context, const uint8_t *pixels, size_t bytes)
{
    assert_ptr_equal(context, &board);
    assert_true(board.windows == board.ends + 1 && board.row < board.box.h);
    assert_int_equal(bytes, output_bytes() * board.box.w);
    assert_memory_equal(board.last ? board.last : board.last_copy, board.last_copy, board.last_bytes);
    assert_true(pixels != board.last || board.last_bytes == 0);
    memcpy(board.panel + ((board.box.y + board.row++) * WIDTH + board.box.x) * output_bytes(), pixels, bytes);
    memcpy(board.last_copy, pixels, bytes);
    board.last = pixels;
    board.last_bytes = bytes;
}

static inline void end(void *context, bool whole)
{
    assert_ptr_equal(context, &board);
    assert_int_equal(whole, board.row == board.box.h);
    board.ends++;
    board.whole += whole;
}

static inline void display(void *context, bool on, uint8_t brightness)
{
    assert_ptr_equal(context, &board);
    board.displays++;
    board.on = on;
    board.brightness = brightness;
}

static inline bool busy(void *context)
{
    assert_ptr_equal(context, &board);
    return board.busy;
}

static const struct gud_device_ops ops = {window, line, end, display, busy};

static inline int start(void **state)
{
    (void)state;
    memset(&board, 0, sizeof board);
    memset(board.lines, FRESH, sizeof board.lines);
    memset(board.window, FRESH, sizeof board.window);
    board.config = (struct gud_device_config){.width = WIDTH,
                                              .height = HEIGHT,
                                              .refresh_hz = 60,
                                              .interface = INTERFACE,
                                              .output = GLINT_RGB565_SWAPPED,
                                              .formats = all_formats,
                                              .format_count = sizeof all_formats,
                                              .dimmable = true,
                                              .max_buffer = FRAME_MAX,
                                              .lines = board.lines,
                                              .lines_bytes = sizeof board.lines - GUARD,
                                              .window = board.window,
                                              .window_bytes = sizeof board.window - GUARD,
                                              .ops = &ops,
                                              .context = &board};
    assert_true(gud_device_init(&board.device, &board.config));
    return 0;
}

static inline int guards_are_untouched(void **state)
{
    (void)state;
    for (unsigned i = 0; i < GUARD; i++)
        if (board.lines[sizeof board.lines - GUARD + i] != FRESH ||
            board.window[sizeof board.window - GUARD + i] != FRESH)
            return -1;
    return 0;
}

/* ---- as a host ---- */

static uint8_t reply[GUD_REPLY_BYTES];

static inline int get(uint8_t request, uint16_t length)
{
    return gud_device_setup(&board.device, &(struct gud_setup){GUD_TYPE_IN, request, 0, INTERFACE, length}, reply);
}

static inline enum gud_status status(void)
{
    assert_int_equal(get(GUD_GET_STATUS, 1), 1);
    return reply[0];
}

/* The status that it leads to. */
static inline enum gud_status set(uint8_t request, const void *data, uint16_t length)
{
    const struct gud_setup setup = {GUD_TYPE_OUT, request, 0, INTERFACE, length};
    const int taken = gud_device_setup(&board.device, &setup, reply);
    const bool good = taken >= 0 && gud_device_set(&board.device, &setup, data);
    assert_true(taken == GUD_STALL || taken == length);
    const enum gud_status result = status();
    assert_int_equal(good, result == GUD_OK);
    return result;
}

static inline enum gud_status set_byte(uint8_t request, uint8_t value)
{
    return set(request, &value, 1);
}

static inline void state_of(uint8_t data[GUD_DATA_BYTES], uint8_t format)
{
    memset(data, 0, GUD_DATA_BYTES);
    gud_mode_pack(data, &(struct gud_mode){.hdisplay = WIDTH, .vdisplay = HEIGHT});
    data[GUD_MODE_BYTES] = format;
    data[GUD_STATE_BYTES] = GUD_BRIGHTNESS;
    data[GUD_STATE_BYTES + 2] = 70;
}

static inline void go(uint8_t format)
{
    uint8_t data[GUD_DATA_BYTES];
    state_of(data, format);
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, GUD_DATA_BYTES), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_DISPLAY_ENABLE, 1), GUD_OK);
}

static inline enum gud_status ask(const struct gud_rectangle *rectangle)
{
    uint8_t data[GUD_RECTANGLE_BYTES];
    gud_rectangle_pack(data, rectangle);
    return set(GUD_SET_BUFFER, data, sizeof data);
}

static uint32_t seed = 1;
static inline uint32_t random_below(uint32_t limit)
{
    seed = seed * 1664525 + 1013904223;
    return (uint32_t)((uint64_t)seed * limit >> 32);
}

static inline void send(const uint8_t *bytes, size_t count, bool in_pieces)
{
    while (count) {
        size_t piece = in_pieces ? 1 + random_below(random_below(2) ? 4 : 70) : count;
        piece = piece < count ? piece : count;
        gud_device_bulk(&board.device, bytes, piece);
        bytes += piece;
        count -= piece;
    }
}

/* A rectangle of the format that is set. */
static inline void draw(struct glint_box box, enum gud_format format, const uint8_t *bytes, bool lz4, bool in_pieces)
{
    uint8_t block[LZ4_COMPRESSBOUND(FRAME_MAX)];
    struct gud_rectangle r = {.x = box.x, .y = box.y, .width = box.w, .height = box.h};
    r.length = (uint32_t)gud_line_bytes(format, box.w) * box.h;
    if (lz4) {
        r.compression = GUD_COMPRESSION_LZ4;
        r.compressed_length =
            (uint32_t)LZ4_compress_default((const char *)bytes, (char *)block, (int)r.length, (int)sizeof block);
    }
    assert_int_equal(ask(&r), GUD_OK);
    const uint32_t count = lz4 ? r.compressed_length : r.length;
    assert_int_equal(gud_device_expects(&board.device), count);
    const unsigned whole = board.whole;
    send(lz4 ? block : bytes, count, in_pieces);
    assert_int_equal(gud_device_expects(&board.device), 0);
    assert_int_equal(board.whole, whole + 1);
    assert_int_equal(board.windows, board.ends);
    assert_int_equal(status(), GUD_OK);
}

static inline void fill_random(uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        bytes[i] = (uint8_t)(random_below(4) && i > 5 ? bytes[i - 5] : random_below(256));
}

#define DEVICE_TEST(test) cmocka_unit_test_setup_teardown(test, start, guards_are_untouched)

#endif
