/* SPDX-License-Identifier: MIT */
/* spidev to the kernel's own bit-banging SPI controller, whose lines are simulated: guest --spi. */
#include "unit.h"

#include "known.h"
#include "soon.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/spi/spidev.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { TRANSFER_MAX = 4096 }; /* of spidev's buffer */

static void write_spidev(const uint8_t *bytes, size_t count)
{
    const int fd = open("/dev/spidev0.0", O_RDWR);
    if (fd < 0)
        fail_msg("/dev/spidev0.0: %s", strerror(errno));
    assert_int_equal(ioctl(fd, SPI_IOC_WR_MODE, &(uint8_t){SPI_MODE_0}), 0);
    for (size_t i = 0; i < count; i += TRANSFER_MAX) {
        const size_t part = count - i < TRANSFER_MAX ? count - i : TRANSFER_MAX;
        assert_int_equal(write(fd, bytes + i, part), part);
    }
    close(fd);
}

static void what_spidev_is_given_is_on_the_lines(void **state)
{
    (void)state;
    struct chip chip;
    struct capture capture;
    size_t count;
    bus_byte *wanted = known_bytes(64, 48, &count), *found = calloc(count, sizeof *found);
    uint8_t *bytes = malloc(count);
    for (size_t i = 0; i < count; i++)
        bytes[i] = (uint8_t)wanted[i];
    chip_find(&chip, "lab-spi", SPI_NAMES, SPI_LINES);
    capture_start(&capture, &chip, 16);
    write_spidev(bytes, count);
    capture_stop(&capture);
    assert_int_equal(decode_spi(&capture, found, count), count);
    for (size_t i = 0; i < count; i++)
        assert_int_equal(found[i], bytes[i]);
    capture_free(&capture);
    free(bytes);
    free(found);
    free(wanted);
}

/* The environment variable GLINT is the command. */
static void gets_the_frame_that_was_drawn(const char *options, bool rests_high)
{
    enum { WIDTH = 64, HEIGHT = 48, ROOM = 1 << 16 };
    struct chip chip;
    struct capture capture;
    struct screen screen;
    bus_byte *found = calloc(ROOM, sizeof *found);
    chip_find(&chip, "lab-spi", SPI_NAMES, SPI_LINES);
    capture_start(&capture, &chip, 60);
    assert_int_equal(run("$GLINT stream coin --frames 1 --size %dx%d --offset 0,0 --to spi --lines dc=DC,reset=RST %s",
                         WIDTH, HEIGHT, options),
                     0);
    capture_stop(&capture);
    assert_true(clock_at_rest(&capture) == rests_high);
    const size_t count = decode_spi(&capture, found, ROOM);
    screen_init(&screen, WIDTH, HEIGHT);
    screen_show(&screen, found, count);
    assert_true(screen.awake && !screen.on);
    size_t size;
    char *frame = run_for_output(&size, "$GLINT stream coin --frames 1 --size %dx%d --to raw --format rgb565-swapped",
                                 WIDTH, HEIGHT);
    assert_int_equal(size, WIDTH * HEIGHT * 2);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        assert_int_equal(screen.pixels[i], (uint8_t)frame[2 * i] << 8 | (uint8_t)frame[2 * i + 1]);
    free(frame);
    free(found);
    screen_free(&screen);
    capture_free(&capture);
}

static void a_panel_on_spidev_gets_the_frame_that_was_drawn(void **state)
{
    (void)state;
    gets_the_frame_that_was_drawn("", false);
}

static void a_panel_on_spidev_gets_it_in_mode_3_by_a_clock_that_rests_high(void **state)
{
    (void)state;
    gets_the_frame_that_was_drawn("--spi-mode 3", true);
}

#define DRIVER "/sys/bus/spi/drivers/spidev/"

static void a_device_that_is_taken_away_ends_the_stream_with_one_line(void **state)
{
    (void)state;
    struct process process;
    process_start(&process, "$GLINT stream coin --size 16x8 --offset 0,0 --to spi --lines dc=DC,reset=RST");
    assert_soon(run("grep -q '|glint' /sys/kernel/debug/gpio") == 0);
    assert_int_equal(run("echo spi0.0 >" DRIVER "unbind"), 0);
    assert_int_equal(process_end(&process, 0), 1);
    assert_int_equal(run("echo spi0.0 >" DRIVER "bind"), 0);
    size_t size;
    char *text = run_for_output(&size, "cat %s", process.output);
    assert_string_equal(text, "glint: /dev/spidev0.0: it was removed while in use; plug it in or load its driver, then "
                              "start again\n");
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(what_spidev_is_given_is_on_the_lines, lab_clean),
        cmocka_unit_test_teardown(a_panel_on_spidev_gets_the_frame_that_was_drawn, lab_clean),
        cmocka_unit_test_teardown(a_panel_on_spidev_gets_it_in_mode_3_by_a_clock_that_rests_high, lab_clean),
        cmocka_unit_test_teardown(a_device_that_is_taken_away_ends_the_stream_with_one_line, lab_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
