/* SPDX-License-Identifier: MIT
 * Panels on GPIO lines, over a libgpiod 1 of the test's own: its lines lead to a virtual panel. (Version 2, and the real
 * library on a real kernel: tests/lab.) */
#include <stdio.h>

#if GLINT_WITH_GPIO == 1
#include <dirent.h>
#include <errno.h>
#include <gpiod.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "gpio_bus.h"
#include "gpio_display.h"
#include "gpio_find.h"
#include "gpio_lines.h"
#include "host.h"
#include "panel_options.h"
#include "unit.h"
#include "virtual_panel.h"

/* ---- the library's place is taken ---- */

struct gpiod_line {
    const char *name, *consumer; /* a consumer: in use */
    bool high;
};
enum { WIRES = 17 };
struct gpiod_chip {
    const char *name, *label;
    unsigned count;
    int refused; /* errno of open */
    struct gpiod_line lines[WIRES];
};
static struct gpiod_chip chips[] = {
    {.name = "gpiochip0",
     .label = "main",
     .count = WIRES,
     .lines = {{.name = "D0"},
               {.name = "D1"},
               {.name = "D2"},
               {.name = "D3"},
               {.name = "D4"},
               {.name = "D5"},
               {.name = "D6"},
               {.name = "D7"},
               {.name = "DC"},
               {.name = "WR"},
               {.name = "RD"},
               {.name = "SCK"},
               {.name = "MOSI"},
               {.name = "CS"},
               {.name = "RST"},
               {.name = "LIGHT"},
               {.name = NULL}}},
    {.name = "gpiochip10",
     .label = "aside",
     .count = 3,
     .lines = {{.name = "SCK"}, {.name = "TAKEN", .consumer = "a camera"}, {.name = "FAR-DC"}}},
};
enum { CHIPS = sizeof chips / sizeof *chips };
static int open_chips, held_lines;
static unsigned long calls, calls_that_work;
static bool no_chips;

int scandir(const char *folder, struct dirent ***entries, int (*select)(const struct dirent *),
            int (*order)(const struct dirent **, const struct dirent **))
{
    assert_string_equal(folder, "/dev");
    assert_true(!select && order == versionsort);
    static const char *const names[] = {"full", "gpio", "gpiochip0", "gpiochip10", "gpiochipx", "spidev0.1"};
    enum { COUNT = sizeof names / sizeof *names };
    *entries = malloc(COUNT * sizeof **entries);
    int count = 0;
    for (int i = 0; i < COUNT; i++) {
        if (no_chips && strncmp(names[i], "gpiochip", 8) == 0)
            continue;
        struct dirent *entry = calloc(1, sizeof *entry);
        strcpy(entry->d_name, names[i]);
        (*entries)[count++] = entry;
    }
    return count;
}

struct gpiod_chip *gpiod_chip_open(const char *path)
{
    for (int i = 0; i < CHIPS; i++) {
        if (strcmp(path + strlen("/dev/"), chips[i].name) != 0)
            continue;
        errno = chips[i].refused;
        open_chips += !chips[i].refused;
        return chips[i].refused ? NULL : &chips[i];
    }
    errno = ENOENT;
    return NULL;
}

void gpiod_chip_close(struct gpiod_chip *chip)
{
    assert_non_null(chip);
    open_chips--;
}

const char *gpiod_chip_name(struct gpiod_chip *chip)
{
    return chip->name;
}

const char *gpiod_chip_label(struct gpiod_chip *chip)
{
    return chip->label;
}

unsigned gpiod_chip_num_lines(struct gpiod_chip *chip)
{
    return chip->count;
}

struct gpiod_line *gpiod_chip_get_line(struct gpiod_chip *chip, unsigned offset)
{
    assert_true(offset < chip->count);
    return &chip->lines[offset];
}

int gpiod_line_update(struct gpiod_line *line)
{
    assert_non_null(line);
    return 0;
}

const char *gpiod_line_name(struct gpiod_line *line)
{
    return line->name;
}

const char *gpiod_line_consumer(struct gpiod_line *line)
{
    return line->consumer;
}

bool gpiod_line_is_used(struct gpiod_line *line)
{
    return line->consumer != NULL;
}

/* ---- what the lines lead to ---- */

static struct virtual_panel screen;
static bool active_low_light;
static unsigned bits, bit_count;
static size_t bytes_seen;

static bool *wire(const char *name)
{
    for (int chip = 0; chip < CHIPS; chip++)
        for (unsigned i = 0; i < chips[chip].count; i++)
            if (chips[chip].lines[i].name && strcmp(chips[chip].lines[i].name, name) == 0)
                return &chips[chip].lines[i].high;
    fail_msg("no line %s", name);
    return NULL;
}

static bool data_command_high; /* of whichever line does that */
static void take_byte(unsigned byte)
{
    bytes_seen++;
    if (data_command_high)
        virtual_panel_data(&screen, (const uint8_t[]){(uint8_t)byte}, 1);
    else
        virtual_panel_command(&screen, (uint8_t)byte);
}

static void follow(bool clock_before, bool strobe_before)
{
    data_command_high = *wire("DC") || *wire("FAR-DC");
    if (!*wire("RST"))
        virtual_panel_reset(&screen);
    screen.lit = *wire("LIGHT") != active_low_light;
    if (*wire("CS"))
        bit_count = 0;
    else if (*wire("SCK") && !clock_before) {
        bits = bits << 1 | *wire("MOSI");
        if (++bit_count % 8 == 0)
            take_byte(bits & 0xff);
    } else if (*wire("WR") && !strobe_before) {
        unsigned byte = 0;
        for (unsigned i = 0; i < 8; i++)
            byte |= (unsigned)chips[0].lines[i].high << i;
        take_byte(byte);
    }
}

int gpiod_line_request_bulk_output(struct gpiod_line_bulk *bulk, const char *consumer, const int *values)
{
    assert_string_equal(consumer, "glint");
    for (unsigned i = 0; i < bulk->num_lines; i++) {
        if (bulk->lines[i]->consumer) {
            errno = EBUSY;
            return -1;
        }
    }
    for (unsigned i = 0; i < bulk->num_lines; i++) {
        bulk->lines[i]->consumer = consumer;
        bulk->lines[i]->high = values[i];
    }
    held_lines += (int)bulk->num_lines;
    return 0;
}

int gpiod_line_set_value_bulk(struct gpiod_line_bulk *bulk, const int *values)
{
    if (calls++ >= calls_that_work) {
        errno = ENODEV;
        return -1;
    }
    const bool clock = *wire("SCK"), strobe = *wire("WR");
    for (unsigned i = 0; i < bulk->num_lines; i++) {
        assert_string_equal(bulk->lines[i]->consumer, "glint");
        bulk->lines[i]->high = values[i];
    }
    follow(clock, strobe);
    return 0;
}

void gpiod_line_release_bulk(struct gpiod_line_bulk *bulk)
{
    for (unsigned i = 0; i < bulk->num_lines; i++)
        bulk->lines[i]->consumer = NULL;
    held_lines -= (int)bulk->num_lines;
}

const char *gpiod_version_string(void)
{
    return "1.0-test";
}

/* ---- frames ---- */

static struct gpio_options wires(enum gpio_bus_kind kind)
{
    struct gpio_options options = {.kind = kind, .chip = "main", .spi_hz = 1};
    static const char *const names[ROLES] = {
        [ROLE_D0] = "D0",     [ROLE_D0 + 1] = "D1",       [ROLE_D0 + 2] = "D2", [ROLE_D0 + 3] = "D3",
        [ROLE_D0 + 4] = "D4", [ROLE_D0 + 5] = "D5",       [ROLE_D0 + 6] = "D6", [ROLE_D0 + 7] = "D7",
        [ROLE_DC] = "DC",     [ROLE_MOSI] = "MOSI",       [ROLE_CS] = "CS",     [ROLE_RD] = "RD",
        [ROLE_RESET] = "RST", [ROLE_BACKLIGHT] = "LIGHT", [ROLE_SCK] = "SCK",   [ROLE_WR] = "WR"};
    for (unsigned i = 0; i < ROLES; i++) {
        const bool parallel = i <= ROLE_D7 || i == ROLE_RD || i == ROLE_WR, serial = i == ROLE_MOSI || i == ROLE_SCK;
        if (kind == GPIO_BUS_SPI ? !parallel : !serial) {
            options.lines[i].origin = "--lines";
            options.lines[i].text = names[i];
        }
    }
    calls = bytes_seen = bit_count = 0;
    calls_that_work = ULONG_MAX;
    active_low_light = no_chips = false;
    for (int chip = 0; chip < CHIPS; chip++) {
        chips[chip].refused = 0;
        for (unsigned i = 0; i < chips[chip].count; i++)
            chips[chip].lines[i].high = false;
    }
    return options;
}

enum { WIDTH = 20, HEIGHT = 12 };
static uint8_t seen[WIDTH * HEIGHT * 3];

static struct sink *opened(const struct gpio_options *options)
{
    static char *arguments[] = {"stream", "--offset=7,9", "--panel=st7789", NULL};
    argp_parse(&panel_options_argp, 3, arguments, 0, NULL, NULL);
    const struct virtual_glass glass = {.width = WIDTH, .height = HEIGHT, .x = 7, .y = 9, .inverted = true};
    virtual_panel_init(&screen, &glass);
    struct sink *sink = gpio_display_open(&sink_gpio, options, &(struct sink_wish){.width = WIDTH, .height = HEIGHT});
    assert_non_null(sink);
    assert_int_equal(sink->format, GLINT_RGB565_SWAPPED);
    return sink;
}

/* Two pieces whose pixels are told apart. */
static void send_two_pieces(struct sink *sink)
{
    static uint8_t pixels[WIDTH * HEIGHT * 2], dot[2] = {0xf8, 0x00};
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (uint8_t)(i * 37 >> 2);
    const struct piece pieces[] = {
        {.box = {0, 0, WIDTH, HEIGHT}, .bytes = sizeof pixels, .length = sizeof pixels, .data = pixels},
        {.box = {3, 2, 1, 1}, .bytes = 2, .length = 2, .data = dot}};
    assert_int_equal(sink->kind->send(sink, NULL, pieces, 2), SINK_SENT);
    virtual_panel_look(&screen, 0, seen);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        const bool dotted = i == 2 * WIDTH + 3;
        const unsigned color = dotted ? 0xf800u : (unsigned)pixels[2 * i] << 8 | pixels[2 * i + 1];
        assert_int_equal(seen[3 * i], ((color >> 11) * 255 + 15) / 31);
        assert_int_equal(seen[3 * i + 1], ((color >> 5 & 63) * 255 + 31) / 63);
        assert_int_equal(seen[3 * i + 2], ((color & 31) * 255 + 15) / 31);
    }
}

static void close_and_check(struct sink *sink)
{
    sink->kind->close(sink);
    assert_false(screen.on || screen.awake || screen.lit);
    assert_int_equal(open_chips, 0);
    assert_int_equal(held_lines, 0);
}

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
    sink->kind->close(sink);
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

/* ---- faults, each in a process of its own ---- */

static struct gpio_options child_options;
static void open_and_send(void)
{
    struct sink *sink = opened(&child_options);
    for (int i = 0; i < 3; i++)
        send_two_pieces(sink);
    sink->kind->close(sink);
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
    assert_told(&options, "--lines: sck=SKC: no GPIO line is called 'SKC'; is it SCK? (`glint list` shows all)");
    options.lines[ROLE_SCK].text = "GPIO17";
    assert_told(&options,
                "--lines: sck=GPIO17: no GPIO line is called 'GPIO17'; `glint list` shows all, and lines without "
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
    assert_told(&options, "--lines: cs=13: no GPIO line is called so; where 13 is an offset, say of which chip: "
                          "gpiochip0:13, or --chip");
    options.lines[ROLE_SCK].text = "SCK";
    assert_told(&options, "--lines: sck=SCK: 2 lines are called so; say which: gpiochip0:11, gpiochip10:0");
}

static void a_chip_that_is_not_there_is_told_with_those_that_are(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.chip = "gpiochip1";
    assert_told(&options, "--lines: sck=SCK: there is no GPIO chip 'gpiochip1'; there is gpiochip0 (main), gpiochip10 "
                          "(aside)");
    options.chip = NULL;
    options.lines[ROLE_SCK].text = "gpiochip2:4";
    assert_told(&options, "--lines: sck=gpiochip2:4: there is no GPIO chip 'gpiochip2'; there is gpiochip0 (main), "
                          "gpiochip10 (aside)");
    no_chips = true;
    assert_told(&options, "--lines: sck=gpiochip2:4: there is no GPIO chip: no /dev/gpiochip0 on this machine; `glint "
                          "list` shows what there is");
}

static void the_same_line_for_two_wires_is_told(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_SPI);
    options.lines[ROLE_BACKLIGHT].text = "gpiochip0:8";
    options.lines[ROLE_BACKLIGHT].origin = "pins.ini:9";
    assert_told(&options, "pins.ini:9: dc and backlight are the same line, gpiochip0:8; each wants a line of its own");
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

static void a_chip_that_goes_away_ends_the_stream_with_one_line_whenever_it_does(void **state)
{
    (void)state;
    struct gpio_options options = wires(GPIO_BUS_8080);
    static const unsigned long whens[] = {0, 1, 20, 100, 1000, 1500, 2000};
    for (size_t i = 0; i < sizeof whens / sizeof *whens; i++) {
        calls_that_work = whens[i];
        assert_told(&options,
                    "gpiochip0: went away while it was in use; plug it in or load its driver again, then start "
                    "again");
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
        cmocka_unit_test(an_8080_byte_takes_two_calls_and_an_spi_bit_two),
        cmocka_unit_test(a_line_in_use_is_told_with_its_user),
        cmocka_unit_test(a_line_that_is_not_there_is_told_with_the_nearest),
        cmocka_unit_test(a_number_without_a_chip_and_a_name_that_is_there_twice_are_told),
        cmocka_unit_test(a_chip_that_is_not_there_is_told_with_those_that_are),
        cmocka_unit_test(the_same_line_for_two_wires_is_told),
        cmocka_unit_test(a_chip_that_may_not_be_opened_is_told),
        cmocka_unit_test(a_chip_that_goes_away_ends_the_stream_with_one_line_whenever_it_does),
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
