/* SPDX-License-Identifier: MIT
 * The usb sink against a USB display through the kernel's host and gadget sides: what arrives is what was drawn. */
#include "image/format.h"
#include "run.h"

#include <lz4.h>
#include <lz4hc.h>

#include "image/format.h"
#include "sinks/sinks.h"
#include "sinks/usb/options.h"
#include "usb_display.h"

#include "gud_protocol.h"

static struct usb_display display;

/* ---- pictures ---- */

struct picture_form {
    const char *name;
    enum gud_format offered;
    enum glint_format pixels;
};

static const struct picture_form forms[] = {
    {"rgb565", GUD_RGB565, GLINT_RGB565},
    {"rgb888", GUD_RGB888, GLINT_RGB888},
    {"xrgb8888", GUD_XRGB8888, GLINT_RGB888},
    {"grey8", GUD_R8, GLINT_GREY8},
    {"mono", GUD_R1, GLINT_MONO},
};

static uint32_t noise(uint32_t seed, uint32_t i)
{
    const uint32_t x = (seed * 2654435761u + i) * 2246822519u;
    return (x ^ x >> 15) * 3266489917u >> 16;
}

/* Pixels that compress somewhat. */
static void draw(struct frame *frame, uint8_t *pixels, uint32_t seed)
{
    const size_t size = frame->line_bytes * frame->height;
    for (size_t i = 0; i < size; i++)
        pixels[i] = (uint8_t)(i / 64 % 3 ? seed : noise(seed, (uint32_t)i));
    frame->pixels = pixels;
}

/* The picture's pixel, from the display's memory and from the frame: four bytes b, g, r, x; or what there is. */
static uint32_t of_display(enum gud_format format, uint32_t x, uint32_t y)
{
    const uint8_t *row = &display.seen->picture[y * gud_line_bytes(format, display.seen->width)];
    switch (format) {
    case GUD_R1:
        return row[x / 8] >> (7 - x % 8) & 1;
    case GUD_R8:
        return row[x];
    case GUD_RGB565:
        return row[2 * x] | (uint32_t)row[2 * x + 1] << 8;
    case GUD_RGB888:
        return row[3 * x] | (uint32_t)row[3 * x + 1] << 8 | (uint32_t)row[3 * x + 2] << 16;
    default:
        return row[4 * x] | (uint32_t)row[4 * x + 1] << 8 | (uint32_t)row[4 * x + 2] << 16;
    }
}

static uint32_t of_frame(const struct frame *frame, uint32_t x, uint32_t y)
{
    const uint8_t *row = frame->pixels + y * frame->line_bytes;
    switch (frame->format) {
    case GLINT_MONO:
        return row[x / 8] >> (7 - x % 8) & 1;
    case GLINT_GREY8:
        return row[x];
    case GLINT_RGB888:
        return row[3 * x + 2] | (uint32_t)row[3 * x + 1] << 8 | (uint32_t)row[3 * x] << 16;
    default:
        return row[2 * x] | (uint32_t)row[2 * x + 1] << 8;
    }
}

static void assert_shows(enum gud_format format, const struct frame *frame)
{
    assert_int_equal(display.seen->format, format);
    assert_int_equal(display.seen->protocol_errors, 0);
    for (uint32_t y = 0; y < frame->height; y++)
        for (uint32_t x = 0; x < frame->width; x++)
            if (of_display(format, x, y) != of_frame(frame, x, y))
                fail_msg("pixel %u, %u is %x, not %x", x, y, of_display(format, x, y), of_frame(frame, x, y));
}

/* ---- the sink ---- */

static void set_options(const char *words)
{
    char copy[256], *argv[16] = {(char *)"test"};
    int argc = 1;
    snprintf(copy, sizeof copy, "%s", words);
    for (char *word = strtok(copy, " "); word; word = strtok(NULL, " "))
        argv[argc++] = word;
    assert_int_equal(argp_parse(&usb_options_argp, argc, argv, 0, NULL, NULL), 0);
}

enum { ROOM = 4 << 20 };

static struct piece make_piece(const struct sink *sink, const struct frame *frame, struct glint_box box, bool lz4,
                               uint8_t *room)
{
    struct piece piece = {.box = box, .data = room, .length = sink_usb.pixels.box_bytes(sink, &box)};
    piece.bytes = piece.length;
    if (!lz4) {
        sink_usb.pixels.pack(sink, frame, &box, room);
        return piece;
    }
    uint8_t *raw = malloc(piece.length);
    sink_usb.pixels.pack(sink, frame, &box, raw);
    piece.bytes =
        (size_t)LZ4_compress_HC((const char *)raw, (char *)room, (int)piece.length, ROOM, LZ4HC_CLEVEL_DEFAULT);
    free(raw);
    piece.lz4 = true;
    assert_true(piece.bytes > 0);
    return piece;
}

/* A whole frame, then rectangles of another at odd places; raw or compressed. */
static void send_two_frames(struct sink *sink, struct frame *frame, uint8_t *pixels, bool lz4)
{
    static uint8_t rooms[4][ROOM];
    const uint16_t w = sink->width, h = sink->height, a = sink->align_x;
    draw(frame, pixels, 1);
    struct piece pieces[4] = {make_piece(sink, frame, (struct glint_box){0, 0, w, h}, lz4, rooms[0])};
    assert_int_equal(sink_usb.pixels.send(sink, frame, pieces, 1), SINK_SENT);
    /* Only what the boxes hold differs between the two. */
    const struct glint_box boxes[4] = {{0, 0, a, 1},
                                       {(uint16_t)(w / a * a - a), (uint16_t)(h - 1), (uint16_t)(w - w / a * a + a), 1},
                                       {(uint16_t)(a * 3), 5, (uint16_t)(a * 2), 11},
                                       {0, 17, w, 3}};
    uint8_t *second = malloc(frame->line_bytes * h);
    struct frame other = *frame;
    draw(&other, second, 77);
    for (unsigned i = 0; i < 4; i++)
        for (uint16_t y = boxes[i].y; y < boxes[i].y + boxes[i].h; y++)
            for (size_t x = boxes[i].x; x < (size_t)boxes[i].x + boxes[i].w; x++) {
                const size_t bytes = format_line_bytes(frame->format, 1), at = y * frame->line_bytes;
                if (frame->format == GLINT_MONO)
                    pixels[at + x / 8] = second[at + x / 8];
                else
                    memcpy(&pixels[at + x * bytes], &second[at + x * bytes], bytes);
            }
    free(second);
    static uint8_t more[4][ROOM];
    for (unsigned i = 0; i < 4; i++)
        pieces[i] = make_piece(sink, frame, boxes[i], lz4, more[i]);
    assert_int_equal(sink_usb.pixels.send(sink, frame, pieces, 4), SINK_SENT);
}

static void check_form(const struct picture_form *form, uint16_t width, uint16_t height, bool lz4)
{
    struct usb_display_config config;
    usb_display_defaults(&config, width, height);
    config.formats[0] = GUD_XRGB1111; /* one that is not ours */
    config.formats[1] = (uint8_t)form->offered;
    config.formats_bytes = 2;
    usb_display_be(&display, &config);
    set_options("--vid-pid 1209:0001");
    struct sink *sink = sink_usb.pixels.open(&(struct sink_wish){.format = -1});
    assert_non_null(sink);
    assert_int_equal(sink->width, width);
    assert_int_equal(sink->height, height);
    assert_int_equal(sink->format, form->pixels);
    assert_int_equal(sink->lz4, true);
    assert_soon(display.seen->controller && display.seen->display);
    struct frame frame = {width, height, form->pixels, format_line_bytes(form->pixels, width), NULL};
    uint8_t *pixels = malloc(frame.line_bytes * height);
    send_two_frames(sink, &frame, pixels, lz4);
    sink_usb.pixels.close(sink);
    assert_soon(display.seen->rectangles == 5);
    assert_shows(form->offered, &frame);
    assert_int_equal(display.seen->compressed, lz4 ? 5 : 0);
    assert_soon(!display.seen->controller && !display.seen->display);
    free(pixels);
}

static void every_format_arrives_bit_by_bit(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
        check_form(&forms[i], 67, 41, false);
}

static void every_format_arrives_bit_by_bit_through_lz4(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
        check_form(&forms[i], 67, 41, true);
}

/* Lengths that are multiples of a packet, with more data than is in flight at once. */
static void a_large_picture_arrives_bit_by_bit(void **state)
{
    (void)state;
    check_form(&forms[0], 1024, 768, false);
    check_form(&forms[2], 800, 480, true);
}

static void requests_come_in_the_kernel_drivers_order(void **state)
{
    (void)state;
    struct usb_display_config config;
    usb_display_defaults(&config, 64, 32);
    usb_display_be(&display, &config);
    set_options("--vid-pid 1209:0001");
    struct sink *sink = sink_usb.pixels.open(&(struct sink_wish){.format = -1});
    struct frame frame = {64, 32, sink->format, 128, NULL};
    uint8_t pixels[64 * 32 * 2], room[64 * 32 * 2];
    draw(&frame, pixels, 3);
    const struct piece piece = make_piece(sink, &frame, (struct glint_box){0, 0, 64, 32}, false, room);
    sink_usb.pixels.send(sink, &frame, &piece, 1);
    sink_usb.pixels.close(sink);
    static const uint8_t wanted[] = {
        GUD_GET_DESCRIPTOR, /* which is it? */
        GUD_GET_DESCRIPTOR,       GUD_GET_FORMATS,         GUD_GET_CONNECTORS,  GUD_SET_CONNECTOR_FORCE_DETECT,
        GUD_GET_CONNECTOR_STATUS, GUD_GET_CONNECTOR_MODES, GUD_SET_STATE_CHECK, GUD_SET_CONTROLLER_ENABLE,
        GUD_SET_STATE_COMMIT,     GUD_SET_DISPLAY_ENABLE,  GUD_SET_BUFFER,      GUD_SET_DISPLAY_ENABLE,
        GUD_SET_CONTROLLER_ENABLE};
    assert_soon(display.seen->request_count == sizeof wanted);
    assert_memory_equal(display.seen->requests, wanted, sizeof wanted);
}

/* ---- the command ---- */

/* The last frame of `glint stream` on the display is that of --to raw; `more` are its options. */
static void check_command(const struct usb_display_config *config, const char *more, size_t least_rectangles)
{
    char command[400];
    usb_display_be(&display, config);
    snprintf(command, sizeof command, "$GLINT stream watchface --to usb --vid-pid 1209:0001 --frames 4 --fps 8 %s",
             more);
    assert_ends(command, 0, "");
    snprintf(command, sizeof command,
             "$GLINT stream watchface --to raw --size %ux%u --frames 4 --fps 8 | tail -c %zu >frame.raw",
             display.seen->width, display.seen->height, 2 * (size_t)display.seen->width * display.seen->height);
    assert_ends(command, 0, "");
    struct frame frame = {display.seen->width, display.seen->height, GLINT_RGB565, 2 * (size_t)display.seen->width,
                          NULL};
    const size_t size = frame.line_bytes * frame.height;
    uint8_t *pixels = malloc(size);
    FILE *file = fopen("frame.raw", "r");
    assert_non_null(file);
    assert_int_equal(fread(pixels, 1, size, file), size);
    fclose(file);
    frame.pixels = pixels;
    assert_shows(GUD_RGB565, &frame);
    assert_true(display.seen->rectangles >= least_rectangles);
    assert_soon(!display.seen->display);
    free(pixels);
}

static void a_stream_shows_its_last_frame(void **state)
{
    (void)state;
    struct usb_display_config config;
    usb_display_defaults(&config, 240, 135);
    check_command(&config, "", 4);
    usb_display_unplug(&display);
    config.ids.full_speed = true;
    check_command(&config, "", 4);
    usb_display_unplug(&display);
}

static void a_small_max_buffer_splits_rectangles(void **state)
{
    (void)state;
    struct usb_display_config config;
    usb_display_defaults(&config, 240, 135);
    struct gud_descriptor descriptor;
    gud_descriptor_unpack(&descriptor, config.descriptor);
    descriptor.max_buffer = 240 * 2 * 7 + 11;
    gud_descriptor_pack(config.descriptor, &descriptor);
    check_command(&config, "", 20 + 3);
    descriptor.compression = 0;
    gud_descriptor_pack(config.descriptor, &descriptor);
    check_command(&config, "", 20 + 3);
}

static void status_is_read_where_the_display_asks_for_it(void **state)
{
    (void)state;
    struct usb_display_config config;
    usb_display_defaults(&config, 64, 32);
    struct gud_descriptor descriptor;
    gud_descriptor_unpack(&descriptor, config.descriptor);
    descriptor.flags = GUD_FLAG_STATUS;
    gud_descriptor_pack(config.descriptor, &descriptor);
    check_command(&config, "", 4);
}

static void whole_frames_come_unannounced_where_the_display_asks_for_it(void **state)
{
    (void)state;
    struct usb_display_config config;
    usb_display_defaults(&config, 64, 32);
    struct gud_descriptor descriptor;
    gud_descriptor_unpack(&descriptor, config.descriptor);
    descriptor.flags = GUD_FLAG_FULL_UPDATE;
    gud_descriptor_pack(config.descriptor, &descriptor);
    check_command(&config, "", 4);
    assert_int_equal(display.seen->compressed, 0);
    for (size_t i = 0; i < display.seen->request_count; i++)
        assert_int_not_equal(display.seen->requests[i], GUD_SET_BUFFER);
}

static void size_and_format_choose_among_what_is_offered(void **state)
{
    (void)state;
    struct usb_display_config config;
    usb_display_defaults(&config, 64, 32);
    struct gud_mode mode;
    gud_mode_unpack(&mode, config.modes);
    struct gud_descriptor descriptor;
    gud_descriptor_unpack(&descriptor, config.descriptor);
    descriptor.max_width = 128;
    gud_descriptor_pack(config.descriptor, &descriptor);
    mode.hdisplay = 128;
    mode.flags = 0;
    gud_mode_pack(config.modes + GUD_MODE_BYTES, &mode);
    config.modes_bytes = 2 * GUD_MODE_BYTES;
    usb_display_be(&display, &config);
    assert_ends("$GLINT stream sphere --to usb --vid-pid 1209:0001 --frames 1", 0, "");
    assert_int_equal(display.seen->width, 64);
    assert_int_equal(display.seen->format, GUD_RGB565);
    assert_ends("$GLINT stream sphere --to usb --vid-pid 1209:0001 --frames 1 --size 128x32 --format grey8", 0, "");
    assert_int_equal(display.seen->width, 128);
    assert_int_equal(display.seen->format, GUD_R8);
    assert_ends("$GLINT stream sphere --to usb --vid-pid 1209:0001 --frames 1 --format rgb888", 0, "");
    assert_int_equal(display.seen->format, GUD_RGB888);
    assert_fails("$GLINT stream sphere --to usb --vid-pid 1209:0001 --size 96x32",
                 "it has no mode 96x32; it has 64x32, 128x32");
    assert_fails("$GLINT stream sphere --to usb --vid-pid 1209:0001 --format rgb565-swapped",
                 "it offers rgb565, rgb888");
}

static int clean(void **state)
{
    usb_displays_unplug(state);
    return scratch_remove(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_format_arrives_bit_by_bit),
        cmocka_unit_test(every_format_arrives_bit_by_bit_through_lz4),
        cmocka_unit_test(a_large_picture_arrives_bit_by_bit),
        cmocka_unit_test(requests_come_in_the_kernel_drivers_order),
        cmocka_unit_test(a_stream_shows_its_last_frame),
        cmocka_unit_test(a_small_max_buffer_splits_rectangles),
        cmocka_unit_test(status_is_read_where_the_display_asks_for_it),
        cmocka_unit_test(whole_frames_come_unannounced_where_the_display_asks_for_it),
        cmocka_unit_test(size_and_format_choose_among_what_is_offered),
    };
    return cmocka_run_group_tests_name("usb stream", tests, scratch_make, clean);
}
