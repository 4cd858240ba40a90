/* SPDX-License-Identifier: MIT */
/* The lab's capture and decoders, by a program that sends known bytes; sigrok's decoders agree. The environment variable
 * BITBANG is that program. */
#include "unit.h"

#include "known.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { WIDTH = 20, HEIGHT = 12, LARGE_WIDTH = 320, LARGE_HEIGHT = 240 };

struct bus {
    const char *name;
    const char *const *lines;
    unsigned count, events_per_byte;
    size_t (*decode)(const struct capture *capture, bus_byte *bytes, size_t room);
};
static const struct bus SPI = {"spi", SPI_NAMES, SPI_LINES, 16 * SPI_LINES, decode_spi},
                        I80 = {"i80", I80_NAMES, I80_LINES, 2 * I80_LINES, decode_i80};

/* One of the program's runs. */
struct sent {
    struct chip chip;
    struct capture capture;
    bus_byte *wanted;
    size_t count;
};

static void send_known(struct sent *sent, const struct bus *bus, unsigned width, unsigned height)
{
    sent->wanted = known_bytes(width, height, &sent->count);
    chip_create(&sent->chip, "panel", bus->lines, bus->count);
    const size_t event_bytes = 32, margin = 1 << 20;
    capture_start(&sent->capture, &sent->chip,
                  (unsigned)((sent->count * bus->events_per_byte * event_bytes + margin) >> 20) + 1);
    assert_int_equal(run("$BITBANG %s %s %u %u", bus->name, sent->chip.path, width, height), 0);
    capture_stop(&sent->capture);
    chip_remove(&sent->chip);
}

static void forget(struct sent *sent)
{
    capture_free(&sent->capture);
    free(sent->wanted);
}

static void our_decoder_finds_what_was_sent(const struct bus *bus, unsigned width, unsigned height)
{
    struct sent sent;
    send_known(&sent, bus, width, height);
    bus_byte *found = calloc(sent.count + 1, sizeof *found);
    assert_int_equal(bus->decode(&sent.capture, found, sent.count + 1), sent.count);
    assert_memory_equal(found, sent.wanted, sent.count * sizeof *found);

    struct screen screen;
    screen_init(&screen, width, height);
    screen_show(&screen, found, sent.count);
    assert_true(screen.awake && screen.on);
    assert_int_equal(screen.madctl, 0x60);
    assert_int_equal(screen.colmod, 0x55);
    assert_int_equal(screen.writes, 1);
    assert_int_equal(screen.written, (size_t)width * height);
    for (size_t i = 0; i < (size_t)width * height; i++)
        assert_int_equal(screen.pixels[i], known_pixel(i));
    screen_free(&screen);
    free(found);
    forget(&sent);
}

static void bit_banged_spi_is_captured_and_decoded_byte_by_byte(void **state)
{
    (void)state;
    our_decoder_finds_what_was_sent(&SPI, WIDTH, HEIGHT);
}

static void a_bit_banged_8080_bus_is_captured_and_decoded_byte_by_byte(void **state)
{
    (void)state;
    our_decoder_finds_what_was_sent(&I80, WIDTH, HEIGHT);
}

static void a_frame_of_320x240_on_the_8080_bus_is_captured_without_a_loss(void **state)
{
    (void)state;
    our_decoder_finds_what_was_sent(&I80, LARGE_WIDTH, LARGE_HEIGHT);
}

static void sigrok_decodes_the_same_bytes_from_spi(void **state)
{
    (void)state;
    struct sent sent;
    send_known(&sent, &SPI, WIDTH, HEIGHT);
    sigrok_agrees_on_spi(&sent.capture, sent.wanted, sent.count);
    forget(&sent);
}

static void sigrok_reads_the_commands_of_a_display_from_spi(void **state)
{
    (void)state;
    struct sent sent;
    send_known(&sent, &SPI, WIDTH, HEIGHT);
    size_t size;
    char *found = sigrok(&sent.capture, "SCK", &size, "-P st7735:clk=SCK:mosi=MOSI:cs=CS:dc=DC -A st7735=description");
    static const char *const WANTED[] = {"SLPOUT", "MADCTL", "COLMOD", "CASET", "RASET", "DISPON", "RAMWR"};
    const char *at = found;
    for (size_t i = 0; i < sizeof WANTED / sizeof *WANTED; i++) {
        const char *next = strstr(at, WANTED[i]);
        if (!next)
            fail_msg("no %s in its place in\n%s", WANTED[i], found);
        at = next;
    }
    free(found);
    forget(&sent);
}

static void sigrok_decodes_the_same_bytes_from_the_8080_bus(void **state)
{
    (void)state;
    struct sent sent;
    send_known(&sent, &I80, WIDTH, HEIGHT);
    sigrok_agrees_on_i80(&sent.capture, sent.wanted, sent.count);
    forget(&sent);
}

static void a_capture_that_lost_something_is_noticed(void **state)
{
    (void)state;
    struct chip chip;
    struct capture capture;
    chip_create(&chip, "panel", I80.lines, I80.count);
    capture_start(&capture, &chip, 1);
    assert_int_equal(run("$BITBANG i80 %s %d %d", chip.path, 100, 100), 0);
    capture_stop_lossy(&capture);
    assert_true(capture.lost > 0);
    capture_free(&capture);
    chip_remove(&chip);
}

static void a_chip_that_was_removed_is_gone_and_can_be_made_again(void **state)
{
    (void)state;
    struct chip chip;
    for (int i = 0; i < 2; i++) {
        chip_create(&chip, "panel", SPI.lines, SPI.count);
        assert_int_equal(access(chip.path, F_OK), 0);
        chip_remove(&chip);
        assert_int_equal(access(chip.path, F_OK), -1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(bit_banged_spi_is_captured_and_decoded_byte_by_byte, lab_clean),
        cmocka_unit_test_teardown(a_bit_banged_8080_bus_is_captured_and_decoded_byte_by_byte, lab_clean),
        cmocka_unit_test_teardown(a_frame_of_320x240_on_the_8080_bus_is_captured_without_a_loss, lab_clean),
        cmocka_unit_test_teardown(sigrok_decodes_the_same_bytes_from_spi, lab_clean),
        cmocka_unit_test_teardown(sigrok_reads_the_commands_of_a_display_from_spi, lab_clean),
        cmocka_unit_test_teardown(sigrok_decodes_the_same_bytes_from_the_8080_bus, lab_clean),
        cmocka_unit_test_teardown(a_capture_that_lost_something_is_noticed, lab_clean),
        cmocka_unit_test_teardown(a_chip_that_was_removed_is_gone_and_can_be_made_again, lab_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
