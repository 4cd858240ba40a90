/* SPDX-License-Identifier: MIT
 * Panels on GPIO lines, by libgpiod's calls: what the panel shows, and the list. */
#include <stdio.h>

#if GLINT_WITH_GPIO == 1
#include "stand_in_gpiod.h"

static void a_frame_over_spi_lines_is_seen_on_the_panel(void **state)
{
    (void)state;
    const struct gpio_options options = wires(GPIO_BUS_SPI);
    struct sink *sink = opened(&options);
    send_two_pieces(sink);
    send_two_pieces(sink);
    close_and_check(sink);
}

static void a_frame_over_an_8080_bus_is_seen_on_the_panel(void **state)
{
    (void)state;
    const struct gpio_options options = wires(GPIO_BUS_8080);
    struct sink *sink = opened(&options);
    send_two_pieces(sink);
    send_two_pieces(sink);
    close_and_check(sink);
}

static void a_frame_over_the_fewest_wires_is_seen_on_the_panel(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.lines[ROLE_CS].text = options.lines[ROLE_RESET].text = options.lines[ROLE_BACKLIGHT].text = NULL;
    *wire("RST") = *wire("LIGHT") = true;
    struct sink *sink = opened(&options);
    send_two_pieces(sink);
    gpio_display_close(sink);
    assert_false(screen.on || screen.awake);
}

static void lines_may_be_on_several_chips_and_active_low(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.chip = NULL;
    options.lines[ROLE_SCK].text = "0:11";
    options.lines[ROLE_MOSI].text = "/dev/gpiochip0:12";
    options.lines[ROLE_CS].text = "main:CS";
    options.lines[ROLE_DC].text = "FAR-DC";
    options.lines[ROLE_BACKLIGHT].text = "!LIGHT";
    active_low_light = true;
    struct sink *sink = opened(&options);
    send_two_pieces(sink);
    close_and_check(sink);
    assert_true(*wire("LIGHT"));
}

/* As Raspberry Pi OS has gpiochip4 for the Pi 5's gpiochip0. */
static void a_link_to_a_chip_is_no_second_chip_with_the_same_lines(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    is_linked = true;
    options.chip = NULL;
    options.lines[ROLE_SCK].text = "main:SCK";
    struct sink *sink = opened(&options);
    send_two_pieces(sink);
    close_and_check(sink);
    const struct gpio_found found =
        gpio_find(NULL, &(struct gpio_line_wish){.origin = "--lines", .role = "dc", .text = "gpiochip11:DC"});
    assert_string_equal(gpio_chip_name(found.chip), "gpiochip0");
    assert_int_equal(found.offset, 8);
    gpio_chip_close(found.chip);
    json_t *list = gpio_lines_list();
    assert_int_equal(json_array_size(list), CHIPS);
    json_decref(list);
    assert_int_equal(open_chips, 0);
}

static void an_8080_byte_takes_two_calls_and_an_spi_bit_two(void **state)
{
    (void)state;
    static const unsigned a_byte[] = {[GPIO_BUS_SPI] = 16, [GPIO_BUS_8080] = 2};
    for (unsigned kind = 0; kind < 2; kind++) {
        const struct gpio_options options = wires((enum gpio_bus_kind)kind);
        struct sink *sink = opened(&options);
        send_two_pieces(sink);
        const unsigned long calls_before = calls, bytes_before = bytes_seen;
        send_two_pieces(sink);
        const unsigned long bytes = bytes_seen - bytes_before;
        assert_int_equal(bytes, 2 * 11 + WIDTH * HEIGHT * 2 + 2);
        const unsigned long selections = kind == GPIO_BUS_SPI ? 3 * 2 * 3 : 0; /* a command begins with chip select */
        assert_int_equal(calls - calls_before, bytes * a_byte[kind] + selections);
        close_and_check(sink);
    }
}

/* ---- the rest ---- */

static void letters_are_counted_as_people_mistake_them(void **state)
{
    (void)state;
    static const struct {
        const char *a, *b;
        unsigned apart;
    } known[] = {{"", "", 0},          {"GPIO1", "gpio1", 0}, {"GPIO1", "GIPO1", 1}, {"GPIO1", "GPIO11", 1},
                 {"GPIO1", "GPO1", 1}, {"GPIO1", "", 5},      {"SCK", "MOSI", 4},    {"ABCD", "BADC", 2}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        assert_int_equal(letters_apart(known[i].a, known[i].b), known[i].apart);
        assert_int_equal(letters_apart(known[i].b, known[i].a), known[i].apart);
    }
}

static void the_list_has_every_chip_with_its_lines_and_their_users(void **state)
{
    (void)state;
    wires(GPIO_BUS_SPI);
    chips[0].refused = ENODEV;
    json_t *list = gpio_lines_list();
    char *text = json_dumps(list, JSON_COMPACT);
    assert_string_equal(text, "[{\"chip\":\"gpiochip0\",\"error\":\"No such device\"},"
                              "{\"chip\":\"gpiochip10\",\"label\":\"aside\",\"lines\":["
                              "{\"offset\":0,\"name\":\"SCK\",\"used\":false,\"consumer\":null},"
                              "{\"offset\":1,\"name\":\"TAKEN\",\"used\":true,\"consumer\":\"a camera\"},"
                              "{\"offset\":2,\"name\":\"FAR-DC\",\"used\":false,\"consumer\":null}]}]");
    free(text);
    char *printed = NULL;
    size_t size;
    FILE *stream = open_memstream(&printed, &size);
    gpio_lines_print(list, stream);
    fclose(stream);
    assert_string_equal(printed, "gpiochip0: No such device\n"
                                 "gpiochip10  aside\n"
                                 "    0  SCK\n"
                                 "    1  TAKEN  in use by a camera\n"
                                 "    2  FAR-DC\n");
    free(printed);
    json_decref(list);
    chips[0].refused = 0;
    assert_int_equal(open_chips, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_frame_over_spi_lines_is_seen_on_the_panel),
        cmocka_unit_test(a_frame_over_an_8080_bus_is_seen_on_the_panel),
        cmocka_unit_test(a_frame_over_the_fewest_wires_is_seen_on_the_panel),
        cmocka_unit_test(lines_may_be_on_several_chips_and_active_low),
        cmocka_unit_test(a_link_to_a_chip_is_no_second_chip_with_the_same_lines),
        cmocka_unit_test(an_8080_byte_takes_two_calls_and_an_spi_bit_two),
        cmocka_unit_test(letters_are_counted_as_people_mistake_them),
        cmocka_unit_test(the_list_has_every_chip_with_its_lines_and_their_users),
    };
    return cmocka_run_group_tests_name("gpio", tests, NULL, NULL);
}
#else
int main(void)
{
    puts("ok 1 - gpio # SKIP it is for libgpiod 1");
    return 0;
}
#endif
