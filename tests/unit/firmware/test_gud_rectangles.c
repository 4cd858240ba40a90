/* SPDX-License-Identifier: MIT
 * What the GUD device draws, and what it refuses to draw. */
#include "gud_board.h"

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
        {0, 0, 1, 1, 2, 1, 19}, /* too long for a block of 2 bytes */
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

static void window_of_any_size(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    (void)context;
    assert_true(x == 0 && y == 0 && width == 200 && height == 200);
}

static void a_block_that_the_window_cannot_hold_is_refused(void **state)
{
    (void)state;
    board.config.max_buffer = board.config.window_bytes = board.device.lz4.window_bytes = 4 * WIDTH;
    go(GUD_XRGB8888);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 1, 4 * WIDTH, 1, 50}), GUD_OK);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 2, 8 * WIDTH, 1, 50}), GUD_PARAMETER);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 2, 8 * WIDTH, 0, 0}), GUD_OK);        /* needs none */
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, 1, 4 * WIDTH, 1, 0}), GUD_PARAMETER); /* an empty block */
    board.config.width = board.config.height = 200; /* a window that reaches as far as LZ4 does is enough for any */
    board.config.window_bytes = LZ4_BLOCK_REACH;
    struct gud_device_ops large = ops;
    large.window = window_of_any_size;
    board.config.ops = &large;
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, 200, 200, 160000, 1, 50}), GUD_OK);
    board.config.window_bytes--;
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, 200, 200, 160000, 1, 50}), GUD_PARAMETER);
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

static void take_whole_frames(void)
{
    board.config.window = NULL;
    board.config.whole_frames = true;
    assert_true(gud_device_init(&board.device, &board.config));
}

static void a_device_that_takes_whole_frames_alone_needs_no_request_for_each(void **state)
{
    (void)state;
    struct gud_descriptor d;
    uint8_t bytes[2 * WIDTH * HEIGHT];
    take_whole_frames();
    assert_int_equal(get(GUD_GET_DESCRIPTOR, 30), 30);
    assert_true(gud_descriptor_unpack(&d, reply));
    assert_int_equal(d.flags, GUD_FLAG_FULL_UPDATE);
    fill_random(bytes, sizeof bytes);
    send(bytes, 100, false); /* no host may draw yet */
    assert_int_equal(board.windows, 0);
    go(GUD_RGB565);
    for (unsigned i = 1; i <= 3; i++) {
        send(bytes, sizeof bytes, i != 2);
        assert_int_equal(board.windows, i);
        assert_int_equal(board.whole, i);
        assert_true(board.box.w == WIDTH && board.box.h == HEIGHT && gud_device_expects(&board.device) == 0);
    }
    assert_int_equal(status(), GUD_OK);
    board.busy = true; /* what begins then is dropped, to its end */
    send(bytes, 50, false);
    board.busy = false;
    send(bytes + 50, sizeof bytes - 50, true);
    assert_int_equal(board.windows, 3);
    assert_int_equal(status(), GUD_BUSY); /* and a host that asks is told */
    send(bytes, 50, false);
    assert_int_equal(board.windows, 4);
    go(GUD_RGB565); /* a commit ends what was cut short */
    assert_int_equal(board.ends, 4);
    send(bytes, sizeof bytes, true);
    assert_int_equal(board.whole, 4);
}

static void no_frame_begins_without_a_byte_a_mode_or_a_display_that_is_on(void **state)
{
    (void)state;
    const uint8_t bytes[100] = {0};
    take_whole_frames();
    assert_int_equal(set_byte(GUD_SET_CONTROLLER_ENABLE, 1), GUD_OK);
    send(bytes, sizeof bytes, false);
    assert_int_equal(board.windows, 0);
    go(GUD_RGB565);
    gud_device_bulk(&board.device, bytes, 0);
    assert_int_equal(board.windows, 0);
    send(bytes, 1, false);
    assert_int_equal(board.windows, 1);
}

static void a_board_that_is_never_busy_takes_each_whole_frame(void **state)
{
    (void)state;
    const uint8_t bytes[2 * WIDTH * HEIGHT] = {0};
    const struct gud_device_ops idle = {window, line, end, display, NULL};
    board.config.ops = &idle;
    take_whole_frames();
    go(GUD_RGB565);
    send(bytes, sizeof bytes, false);
    assert_true(board.windows == 1 && board.whole == 1);
}

static void a_frame_that_begins_within_an_announcement_is_ended_before_the_announced_one(void **state)
{
    (void)state;
    uint8_t bytes[2 * WIDTH * HEIGHT], data[GUD_RECTANGLE_BYTES];
    const struct gud_setup setup = {GUD_TYPE_OUT, GUD_SET_BUFFER, 0, INTERFACE, sizeof data};
    gud_rectangle_pack(data, &(struct gud_rectangle){0, 0, WIDTH, HEIGHT, sizeof bytes, 0, 0});
    take_whole_frames();
    go(GUD_RGB565);
    fill_random(bytes, sizeof bytes);
    assert_int_equal(gud_device_setup(&board.device, &setup, reply), sizeof data);
    send(bytes, 50, false); /* between the request and its data */
    assert_int_equal(board.windows, 1);
    assert_true(gud_device_set(&board.device, &setup, data));
    assert_true(board.windows == 2 && board.ends == 1 && board.whole == 0);
    send(bytes, sizeof bytes, true);
    assert_true(board.ends == 2 && board.whole == 1 && gud_device_expects(&board.device) == 0);
}

/* Linux announces the frame that follows one that failed. */
static void a_device_of_whole_frames_takes_an_announcement_of_a_whole_one(void **state)
{
    (void)state;
    uint8_t bytes[2 * WIDTH * HEIGHT];
    take_whole_frames();
    go(GUD_RGB565);
    fill_random(bytes, sizeof bytes);
    for (unsigned i = 1; i <= 3; i++) {
        send(bytes, 100, false);
        assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, HEIGHT, sizeof bytes, 0, 0}), GUD_OK);
        assert_int_equal(gud_device_expects(&board.device), sizeof bytes);
        send(bytes, sizeof bytes, i != 2);
        assert_int_equal(board.whole, i);
        assert_int_equal(board.ends, 2 * i);
        assert_int_equal(gud_device_expects(&board.device), 0);
    }
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, HEIGHT - 1, 2 * WIDTH * (HEIGHT - 1), 0, 0}),
                     GUD_PARAMETER);
    assert_int_equal(ask(&(struct gud_rectangle){1, 0, WIDTH - 1, HEIGHT, 2 * (WIDTH - 1) * HEIGHT, 0, 0}),
                     GUD_PARAMETER);
    send(bytes, sizeof bytes, false); /* and goes on without one */
    assert_int_equal(board.whole, 4);
}

static void a_restart_of_the_bulk_data_ends_a_frame_that_nothing_announced(void **state)
{
    (void)state;
    uint8_t bytes[2 * WIDTH * HEIGHT];
    fill_random(bytes, sizeof bytes);
    go(GUD_RGB565);
    assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, HEIGHT, sizeof bytes, 0, 0}), GUD_OK);
    gud_device_restart(&board.device); /* not one that was announced */
    assert_int_equal(gud_device_expects(&board.device), sizeof bytes);
    send(bytes, sizeof bytes, false);
    assert_int_equal(board.whole, 1);
    take_whole_frames();
    go(GUD_RGB565);
    for (size_t cut = 0; cut < sizeof bytes; cut += 7) {
        const unsigned whole = board.whole;
        send(bytes, cut, false);
        gud_device_restart(&board.device);
        assert_int_equal(board.windows, board.ends);
        assert_int_equal(gud_device_expects(&board.device), 0);
        send(bytes, sizeof bytes, true);
        assert_int_equal(board.whole, whole + 1);
        assert_int_equal(gud_device_expects(&board.device), 0);
    }
    board.busy = true; /* also one that is dropped */
    send(bytes, 50, false);
    board.busy = false;
    gud_device_restart(&board.device);
    send(bytes, 1, false);
    assert_int_equal(board.windows, board.ends + 1);
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
        go((uint8_t)format);
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

static void every_format_is_converted_to_the_panels(void **state)
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
            go((uint8_t)format);
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

static void after_too_little_bulk_the_next_rectangle_starts_at_its_beginning(void **state)
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
            if (then) /* also where the next is refused: the bytes that follow are not the first one's */
                assert_int_equal(ask(&(struct gud_rectangle){0, 0, 0, 0, 0, 0, 0}), GUD_PARAMETER);
            assert_int_equal(gud_device_expects(&board.device), then ? 0 : 4 * WIDTH - cut);
            draw((struct glint_box){1, 5, 1, 1}, GUD_RGB565, (uint8_t[]){0x22, 0x33}, false, false);
            assert_memory_equal(board.panel + 2 * (5 * WIDTH + 1), "\x33\x22\0", 3);
            for (unsigned i = 0; i < 4 * WIDTH; i++) /* whole lines, or nothing */
                assert_int_equal(board.panel[i], i < cut / (2 * WIDTH) * 2 * WIDTH ? 0x11 : 0);
        }
}

/* The clock goes through its end on the way. */
static void a_rectangle_for_which_nothing_comes_ends_and_one_that_is_slow_does_not(void **state)
{
    (void)state;
    uint8_t bytes[2 * WIDTH * HEIGHT];
    uint32_t now_us = UINT32_MAX - 7000000;
    fill_random(bytes, sizeof bytes);
    go(GUD_RGB565);
    gud_device_time(&board.device, now_us);
    for (unsigned taken = 0; taken < 3; taken++) {
        const struct glint_box first = {0, 0, WIDTH, 2};
        assert_int_equal(ask(&(struct gud_rectangle){0, 0, WIDTH, HEIGHT, sizeof bytes, 0, 0}), GUD_OK);
        gud_device_time(&board.device, now_us += 123456789);
        for (unsigned i = 0; i < taken; i++) {
            send(bytes + 50 * i, 50, false);
            gud_device_time(&board.device, now_us);
            gud_device_time(&board.device, now_us += 1000 * GUD_ABANDONED_MS - 1);
            assert_int_equal(board.windows, board.ends + 1);
        }
        send(bytes + 50 * taken, 1, false);
        gud_device_time(&board.device, now_us);
        gud_device_time(&board.device, now_us += 1000 * GUD_ABANDONED_MS);
        assert_int_equal(board.windows, board.ends);
        assert_int_equal(gud_device_expects(&board.device), 0);
        send(bytes, 5, false);
        assert_int_equal(status(), GUD_PROTOCOL); /* its host is back, too late */
        draw(first, GUD_RGB565, bytes, false, true);
    }
    take_whole_frames(); /* of which nothing but its end tells where the next one begins */
    go(GUD_RGB565);
    send(bytes, 50, false);
    gud_device_time(&board.device, now_us);
    gud_device_time(&board.device, now_us + 2000 * GUD_ABANDONED_MS);
    assert_int_equal(board.windows, board.ends + 1);
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

static void an_impossible_config_is_refused(void **state)
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
    REFUSED((c.max_buffer = (uint32_t)INT32_MAX + 1, c.window = NULL));
    REFUSED(c.lines_bytes = GUD_DEVICE_LINE_BYTES(WIDTH, 4, 2) - 1);
    REFUSED(c.window_bytes = c.max_buffer - 1);
    REFUSED(c.whole_frames = true); /* with LZ4 */
    REFUSED((c.whole_frames = true, c.window = NULL, c.max_buffer = 4 * WIDTH * HEIGHT - 1));
    c = good;
    c.max_buffer = INT32_MAX;
    c.window = NULL;
    assert_true(gud_device_init(&device, &c));
    c = good;
    c.max_buffer = 1 << 20;
    c.window_bytes = LZ4_BLOCK_REACH;
    c.output = GLINT_RGB888;
    assert_true(gud_device_init(&device, &c));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        DEVICE_TEST(rectangles_that_do_not_fit_are_parameter_errors),
        DEVICE_TEST(a_block_that_the_window_cannot_hold_is_refused),
        DEVICE_TEST(compression_that_is_not_offered_is_refused),
        DEVICE_TEST(a_board_that_is_busy_says_so),
        DEVICE_TEST(a_device_that_takes_whole_frames_alone_needs_no_request_for_each),
        DEVICE_TEST(no_frame_begins_without_a_byte_a_mode_or_a_display_that_is_on),
        DEVICE_TEST(a_board_that_is_never_busy_takes_each_whole_frame),
        DEVICE_TEST(a_frame_that_begins_within_an_announcement_is_ended_before_the_announced_one),
        DEVICE_TEST(a_device_of_whole_frames_takes_an_announcement_of_a_whole_one),
        DEVICE_TEST(a_restart_of_the_bulk_data_ends_a_frame_that_nothing_announced),
        DEVICE_TEST(any_pieces_raw_or_compressed_draw_the_same),
        DEVICE_TEST(every_format_is_converted_to_the_panels),
        DEVICE_TEST(bulk_that_no_rectangle_expects_is_dropped),
        DEVICE_TEST(after_too_little_bulk_the_next_rectangle_starts_at_its_beginning),
        DEVICE_TEST(a_rectangle_for_which_nothing_comes_ends_and_one_that_is_slow_does_not),
        DEVICE_TEST(a_broken_block_leaves_an_error_and_the_next_rectangle_is_drawn),
        DEVICE_TEST(an_impossible_config_is_refused),
    };
    return cmocka_run_group_tests_name("gud rectangles", tests, NULL, NULL);
}
