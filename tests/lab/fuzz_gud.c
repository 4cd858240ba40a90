/* SPDX-License-Identifier: MIT
 * Fuzzes the GUD device with what a host may send: any requests, any bulk, in any order. Input: the display (7 bytes), then
 * steps: what (1), and what it needs. */
#include <string.h>

#include "fuzz.h"
#include "gud_device.h"

static const uint8_t formats[] = {GUD_RGB565,   GUD_R1, GUD_XRGB1111, GUD_RGB888,
                                  GUD_XRGB8888, GUD_R8, GUD_RGB332,   GUD_ARGB8888};
enum { INTERFACE = 1, FORMATS = sizeof formats };

static struct board {
    struct gud_device device;
    struct gud_device_config config;
    struct glint_box box;
    unsigned row;
    bool open, busy, has_bulk_within; /* before a request's data */
    const uint8_t *last;
} board;

static size_t output_bytes(void)
{
    return board.config.output == GLINT_RGB888 ? 3 : 2;
}

static void window(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    (void)context;
    check(!board.open);
    check(width && height && x + width <= board.config.width && y + height <= board.config.height);
    board.open = true;
    board.row = 0;
    board.box = (struct glint_box){x, y, width, height};
    board.last = NULL;
}

static void line(void *context, const uint8_t *pixels, size_t bytes)
{
    (void)context;
    static volatile uint8_t seen;
    check(board.open && board.row++ < board.box.h);
    check(bytes == output_bytes() * board.box.w);
    check(pixels != board.last);
    board.last = pixels;
    for (size_t i = 0; i < bytes; i++)
        seen = pixels[i]; /* readable */
    (void)seen;
}

static void end(void *context, bool whole)
{
    (void)context;
    check(board.open && whole == (board.row == board.box.h));
    board.open = false;
}

static void display(void *context, bool on, uint8_t brightness)
{
    (void)context;
    (void)on;
    check(brightness <= 100);
}

static bool busy(void *context)
{
    (void)context;
    return board.busy;
}

static const struct gud_device_ops ops = {window, line, end, display, busy};

/* Blocks of exactly the size that is told, so that the sanitizer knows their ends. */
static bool start(struct input *input)
{
    struct gud_device_config *c = &board.config;
    const unsigned kind = next_byte(input), width = next_byte(input), height = next_byte(input),
                   more = next_byte(input);
    memset(&board, 0, sizeof board);
    *c = (struct gud_device_config){.width = (uint16_t)width,
                                    .height = (uint16_t)height,
                                    .refresh_hz = 60,
                                    .interface = INTERFACE,
                                    .output = (uint8_t)(kind % 4),
                                    .formats = formats,
                                    .format_count = (uint8_t)(kind / 4 % (FORMATS + 1)),
                                    .status_after_set = more & 1,
                                    .whole_frames = more & 2,
                                    .dimmable = kind & 0x80,
                                    .max_buffer = next_word(input),
                                    .ops = &ops};
    const size_t lines_bytes = GUD_DEVICE_LINE_BYTES(c->width, 4, 3), fewer = next_byte(input);
    c->lines_bytes = lines_bytes > fewer ? lines_bytes - fewer : 0;
    c->window_bytes = kind & 0x40 ? c->max_buffer : 0;
    c->lines = malloc(c->lines_bytes + 1);
    c->window = c->window_bytes ? malloc(c->window_bytes) : NULL;
    return gud_device_init(&board.device, c);
}

static unsigned status(void)
{
    uint8_t reply[GUD_REPLY_BYTES];
    check(gud_device_setup(&board.device, &(struct gud_setup){GUD_TYPE_IN, GUD_GET_STATUS, 0, INTERFACE, 1}, reply) ==
          1);
    check(reply[0] <= GUD_ERROR);
    return reply[0];
}

static void request(const struct gud_setup *setup, struct input *input)
{
    uint8_t *const reply = malloc(GUD_REPLY_BYTES);
    const int length = gud_device_setup(&board.device, setup, reply);
    check(length >= GUD_STALL && length <= setup->length);
    if (length == GUD_STALL) {
        check(setup->index != INTERFACE || status() != GUD_OK);
    } else if (setup->type == GUD_TYPE_IN) {
        check(length <= GUD_REPLY_BYTES);
    } else {
        check(length == setup->length && length <= GUD_DATA_BYTES);
        size_t count = (size_t)length;
        uint8_t *const data = next_bytes(input, &count);
        if (board.has_bulk_within)
            gud_device_bulk(&board.device, (const uint8_t *)"within", 6);
        if (count == (size_t)length) {
            const bool good = gud_device_set(&board.device, setup, data);
            check(good == (status() == GUD_OK));
        }
        free(data);
    }
    free(reply);
}

/* Requests as a host sends them, so that the fuzzer need not find each byte of them. */
static void proper_state(unsigned format)
{
    uint8_t data[GUD_STATE_BYTES];
    struct input none = {data, data + sizeof data};
    gud_mode_pack(data, &(struct gud_mode){.hdisplay = board.config.width, .vdisplay = board.config.height});
    data[GUD_MODE_BYTES] = formats[format % FORMATS];
    data[GUD_MODE_BYTES + 1] = 0;
    request(&(struct gud_setup){GUD_TYPE_OUT, GUD_SET_STATE_CHECK, 0, INTERFACE, sizeof data}, &none);
    none = (struct input){(const uint8_t *)"\1\1", (const uint8_t *)"\1\1" + 2};
    request(&(struct gud_setup){GUD_TYPE_OUT, GUD_SET_CONTROLLER_ENABLE, 0, INTERFACE, 1}, &none);
    request(&(struct gud_setup){GUD_TYPE_OUT, GUD_SET_STATE_COMMIT, 0, INTERFACE, 0}, &none);
    request(&(struct gud_setup){GUD_TYPE_OUT, GUD_SET_DISPLAY_ENABLE, 0, INTERFACE, 1}, &none);
}

static void proper_rectangle(struct input *input, bool compressed)
{
    uint8_t data[GUD_RECTANGLE_BYTES];
    struct gud_rectangle r = {
        .x = next_byte(input), .y = next_byte(input), .width = next_byte(input), .height = next_byte(input)};
    if (board.config.whole_frames && r.width == 0) /* no other size is taken */
        r = (struct gud_rectangle){.width = board.config.width, .height = board.config.height};
    const uint8_t format = board.device.committed.format;
    r.length = (uint32_t)gud_line_bytes((enum gud_format)format, r.width) * r.height;
    r.compression = compressed;
    r.compressed_length = compressed ? next_word(input) : 0;
    gud_rectangle_pack(data, &r);
    struct input bytes = {data, data + sizeof data};
    request(&(struct gud_setup){GUD_TYPE_OUT, GUD_SET_BUFFER, 0, INTERFACE, sizeof data}, &bytes);
}

static void step(struct input *input)
{
    const unsigned what = next_byte(input);
    switch (what % 8) {
    case 0: {
        const struct gud_setup setup = next_setup(input);
        request(&setup, input);
        break;
    }
    case 1:
        proper_state(what / 8);
        break;
    case 2:
    case 3:
        proper_rectangle(input, what % 8 == 3);
        break;
    case 4:
    case 5: {
        size_t count = what % 8 == 4 ? what / 8 : next_word(input);
        uint8_t *const bytes = next_bytes(input, &count);
        uint32_t before = gud_device_expects(&board.device);
        if (!before && count && board.config.whole_frames && board.device.controller && board.device.committed.format)
            before = (uint32_t)gud_line_bytes((enum gud_format)board.device.committed.format, board.config.width) *
                     board.config.height;
        gud_device_bulk(&board.device, bytes, count);
        check(gud_device_expects(&board.device) == (count < before ? before - count : 0));
        check(gud_device_expects(&board.device) == 0 || board.open || board.config.whole_frames); /* busy: not drawn */
        check(count < before || !board.open);
        free(bytes);
        break;
    }
    case 6:
        if (what / 8 % 4 == 0)
            gud_device_reset(&board.device);
        else if (what / 8 % 4 == 1)
            gud_device_suspend(&board.device);
        else if (what / 8 % 4 == 2)
            gud_device_resume(&board.device);
        else
            gud_device_restart(&board.device);
        check(what / 8 % 4 || !board.open);
        check(what / 8 % 4 < 3 || !board.config.whole_frames || !board.open);
        break;
    default:
        board.busy = what / 8 % 2;
        board.has_bulk_within = what / 16 % 2;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, data + size};
    if (start(&input))
        while (input.at < input.end)
            step(&input);
    free(board.config.lines);
    free(board.config.window);
    return 0;
}
