/* SPDX-License-Identifier: MIT */
/* glint stream --to gpio: what is on the lines is what a panel needs to show each frame, bit by bit, as our decoder and
 * sigrok's find it. In the environment: GLINT, the command. */
#include "unit.h"

#include "known.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct bus {
    const char *options;
    const char *const *lines;
    unsigned count, sets_per_byte;
    size_t (*decode)(const struct capture *capture, bus_byte *bytes, size_t room);
    void (*sigrok_agrees)(const struct capture *capture, const bus_byte *bytes, size_t count);
};
static const struct bus SPI = {"--bus spi --lines sck=SCK,mosi=MOSI,cs=CS,dc=DC,reset=RST",
                               SPI_NAMES,
                               SPI_LINES,
                               16 * SPI_LINES,
                               decode_spi,
                               sigrok_agrees_on_spi},
                        I80 = {"--bus 8080 --lines "
                               "d0=D0,d1=D1,d2=D2,d3=D3,d4=D4,d5=D5,d6=D6,d7=D7,wr=WR,cs=CS,dc=DC,reset=RST",
                               I80_NAMES,
                               I80_LINES,
                               2 * I80_LINES,
                               decode_i80,
                               sigrok_agrees_on_i80};

/* The light is slow, as every bit that changes takes the guest's kernel two calls. */
#define STREAM "$GLINT stream watchface --period 60 --fps 0 --size %ux%u --frames %u "

/* What a stream of so many frames left on the lines. */
struct stream {
    struct chip chip;
    struct capture capture;
    bus_byte *bytes;
    size_t count;
};

static void stream_frames(struct stream *stream, const struct bus *bus, const char *options, unsigned width,
                          unsigned height, unsigned frames)
{
    const size_t room = frames * (2 * (size_t)width * height + 10000);
    chip_create(&stream->chip, "panel", bus->lines, bus->count);
    const size_t event_bytes = 32;
    capture_start(&stream->capture, &stream->chip, (unsigned)(room * bus->sets_per_byte * event_bytes >> 20) + 1);
    assert_int_equal(run(STREAM "--to gpio --offset 0,0 --chip %s %s %s", width, height, frames, stream->chip.name,
                         bus->options, options),
                     0);
    capture_stop(&stream->capture);
    stream->bytes = malloc(room * sizeof *stream->bytes);
    assert_non_null(stream->bytes);
    stream->count = bus->decode(&stream->capture, stream->bytes, room);
}

static void forget(struct stream *stream)
{
    capture_free(&stream->capture);
    free(stream->bytes);
    chip_remove(&stream->chip);
}

/* The same stream's last frame, as it is rendered. */
static uint16_t *rendered(unsigned width, unsigned height, unsigned frames)
{
    size_t size;
    char *all = run_for_output(&size, STREAM "--to raw --format rgb565", width, height, frames);
    const size_t frame = 2 * (size_t)width * height;
    assert_int_equal(size, frames * frame);
    uint16_t *pixels = malloc(frame);
    assert_non_null(pixels);
    memcpy(pixels, all + (frames - 1) * frame, frame); /* little-endian, as we are */
    free(all);
    return pixels;
}

/* The screen shows the frame of this number, from 1. */
static void shows(const struct screen *screen, unsigned frame)
{
    uint16_t *wanted = rendered(screen->width, screen->height, frame);
    for (size_t i = 0; i < (size_t)screen->width * screen->height; i++)
        if (screen->pixels[i] != wanted[i])
            fail_msg("frame %u at (%zu, %zu) is not %04x but %04x", frame, i % screen->width, i / screen->width,
                     wanted[i], screen->pixels[i]);
    free(wanted);
}

/* The first frame is sent whole, of the second what changed. */
static void the_panel_shows_two_frames(const struct bus *bus, const char *options, unsigned width, unsigned height)
{
    const size_t pixels = (size_t)width * height;
    struct stream stream;
    struct screen screen;
    stream_frames(&stream, bus, options, width, height, 2);
    bus->sigrok_agrees(&stream.capture, stream.bytes, stream.count);

    screen_init(&screen, width, height);
    const size_t first = frame_bytes(stream.bytes, stream.count, pixels);
    screen_show(&screen, stream.bytes, first);
    assert_true(screen.awake);
    assert_int_equal(screen.colmod, 0x55);
    assert_int_equal(screen.written, pixels);
    shows(&screen, 1);
    screen_show(&screen, stream.bytes + first, stream.count - first);
    assert_true(screen.shown);
    assert_true(screen.written > pixels && screen.written < 2 * pixels);
    shows(&screen, 2);
    screen_free(&screen);
    forget(&stream);
}

static void an_st7789_on_bit_banged_spi_shows_what_was_rendered(void **state)
{
    (void)state;
    the_panel_shows_two_frames(&SPI, "--panel st7789", 160, 128);
}

static void the_clock_rests_low_in_mode_0_and_high_in_mode_3(void **state)
{
    (void)state;
    for (unsigned mode = 0; mode <= 3; mode += 3) {
        struct stream stream;
        stream_frames(&stream, &SPI, mode ? "--panel st7789 --spi-mode 3" : "--panel st7789", 40, 30, 1);
        assert_true(clock_at_rest(&stream.capture) == (mode == 3));
        if (mode == 3)
            sigrok_agrees_on_spi_mode_3(&stream.capture, stream.bytes, stream.count);
        assert_true(frame_bytes(stream.bytes, stream.count, 40 * 30) > 2 * 40 * 30);
        forget(&stream);
    }
}

static void an_ili9341_on_the_8080_bus_shows_what_was_rendered(void **state)
{
    (void)state;
    the_panel_shows_two_frames(&I80, "--panel ili9341", 320, 240);
}

static void sigrok_reads_the_panels_commands_in_order(void **state)
{
    (void)state;
    struct stream stream;
    stream_frames(&stream, &SPI, "--panel st7789", 40, 30, 1);
    size_t size;
    char *found =
        sigrok(&stream.capture, "SCK", &size, "-P st7735:clk=SCK:mosi=MOSI:cs=CS:dc=DC -A st7735=description");
    static const char *const WANTED[] = {"SLPOUT", "CASET", "RASET", "RAMWR", "DISPON", "DISPOFF"};
    const char *at = found;
    for (size_t i = 0; i < sizeof WANTED / sizeof *WANTED; i++) {
        const char *next = strstr(at, WANTED[i]);
        if (!next)
            fail_msg("no %s in its place in\n%s", WANTED[i], found);
        at = next;
    }
    free(found);
    forget(&stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(an_st7789_on_bit_banged_spi_shows_what_was_rendered, lab_clean),
        cmocka_unit_test_teardown(the_clock_rests_low_in_mode_0_and_high_in_mode_3, lab_clean),
        cmocka_unit_test_teardown(an_ili9341_on_the_8080_bus_shows_what_was_rendered, lab_clean),
        cmocka_unit_test_teardown(sigrok_reads_the_panels_commands_in_order, lab_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
