/* SPDX-License-Identifier: MIT
 * The portable GUD device: every request, wrong ones, the order of things, bulk in any pieces, the bus. */
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

static unsigned output_bytes(void)
{
    return board.config.output == GLINT_RGB888 ? 3 : 2;
}

static void window(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    assert_ptr_equal(context, &board);
    assert_int_equal(board.windows, board.ends);
    assert_true(width && height && x + width <= WIDTH && y + height <= HEIGHT);
    board.box = (struct glint_box){x, y, width, height};
    board.row = 0;
    board.windows++;
    board.last_bytes = 0;
}

static void line(void *context, const uint8_t *pixels, size_t bytes)
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

static void end(void *context, bool whole)
{
    assert_ptr_equal(context, &board);
    assert_int_equal(whole, board.row == board.box.h);
    board.ends++;
    board.whole += whole;
}

static void display(void *context, bool on, uint8_t brightness)
{
    assert_ptr_equal(context, &board);
    board.displays++;
    board.on = on;
    board.brightness = brightness;
}

static bool busy(void *context)
{
    assert_ptr_equal(context, &board);
    return board.busy;
}

static const struct gud_device_ops ops = {window, line, end, display, busy};

static int start(void **state)
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

static int guards_are_untouched(void **state)
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

static int get(uint8_t request, uint16_t length)
{
    return gud_device_setup(&board.device, &(struct gud_setup){GUD_TYPE_IN, request, 0, INTERFACE, length}, reply);
}

static enum gud_status status(void)
{
    assert_int_equal(get(GUD_GET_STATUS, 1), 1);
    return reply[0];
}

/* The status that it leads to. */
static enum gud_status set(uint8_t request, const void *data, uint16_t length)
{
    const struct gud_setup setup = {GUD_TYPE_OUT, request, 0, INTERFACE, length};
    const int taken = gud_device_setup(&board.device, &setup, reply);
    const bool good = taken >= 0 && gud_device_set(&board.device, &setup, data);
    assert_true(taken == GUD_STALL || taken == length);
    const enum gud_status result = status();
    assert_int_equal(good, result == GUD_OK);
    return result;
}

static enum gud_status set_byte(uint8_t request, uint8_t value)
{
    return set(request, &value, 1);
}

static void state_of(uint8_t data[GUD_DATA_BYTES], uint8_t format)
{
    memset(data, 0, GUD_DATA_BYTES);
    gud_mode_pack(data, &(struct gud_mode){.hdisplay = WIDTH, .vdisplay = HEIGHT});
    data[GUD_MODE_BYTES] = format;
    data[GUD_STATE_BYTES] = GUD_BRIGHTNESS;
    data[GUD_STATE_BYTES + 2] = 70;
}

static void go(uint8_t format)
{
    uint8_t data[GUD_DATA_BYTES];
    state_of(data, format);
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, GUD_DATA_BYTES), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_DISPLAY_ENABLE, 1), GUD_OK);
}

static enum gud_status ask(const struct gud_rectangle *rectangle)
{
    uint8_t data[GUD_RECTANGLE_BYTES];
    gud_rectangle_pack(data, rectangle);
    return set(GUD_SET_BUFFER, data, sizeof data);
}

static uint32_t seed = 1;
static uint32_t random_below(uint32_t limit)
{
    seed = seed * 1664525 + 1013904223;
    return (uint32_t)((uint64_t)seed * limit >> 32);
}

static void send(const uint8_t *bytes, size_t count, bool in_pieces)
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
static void draw(struct glint_box box, enum gud_format format, const uint8_t *bytes, bool lz4, bool in_pieces)
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

static void fill_random(uint8_t *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++)
        bytes[i] = (uint8_t)(random_below(4) && i > 5 ? bytes[i - 5] : random_below(256));
}

/* ---- requests ---- */

static void the_descriptor_tells_size_buffer_and_compression(void **state)
{
    (void)state;
    struct gud_descriptor d;
    assert_int_equal(get(GUD_GET_DESCRIPTOR, 30), 30);
    assert_true(gud_descriptor_unpack(&d, reply));
    assert_int_equal(d.flags, 0);
    assert_int_equal(d.compression, GUD_COMPRESSION_LZ4);
    assert_int_equal(d.max_buffer, FRAME_MAX);
    assert_int_equal(d.min_width, WIDTH);
    assert_int_equal(d.max_width, WIDTH);
    assert_int_equal(d.min_height, HEIGHT);
    assert_int_equal(d.max_height, HEIGHT);
    board.config.window = NULL;
    board.config.status_after_set = true;
    assert_int_equal(get(GUD_GET_DESCRIPTOR, 30), 30);
    assert_true(gud_descriptor_unpack(&d, reply));
    assert_int_equal(d.flags, GUD_FLAG_STATUS);
    assert_int_equal(d.compression, 0);
}

static void the_mode_is_the_panel_at_its_rate(void **state)
{
    (void)state;
    struct gud_mode m;
    assert_int_equal(get(GUD_GET_CONNECTOR_MODES, 3072), GUD_MODE_BYTES);
    gud_mode_unpack(&m, reply);
    assert_int_equal(m.hdisplay, WIDTH);
    assert_int_equal(m.vdisplay, HEIGHT);
    assert_int_equal(m.flags, GUD_MODE_PREFERRED);
    assert_true(m.clock_khz > 0 && m.hsync_start >= WIDTH && m.hsync_end >= m.hsync_start && m.htotal >= m.hsync_end);
    assert_true(m.vsync_start >= HEIGHT && m.vsync_end >= m.vsync_start && m.vtotal >= m.vsync_end);
}

static const struct {
    uint8_t request;
    int bytes;
} gets[] = {{GUD_GET_STATUS, 1},           {GUD_GET_DESCRIPTOR, 30},      {GUD_GET_FORMATS, sizeof all_formats},
            {GUD_GET_PROPERTIES, 0},       {GUD_GET_CONNECTORS, 5},       {GUD_GET_CONNECTOR_PROPERTIES, 10},
            {GUD_GET_CONNECTOR_STATUS, 1}, {GUD_GET_CONNECTOR_MODES, 24}, {GUD_GET_CONNECTOR_EDID, 0}},
  sets[] = {{GUD_SET_CONNECTOR_FORCE_DETECT, 0}, {GUD_SET_BUFFER, 25},           {GUD_SET_STATE_CHECK, 26},
            {GUD_SET_STATE_COMMIT, 0},           {GUD_SET_CONTROLLER_ENABLE, 1}, {GUD_SET_DISPLAY_ENABLE, 1}};
enum { GETS = sizeof gets / sizeof *gets, SETS = sizeof sets / sizeof *sets };

static void each_reply_has_its_length_cut_to_what_the_host_takes(void **state)
{
    (void)state;
    for (unsigned i = 0; i < GETS; i++)
        for (uint16_t length = 1; length < 300; length++) {
            memset(reply, FRESH, sizeof reply);
            const int wanted = gets[i].bytes < length ? gets[i].bytes : length;
            assert_int_equal(get(gets[i].request, length), wanted);
            assert_int_equal(status(), GUD_OK);
        }
}

static void unknown_requests_are_unsupported(void **state)
{
    (void)state;
    for (unsigned type = 0; type < 256; type++)
        for (unsigned request = 0; request < 256; request++) {
            bool known = false;
            for (unsigned i = 0; i < GETS; i++)
                known |= type == GUD_TYPE_IN && request == gets[i].request;
            for (unsigned i = 0; i < SETS; i++)
                known |= type == GUD_TYPE_OUT && request == sets[i].request;
            if (known)
                continue;
            const struct gud_setup setup = {(uint8_t)type, (uint8_t)request, 0, INTERFACE, 1};
            assert_int_equal(gud_device_setup(&board.device, &setup, reply), GUD_STALL);
            assert_int_equal(status(), GUD_UNSUPPORTED);
        }
}

static void wrong_lengths_are_protocol_errors(void **state)
{
    (void)state;
    static const uint8_t data[300];
    go(GUD_RGB565);
    for (unsigned i = 0; i < SETS; i++)
        for (uint16_t length = 0; length < 300; length++)
            if (length != sets[i].bytes && !(sets[i].request == GUD_SET_STATE_CHECK && length == GUD_DATA_BYTES))
                assert_int_equal(set(sets[i].request, data, length), GUD_PROTOCOL);
    for (unsigned i = 0; i < GETS; i++) {
        assert_int_equal(get(gets[i].request, 0), GUD_STALL);
        assert_int_equal(status(), GUD_PROTOCOL);
    }
    board.config.dimmable = false;
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, GUD_DATA_BYTES), GUD_PROTOCOL);
    assert_int_equal(get(GUD_GET_CONNECTOR_PROPERTIES, 320), 0);
}

static void a_request_to_another_interface_is_refused_and_changes_nothing(void **state)
{
    (void)state;
    go(GUD_RGB565);
    draw((struct glint_box){0, 0, 1, 1}, GUD_RGB565, (uint8_t[]){1, 2}, false, false);
    const struct gud_device before = board.device;
    for (unsigned index = 0; index < 65536; index += index < 10 ? 1 : 253) {
        if (index == INTERFACE)
            continue;
        const struct gud_setup buffer = {GUD_TYPE_OUT, GUD_SET_BUFFER, 0, (uint16_t)index, 25},
                               descriptor = {GUD_TYPE_IN, GUD_GET_DESCRIPTOR, 0, (uint16_t)index, 30};
        assert_int_equal(gud_device_setup(&board.device, &buffer, reply), GUD_STALL);
        assert_int_equal(gud_device_setup(&board.device, &descriptor, reply), GUD_STALL);
        assert_memory_equal(&board.device, &before, sizeof before);
    }
}

static void there_is_one_connector(void **state)
{
    (void)state;
    for (uint8_t request = GUD_GET_CONNECTORS; request <= GUD_GET_CONNECTOR_EDID; request++) {
        const bool in = request != GUD_SET_CONNECTOR_FORCE_DETECT;
        if (request == 0x52)
            continue;
        const struct gud_setup setup = {in ? GUD_TYPE_IN : GUD_TYPE_OUT, request, 1, INTERFACE, in ? 8 : 0};
        const int result = gud_device_setup(&board.device, &setup, reply);
        assert_int_equal(result == GUD_STALL, request != GUD_GET_CONNECTORS);
        assert_int_equal(status(), request == GUD_GET_CONNECTORS ? GUD_OK : GUD_PARAMETER);
    }
    assert_int_equal(get(GUD_GET_CONNECTOR_STATUS, 1), 1);
    assert_int_equal(reply[0], GUD_CONNECTED);
}

/* ---- the state ---- */

static void a_state_that_the_panel_has_not_is_refused(void **state)
{
    (void)state;
    static const struct {
        unsigned at;
        uint8_t value;
    } wrong[] = {{4, WIDTH + 1}, {5, 1},  {12, HEIGHT - 1}, {24, 0}, {24, 0x41}, {25, 1},
                 {26, 11},       {27, 1}, {28, 101},        {29, 1}, {35, 1}};
    uint8_t data[GUD_DATA_BYTES];
    for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        state_of(data, GUD_R8);
        assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_OK);
        data[wrong[i].at] = wrong[i].value;
        assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_PARAMETER);
        assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
        assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_PROTOCOL);
    }
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 2), GUD_PARAMETER);
    assert_int_equal(set_byte(GUD_SET_DISPLAY_ENABLE, 255), GUD_PARAMETER);
}

static void steps_out_of_order_are_protocol_errors(void **state)
{
    (void)state;
    const struct gud_rectangle pixel = {0, 0, 1, 1, 2, 0, 0};
    uint8_t data[GUD_DATA_BYTES];
    state_of(data, GUD_RGB565);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_PROTOCOL);
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, GUD_STATE_BYTES), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_PROTOCOL); /* the controller is off */
    assert_int_equal(set_byte(GUD_SET_DISPLAY_ENABLE, 1), GUD_PROTOCOL);
    assert_int_equal(ask(&pixel), GUD_PROTOCOL);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_PROTOCOL);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_OK);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 0), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_PROTOCOL);
}

static void a_check_changes_nothing_until_its_commit(void **state)
{
    (void)state;
    uint8_t data[GUD_DATA_BYTES];
    go(GUD_RGB565);
    state_of(data, GUD_R8);
    const struct gud_rectangle pixel = {0, 0, 1, 1, 2, 0, 0};
    assert_int_equal(ask(&pixel), GUD_OK);
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_OK);
    send((uint8_t[]){0x34, 0x12}, 2, false);
    assert_memory_equal(board.panel, "\x12\x34", 2);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_int_equal(ask(&pixel), GUD_PARAMETER); /* a pixel is one byte now */
}

static void the_display_is_told_what_changes(void **state)
{
    (void)state;
    go(GUD_RGB565);
    assert_true(board.on && board.brightness == 70 && board.displays == 1);
    gud_device_suspend(&board.device);
    assert_true(!board.on && board.displays == 2);
    gud_device_suspend(&board.device);
    assert_int_equal(board.displays, 2);
    gud_device_resume(&board.device);
    assert_true(board.on && board.displays == 3);
    uint8_t data[GUD_DATA_BYTES];
    state_of(data, GUD_RGB565);
    data[GUD_STATE_BYTES + 2] = 5;
    assert_int_equal(set(GUD_SET_STATE_CHECK, data, sizeof data), GUD_OK);
    assert_int_equal(board.displays, 3);
    assert_int_equal(set(GUD_SET_STATE_COMMIT, NULL, 0), GUD_OK);
    assert_true(board.on && board.brightness == 5 && board.displays == 4);
    assert_int_equal(get(GUD_GET_CONNECTOR_PROPERTIES, 320), 10);
    assert_int_equal(reply[2], 5);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 0), GUD_OK);
    assert_true(!board.on && board.displays == 5);
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    assert_int_equal(board.displays, 5); /* the display has to be enabled again, too */
}

static void a_bus_reset_forgets_what_the_host_had_set(void **state)
{
    (void)state;
    const struct gud_rectangle two_lines = {0, 0, 2, 2, 8, 0, 0};
    go(GUD_RGB565);
    assert_int_equal(ask(&two_lines), GUD_OK);
    send((uint8_t[5]){0}, 5, false);
    gud_device_reset(&board.device);
    assert_true(!board.on && board.ends == 1 && board.whole == 0);
    assert_int_equal(gud_device_expects(&board.device), 0);
    assert_int_equal(ask(&two_lines), GUD_PROTOCOL);
    go(GUD_R8);
    draw((struct glint_box){0, 0, 1, 1}, GUD_R8, (uint8_t[]){255}, false, false);
}

/* ---- rectangles ---- */

static void rectangles_that_do_not_fit_are_parameter_errors(void **state)
{
    (void)state;
    static const struct gud_rectangle wrong[] = {
        {0, 0, 0, 1, 0, 0, 0},
        {0, 0, 1, 0, 0, 0, 0},
        {WIDTH, 0, 1, 1, 2, 0, 0},
        {0, HEIGHT, 1, 1, 2, 0, 0},
        {1, 0, WIDTH, 1, 2 * WIDTH, 0, 0},
        {0, 1, 1, HEIGHT, 2 * HEIGHT, 0, 0},
        {UINT32_MAX, 0, 2, 1, 4, 0, 0},
        {1, 1, UINT32_MAX, 1, 2, 0, 0},
        {0, 0, 0x80000001, 2, 4, 0, 0}, /* 2 * width and height * line wrap to it */
        {0, 0, 1, 1, 1, 0, 0},
        {0, 0, 1, 1, 3, 0, 0},
        {0, 0, 1, 1, UINT32_MAX, 0, 0},
        {0, 0, 1, 1, 2, 0, 2},  /* not compressed, with a compressed length */
        {0, 0, 1, 1, 2, 1, 0},  /* compressed to nothing */
        {0, 0, 1, 1, 2, 2, 2},  /* no such compression */
        {0, 0, 1, 1, 2, 1, 19}, /* no block of 2 bytes is as long */
        {0, 0, 1, 1, 2, 1, UINT32_MAX},
    };
    go(GUD_RGB565);
    for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        if (ask(&wrong[i]) != GUD_PARAMETER)
            fail_msg("rectangle %u is not refused as it should be", i);
        assert_int_equal(gud_device_expects(&board.device), 0);
    }
    assert_int_equal(board.windows, 0);
    go(GUD_R1);
    assert_int_equal(ask(&(struct gud_rectangle){4, 0, 8, 1, 1, 0, 0}), GUD_PARAMETER);
    go(GUD_XRGB1111);
    assert_int_equal(ask(&(struct gud_rectangle){3, 0, 2, 1, 1, 0, 0}), GUD_PARAMETER);
}

static void a_block_that_the_window_cannot_hold_is_refused(void **state)
{
    (void)state;
    board.config.max_buffer = board.config.window_bytes = board.device.lz4.window_bytes = 4 * WIDTH;
    go(GUD_XRGB8888);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 1, 4 * WIDTH, 1, 50}), GUD_OK);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 2, 8 * WIDTH, 1, 50}), GUD_PARAMETER);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 2, 8 * WIDTH, 0, 0}), GUD_OK); /* needs none */
}

static void compression_that_is_not_offered_is_refused(void **state)
{
    (void)state;
    board.config.window = NULL;
    go(GUD_RGB565);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, 1, 1, 2, 1, 3}), GUD_PARAMETER);
}

static void a_board_that_is_busy_says_so(void **state)
{
    (void)state;
    go(GUD_RGB565);
    board.busy = true;
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, 1, 1, 2, 0, 0}), GUD_BUSY);
    assert_int_equal(gud_device_expects(&board.device), 0);
    board.busy = false;
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, 1, 1, 2, 0, 0}), GUD_OK);
}

static void any_pieces_raw_or_compressed_draw_the_same(void **state)
{
    (void)state;
    uint8_t bytes[FRAME_MAX], whole[sizeof board.panel];
    for (unsigned i = 0; i < 300; i++) {
        const enum gud_format format = all_formats[i % sizeof all_formats];
        struct glint_box box = {.x = (uint16_t)random_below(WIDTH), .y = (uint16_t)random_below(HEIGHT)};
        if (format == GUD_R1 || format == GUD_XRGB1111)
            box.x &= 0xfff8;
        box.w = (uint16_t)(1 + random_below(WIDTH - box.x));
        box.h = (uint16_t)(1 + random_below(HEIGHT - box.y));
        fill_random(bytes, sizeof bytes);
        go(format);
        for (unsigned how = 0; how < 4; how++) {
            memset(board.panel, FRESH, sizeof board.panel);
            draw(box, format, bytes, how & 1, how & 2);
            if (how == 0)
                memcpy(whole, board.panel, sizeof whole);
            assert_memory_equal(board.panel, whole, sizeof whole);
        }
        for (unsigned y = 0; y < HEIGHT; y++)
            for (unsigned x = 0; x < WIDTH; x++)
                if (x < box.x || x >= box.x + box.w || y < box.y || y >= box.y + box.h)
                    assert_memory_equal(board.panel + 2 * (y * WIDTH + x), "\xa5\xa5", 2);
    }
}

/* ---- pixels, by another formula than the device's: in double precision ---- */

static unsigned level(unsigned value, unsigned bits)
{
    return (unsigned)lround(value * 255. / ((1 << bits) - 1));
}

static void rgb_of(unsigned rgb[3], enum gud_format format, const uint8_t *line_bytes, unsigned x)
{
    const uint8_t *p = line_bytes + gud_line_bytes(format, x);
    const unsigned nibble = x % 2 ? line_bytes[x / 2] & 15u : line_bytes[x / 2] >> 4, v = p[0] + 256u * p[1];
    const unsigned bit = line_bytes[x / 8] & 0x80u >> x % 8 ? 255 : 0;
    const unsigned values[][4] = {{GUD_R1, bit, bit, bit},
                                  {GUD_R8, p[0], p[0], p[0]},
                                  {GUD_XRGB1111, nibble & 4 ? 255 : 0, nibble & 2 ? 255 : 0, nibble & 1 ? 255 : 0},
                                  {GUD_RGB332, level(p[0] / 32, 3), level(p[0] / 4 % 8, 3), level(p[0] % 4, 2)},
                                  {GUD_RGB565, level(v / 2048, 5), level(v / 32 % 64, 6), level(v % 32, 5)},
                                  {GUD_RGB888, p[2], p[1], p[0]},
                                  {GUD_XRGB8888, p[2], p[1], p[0]},
                                  {GUD_ARGB8888, p[2], p[1], p[0]}};
    for (unsigned i = 0; i < sizeof values / sizeof *values; i++)
        if (values[i][0] == format)
            memcpy(rgb, values[i] + 1, 3 * sizeof *rgb);
}

static void every_format_becomes_what_the_panel_takes(void **state)
{
    (void)state;
    static const uint8_t outputs[] = {GLINT_RGB565, GLINT_RGB565_SWAPPED, GLINT_RGB888};
    uint8_t bytes[FRAME_MAX];
    for (unsigned turn = 0; turn < 20 * sizeof all_formats; turn++)
        for (unsigned o = 0; o < sizeof outputs; o++) {
            const enum gud_format format = all_formats[turn % sizeof all_formats];
            for (unsigned i = 0; i < sizeof bytes; i++)
                bytes[i] = (uint8_t)random_below(256);
            board.config.output = outputs[o];
            go(format);
            draw((struct glint_box){0, 0, WIDTH, 1}, format, bytes, false, false);
            for (unsigned x = 0; x < WIDTH; x++) {
                unsigned rgb[3] = {0};
                rgb_of(rgb, format, bytes, x);
                const uint8_t *out = board.panel + output_bytes() * x;
                const unsigned packed = rgb[0] / 8 * 2048 + rgb[1] / 4 * 32 + rgb[2] / 8;
                if (outputs[o] == GLINT_RGB888) {
                    for (unsigned c = 0; c < 3; c++)
                        assert_int_equal(out[c], rgb[c]);
                } else {
                    const unsigned high = outputs[o] == GLINT_RGB565 ? 1 : 0;
                    assert_int_equal(out[high] * 256u + out[1 - high], packed);
                }
            }
        }
}

/* ---- too much, too little, broken ---- */

static void bulk_that_no_rectangle_expects_is_dropped(void **state)
{
    (void)state;
    uint8_t bytes[2 * WIDTH + 7];
    memset(bytes, 0x11, sizeof bytes);
    send(bytes, sizeof bytes, false); /* before anything */
    assert_int_equal(status(), GUD_PROTOCOL);
    go(GUD_RGB565);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 1, 2 * WIDTH, 0, 0}), GUD_OK);
    send(bytes, sizeof bytes, false);
    assert_int_equal(status(), GUD_PROTOCOL);
    assert_int_equal(board.whole, 1);
    assert_int_equal(board.panel[2 * WIDTH], 0);
    draw((struct glint_box){0, 1, 1, 1}, GUD_RGB565, (uint8_t[]){0x22, 0x33}, false, false);
    assert_memory_equal(board.panel + 2 * WIDTH, "\x33\x22\0", 3);
}

static void after_too_little_bulk_the_next_rectangle_starts_anew(void **state)
{
    (void)state;
    uint8_t bytes[FRAME_MAX];
    memset(bytes, 0x11, sizeof bytes);
    for (unsigned cut = 0; cut < 4 * WIDTH; cut++)
        for (unsigned then = 0; then < 2; then++) {
            memset(board.panel, 0, sizeof board.panel);
            go(GUD_RGB565);
            assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 2, 4 * WIDTH, 0, 0}), GUD_OK);
            send(bytes, cut, false);
            if (then) /* also where the next is refused: what follows is not for the first */
                assert_int_equal(ask(&(struct gud_rectangle){0, 0, 0, 0, 0, 0, 0}), GUD_PARAMETER);
            assert_int_equal(gud_device_expects(&board.device), then ? 0 : 4 * WIDTH - cut);
            draw((struct glint_box){1, 5, 1, 1}, GUD_RGB565, (uint8_t[]){0x22, 0x33}, false, false);
            assert_memory_equal(board.panel + 2 * (5 * WIDTH + 1), "\x33\x22\0", 3);
            for (unsigned i = 0; i < 4 * WIDTH; i++) /* whole lines, or nothing */
                assert_int_equal(board.panel[i], i < cut / (2 * WIDTH) * 2 * WIDTH ? 0x11 : 0);
        }
}

static void a_broken_block_leaves_an_error_and_the_next_rectangle_is_drawn(void **state)
{
    (void)state;
    uint8_t bytes[2 * WIDTH * HEIGHT], block[LZ4_COMPRESSBOUND(sizeof bytes)];
    go(GUD_RGB565);
    for (unsigned i = 0; i < 2000; i++) {
        fill_random(bytes, sizeof bytes);
        const int count = LZ4_compress_default((char *)bytes, (char *)block, sizeof bytes, sizeof block);
        block[random_below((uint32_t)count)] ^= (uint8_t)(1 + random_below(255));
        const uint8_t *const good = block;
        const struct gud_rectangle r = {0, 0, WIDTH, HEIGHT, sizeof bytes, 1, (uint32_t)count};
        uint8_t reference[sizeof bytes];
        const bool right =
            LZ4_decompress_safe((const char *)good, (char *)reference, count, sizeof reference) == sizeof reference;
        assert_int_equal(ask(&r), GUD_OK);
        send(block, (size_t)count, true);
        assert_int_equal(gud_device_expects(&board.device), 0);
        assert_int_equal(board.windows, board.ends);
        const enum gud_status result = status();
        assert_true(result == GUD_ERROR || (right && result == GUD_OK));
        draw((struct glint_box){0, 0, WIDTH, HEIGHT}, GUD_RGB565, bytes, true, true);
    }
}

/* ---- configs ---- */

static void a_config_that_cannot_be_is_refused(void **state)
{
    (void)state;
    struct gud_device device;
    const struct gud_device_config good = board.config;
    struct gud_device_config c;
    static const uint8_t no_format[] = {GUD_RGB565, 0x41};
#define REFUSED(change) (c = good, change, assert_false(gud_device_init(&device, &c)))
    REFUSED(c.width = 0);
    REFUSED(c.height = 0);
    REFUSED(c.format_count = 0);
    REFUSED(c.format_count = GUD_FORMATS_MAX + 1);
    REFUSED((c.formats = no_format, c.format_count = 2));
    REFUSED(c.output = GLINT_GREY8);
    REFUSED(c.max_buffer = 4 * WIDTH - 1);
    REFUSED(c.max_buffer = (uint32_t)INT32_MAX + 1);
    REFUSED(c.lines_bytes = GUD_DEVICE_LINE_BYTES(WIDTH, 4, 2) - 1);
    REFUSED(c.window_bytes = c.max_buffer - 1);
    c = good;
    c.max_buffer = 1 << 20;
    c.window_bytes = LZ4_BLOCK_REACH;
    assert_true(gud_device_init(&device, &c));
}

#define DEVICE_TEST(test) cmocka_unit_test_setup_teardown(test, start, guards_are_untouched)

int main(void)
{
    const struct CMUnitTest tests[] = {
        DEVICE_TEST(the_descriptor_tells_size_buffer_and_compression),
        DEVICE_TEST(the_mode_is_the_panel_at_its_rate),
        DEVICE_TEST(each_reply_has_its_length_cut_to_what_the_host_takes),
        DEVICE_TEST(unknown_requests_are_unsupported),
        DEVICE_TEST(wrong_lengths_are_protocol_errors),
        DEVICE_TEST(a_request_to_another_interface_is_refused_and_changes_nothing),
        DEVICE_TEST(there_is_one_connector),
        DEVICE_TEST(a_state_that_the_panel_has_not_is_refused),
        DEVICE_TEST(steps_out_of_order_are_protocol_errors),
        DEVICE_TEST(a_check_changes_nothing_until_its_commit),
        DEVICE_TEST(the_display_is_told_what_changes),
        DEVICE_TEST(a_bus_reset_forgets_what_the_host_had_set),
        DEVICE_TEST(rectangles_that_do_not_fit_are_parameter_errors),
        DEVICE_TEST(a_block_that_the_window_cannot_hold_is_refused),
        DEVICE_TEST(compression_that_is_not_offered_is_refused),
        DEVICE_TEST(a_board_that_is_busy_says_so),
        DEVICE_TEST(any_pieces_raw_or_compressed_draw_the_same),
        DEVICE_TEST(every_format_becomes_what_the_panel_takes),
        DEVICE_TEST(bulk_that_no_rectangle_expects_is_dropped),
        DEVICE_TEST(after_too_little_bulk_the_next_rectangle_starts_anew),
        DEVICE_TEST(a_broken_block_leaves_an_error_and_the_next_rectangle_is_drawn),
        DEVICE_TEST(a_config_that_cannot_be_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
