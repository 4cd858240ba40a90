/* SPDX-License-Identifier: MIT */
/* glint stream --to gpio where something goes wrong: what users read, and how the panel is left. In the environment: GLINT, the
 * command, by either libgpiod. */
#include "unit.h"

#include "hour.h"
#include "lab.h"
#include "soon.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char *const SPI[] = {"SCK", "MOSI", "CS", "DC", "RST", "LIGHT"};
enum { SPI_COUNT = 6, ROOM = 1 << 16, SLEEP_IN = 0x10, DISPLAY_OFF = 0x28 };
#define OPTIONS "--to gpio --bus spi --lines sck=SCK,mosi=MOSI,cs=CS,dc=DC,reset=RST,backlight=LIGHT "

static bus_byte bytes[ROOM];

static bool level_of(const struct capture *capture, const char *name)
{
    const unsigned line = chip_line(capture->chip, name);
    bool high = false;
    for (size_t i = 0; i < capture->count; i++)
        if ((capture->sets[i] & CAPTURE_LINE) == line)
            high = capture->sets[i] & CAPTURE_HIGH;
    return high;
}

/* The process's last words, which are one line, and its exit status. */
static void assert_ended(struct process *process, int signal, int status, const char *words)
{
    assert_int_equal(process_end(process, signal), status);
    size_t size;
    char *text = run_for_output(&size, "cat %s", process->output);
    if (!strstr(text, words) || (*words && strchr(text, '\n') != text + size - 1) || (!*words && size))
        fail_msg("'%s' is not one line with '%s'", text, words);
    free(text);
}

static void assert_refused(const char *options, const char *words)
{
    struct process process;
    process_start(&process, "$GLINT stream coin --size 135x240 --frames 1 %s", options);
    assert_ended(&process, 0, 1, words);
}

/* Until the command has its lines. */
static void wait_for_lines(void)
{
    assert_soon(run("grep -q '|glint' /sys/kernel/debug/gpio") == 0);
}

static void lines_that_are_in_use_or_not_there_are_named(void **state)
{
    (void)state;
    struct chip chip, other;
    struct process process;
    char words[200];
    chip_create(&chip, "panel", SPI, SPI_COUNT);
    process_start(&process, "$GLINT stream coin --size 135x240 %s", OPTIONS);
    wait_for_lines();
    snprintf(words, sizeof words, "sck=SCK: line %s:0 SCK is in use by 'glint'", chip.name);
    assert_refused(OPTIONS, words);
    assert_ended(&process, SIGINT, 130, "");

    assert_refused("--to gpio --lines sck=SCK,mosi=MOSO,dc=DC",
                   "mosi=MOSO: no GPIO line has the name 'MOSO'; did you mean MOSI?");
    snprintf(words, sizeof words, "dc=panel:6: %s has the lines 0 to 5", chip.name);
    assert_refused("--to gpio --lines sck=SCK,mosi=MOSI,dc=panel:6", words);
    assert_refused("--to gpio --chip gpiochip77 --lines sck=0,mosi=1,dc=2",
                   "no GPIO chip is named 'gpiochip77'; choose from ");
    assert_refused("--to gpio --chip panel --lines sck=0,mosi=1,dc=1", "mosi and dc are the same line");
    chip_create(&other, "other", SPI, SPI_COUNT);
    assert_refused(OPTIONS, "sck=SCK: 2 lines have that name; choose one: ");
    chip_remove(&other);
    chip_remove(&chip);
}

/* As Raspberry Pi OS makes one on the Pi 5, so that the chip's old name goes on. */
static void a_link_to_a_chip_is_no_second_chip_with_the_same_lines(void **state)
{
    (void)state;
    static const char *const ways[] = {OPTIONS, "--to gpio --chip gpiochip99 --lines sck=SCK,mosi=1,dc=DC ",
                                       "--to gpio --lines sck=gpiochip99:SCK,mosi=gpiochip99:1,dc=DC "};
    struct chip chip;
    struct process process;
    chip_create(&chip, "panel", SPI, SPI_COUNT);
    assert_int_equal(run("ln -s %s /dev/gpiochip99", chip.name), 0);
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        process_start(&process, "$GLINT stream coin --size 6x4 --offset 0,0 --frames 1 %s", ways[i]);
        assert_ended(&process, 0, 0, "");
    }
    assert_int_equal(run("test $($GLINT list | grep -c '  panel$') = 1"), 0);
    assert_int_equal(run("rm /dev/gpiochip99"), 0);
    chip_remove(&chip);
}

static void a_chip_that_may_not_be_opened_is_told_with_what_to_do(void **state)
{
    (void)state;
    struct chip chip;
    chip_create(&chip, "panel", SPI, SPI_COUNT);
    assert_int_equal(run("chmod 600 %s", chip.path), 0);
    struct process process;
    process_start(&process, "setpriv --reuid 65534 --regid 65534 --clear-groups $GLINT stream coin --size 135x240 %s",
                  OPTIONS);
    assert_ended(&process, 0, 1, "permission denied; ");
    chip_remove(&chip);
}

static void a_chip_that_is_removed_ends_the_stream_with_one_line(void **state)
{
    (void)state;
    struct chip chip;
    struct process process;
    chip_create(&chip, "panel", SPI, SPI_COUNT);
    process_start(&process, "$GLINT stream coin --size 135x240 %s", OPTIONS);
    wait_for_lines();
    chip_remove(&chip);
    char words[100];
    snprintf(words, sizeof words, "%s: it was removed while in use", chip.name);
    assert_ended(&process, 0, 1, words);
}

static void whenever_it_is_interrupted_the_panel_is_left_dark_and_asleep(void **state)
{
    (void)state;
    static const long delays_ms[] = {50, 150, 400, 700, 1100, 900, 1000};
    static const int signals[] = {SIGINT, SIGTERM, SIGINT, SIGTERM, SIGQUIT, SIGUSR1, SIGALRM};
    for (size_t i = 0; i < sizeof delays_ms / sizeof *delays_ms; i++) {
        struct chip chip;
        struct capture capture;
        struct process process;
        chip_create(&chip, "panel", SPI, SPI_COUNT);
        capture_start(&capture, &chip, 60);
        process_start(&process, "$GLINT stream coin --size 40x30 --offset 0,0 %s", OPTIONS);
        nanosleep(&(struct timespec){delays_ms[i] / 1000, delays_ms[i] % 1000 * 1000000}, NULL);
        assert_ended(&process, signals[i], 128 + signals[i], "");
        capture_stop(&capture);
        assert_false(level_of(&capture, "LIGHT"));
        const size_t count = decode_spi(&capture, bytes, ROOM); /* which fails for a part of a byte */
        if (count) {
            assert_int_equal(bytes[count - 2], DISPLAY_OFF);
            assert_int_equal(bytes[count - 1], SLEEP_IN);
        }
        capture_free(&capture);
        chip_remove(&chip);
    }
}

static void the_list_tells_the_lines_and_who_uses_them(void **state)
{
    (void)state;
    struct chip chip;
    struct process process;
    size_t size;
    char words[200];
    chip_create(&chip, "panel", SPI, SPI_COUNT);
    process_start(&process, "$GLINT stream coin --size 135x240 %s", OPTIONS);
    wait_for_lines();
    char *text = run_for_output(&size, "$GLINT list");
    snprintf(words, sizeof words, "%s  panel\n", chip.name);
    assert_non_null(strstr(text, words));
    assert_non_null(strstr(text, "  0  SCK  in use by glint\n"));
    free(text);
    assert_ended(&process, SIGINT, 130, "");
    chip_remove(&chip);
}

static void an_hours_stream_keeps_its_memory_and_its_descriptors(void **state)
{
    (void)state;
    struct chip chip;
    struct process process;
    chip_create(&chip, "panel", SPI, SPI_COUNT);
    process_start(&process, "$GLINT stream coin --size 6x4 --offset 0,0 --fps .25 --period 7.3 --json %s", OPTIONS);
    keeps_what_it_has_for_an_hour(process.pid);
    assert_int_equal(process_end(&process, SIGINT), 130);
    size_t size;
    char *text = run_for_output(&size, "cat %s", process.output);
    const char *frames = strstr(text, "\"frames\":");
    assert_non_null(frames);
    assert_true(atoi(frames + strlen("\"frames\":")) > 890);
    free(text);
    chip_remove(&chip);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(lines_that_are_in_use_or_not_there_are_named, lab_clean),
        cmocka_unit_test_teardown(a_link_to_a_chip_is_no_second_chip_with_the_same_lines, lab_clean),
        cmocka_unit_test_teardown(a_chip_that_may_not_be_opened_is_told_with_what_to_do, lab_clean),
        cmocka_unit_test_teardown(a_chip_that_is_removed_ends_the_stream_with_one_line, lab_clean),
        cmocka_unit_test_teardown(whenever_it_is_interrupted_the_panel_is_left_dark_and_asleep, lab_clean),
        cmocka_unit_test_teardown(the_list_tells_the_lines_and_who_uses_them, lab_clean),
        cmocka_unit_test_teardown(an_hours_stream_keeps_its_memory_and_its_descriptors, lab_clean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
