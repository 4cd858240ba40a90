/* SPDX-License-Identifier: MIT
 * GPIO lines that cannot be had or go away: what the user reads. */
#include <stdio.h>

#if GLINT_WITH_GPIO == 1
#include "stand_in_gpiod.h"

/* ---- faults, each in a process of its own ---- */

static struct gpio_options child_options;
static void open_and_send(void)
{
    struct sink *sink = opened(&child_options);
    for (int i = 0; i < 3; i++)
        send_two_pieces(sink);
    gpio_display_close(sink);
}

/* Exit 1, and one line. */
static void assert_told(const struct gpio_options *options, const char *wanted)
{
    int ends[2];
    child_options = *options;
    assert_int_equal(pipe(ends), 0);
    fflush(NULL);
    const pid_t pid = fork();
    assert_true(pid >= 0);
    if (pid == 0) {
        dup2(ends[1], STDERR_FILENO);
        open_and_send();
        _exit(0);
    }
    close(ends[1]);
    char text[1024];
    size_t length = 0;
    for (ssize_t got; (got = read(ends[0], text + length, sizeof text - 1 - length)) > 0;)
        length += (size_t)got;
    text[length] = '\0';
    close(ends[0]);
    int status;
    assert_int_equal(waitpid(pid, &status, 0), pid);
    char line[512];
    snprintf(line, sizeof line, "glint: %s\n", wanted);
    assert_string_equal(text, line);
    assert_int_equal(WEXITSTATUS(status), 1);
}

static void a_line_in_use_is_told_with_its_user(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.lines[ROLE_DC].text = "aside:TAKEN";
    assert_told(&options,
                "--lines: dc=aside:TAKEN: line gpiochip10:1 TAKEN is in use by 'a camera'; stop that, or choose "
                "another line (`glint list` shows them)");
}

static void a_line_that_is_not_there_is_told_with_the_nearest(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.lines[ROLE_SCK].text = "SKC";
    assert_told(&options,
                "--lines: sck=SKC: no GPIO line has the name 'SKC'; did you mean SCK? (`glint list` shows all)");
    options.lines[ROLE_SCK].text = "GPIO17";
    assert_told(&options,
                "--lines: sck=GPIO17: no GPIO line has the name 'GPIO17'; `glint list` shows all, and lines without "
                "a name are CHIP:OFFSET");
    options.lines[ROLE_SCK].text = "17";
    assert_told(&options, "--lines: sck=17: gpiochip0 has the lines 0 to 16");
    options.lines[ROLE_SCK].text = "99999999999999999999";
    assert_told(&options, "--lines: sck=99999999999999999999: gpiochip0 has the lines 0 to 16");
}

static void a_number_without_a_chip_and_a_name_that_is_there_twice_are_told(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.chip = NULL;
    options.lines[ROLE_SCK].text = "0:11";
    options.lines[ROLE_CS].text = "13";
    assert_told(&options, "--lines: cs=13: no GPIO line has that name; if 13 is an offset, name its chip: "
                          "gpiochip0:13, or --chip");
    options.lines[ROLE_SCK].text = "SCK";
    assert_told(&options, "--lines: sck=SCK: 2 lines have that name; choose one: gpiochip0:11, gpiochip10:0");
}

static void a_chip_that_is_not_there_is_told_with_those_that_are(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.chip = "gpiochip1";
    assert_told(&options,
                "--lines: sck=SCK: no GPIO chip is named 'gpiochip1'; choose from gpiochip0 (main), gpiochip10 "
                "(aside)");
    options.chip = NULL;
    options.lines[ROLE_SCK].text = "gpiochip2:4";
    assert_told(&options, "--lines: sck=gpiochip2:4: no GPIO chip is named 'gpiochip2'; choose from gpiochip0 (main), "
                          "gpiochip10 (aside)");
    no_chips = true;
    assert_told(&options, "--lines: sck=gpiochip2:4: no GPIO chip: this machine has no /dev/gpiochip0");
}

static void the_same_line_for_two_wires_is_told(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.lines[ROLE_BACKLIGHT].text = "gpiochip0:8";
    options.lines[ROLE_BACKLIGHT].origin = "pins.ini:9";
    assert_told(&options, "pins.ini:9: dc and backlight are the same line, gpiochip0:8; each needs its own line");
}

static void a_chip_that_may_not_be_opened_is_told(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    chips[0].refused = EACCES;
    options.chip = "gpiochip0";
    assert_told(&options,
                "--lines: sck=SCK: /dev/gpiochip0: permission denied; give it to a group of yours by a udev rule "
                "(`SUBSYSTEM==\"gpio\", GROUP=\"gpio\", MODE=\"0660\"`) or run as root");
    chips[0].refused = 0;
}

static void each_chip_that_cannot_be_opened_is_told_with_its_own_reason(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.chip = "gpiochip0";
    chips[0].refused = ENODEV;
    assert_told(&options, "--lines: sck=SCK: /dev/gpiochip0 cannot be opened: No such device");
    chips[1].refused = EACCES;
    assert_told(&options, "--lines: sck=SCK: /dev/gpiochip0 cannot be opened: No such device");
    chips[0].refused = chips[1].refused = 0;
}

static void a_chip_that_goes_away_ends_the_stream_with_one_line_whenever_it_does(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_8080);
    static const unsigned long whens[] = {0, 1, 20, 100, 1000, 1500, 2000};
    for (size_t i = 0; i < sizeof whens / sizeof *whens; i++) {
        calls_that_work = whens[i];
        assert_told(&options,
                    "gpiochip0: it was removed while in use; plug it in or load its driver, then start again");
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_line_in_use_is_told_with_its_user),
        cmocka_unit_test(a_line_that_is_not_there_is_told_with_the_nearest),
        cmocka_unit_test(a_number_without_a_chip_and_a_name_that_is_there_twice_are_told),
        cmocka_unit_test(a_chip_that_is_not_there_is_told_with_those_that_are),
        cmocka_unit_test(the_same_line_for_two_wires_is_told),
        cmocka_unit_test(a_chip_that_may_not_be_opened_is_told),
        cmocka_unit_test(each_chip_that_cannot_be_opened_is_told_with_its_own_reason),
        cmocka_unit_test(a_chip_that_goes_away_ends_the_stream_with_one_line_whenever_it_does),
    };
    return cmocka_run_group_tests_name("gpio faults", tests, NULL, NULL);
}
#else
int main(void)
{
    puts("ok 1 - gpio faults # SKIP it is for libgpiod 1");
    return 0;
}
#endif
