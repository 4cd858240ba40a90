/* SPDX-License-Identifier: MIT
 * libgpiod 1 replaced: chips that are not there, whose lines lead to a virtual panel; and sinks opened on them. */
#ifndef GLINT_STAND_IN_GPIOD_H
#define GLINT_STAND_IN_GPIOD_H

#include <dirent.h>
#include <errno.h>
#include <gpiod.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "sinks/panel/options.h"
#include "sinks/panel/virtual_panel.h"
#include "sinks/wires/bus.h"
#include "sinks/wires/display.h"
#include "sinks/wires/find.h"
#include "sinks/wires/lines.h"
#include "unit.h"

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
static bool no_chips, is_linked; /* gpiochip11 leads to gpiochip0 */
static struct gpiod_chip link_to_main;

int scandir(const char *folder, struct dirent ***entries, int (*select)(const struct dirent *),
            int (*order)(const struct dirent **, const struct dirent **))
{
    assert_string_equal(folder, "/dev");
    assert_true(!select && order == versionsort);
    static const char *const names[] = {"full",       "gpio",      "gpiochip0", "gpiochip10",
                                        "gpiochip11", "gpiochipx", "spidev0.1"};
    enum { COUNT = sizeof names / sizeof *names };
    *entries = malloc(COUNT * sizeof **entries);
    int count = 0;
    for (int i = 0; i < COUNT; i++) {
        if (no_chips && strncmp(names[i], "gpiochip", 8) == 0)
            continue;
        if (!is_linked && strcmp(names[i], "gpiochip11") == 0)
            continue;
        struct dirent *entry = calloc(1, sizeof *entry);
        strcpy(entry->d_name, names[i]);
        (*entries)[count++] = entry;
    }
    return count;
}

struct gpiod_chip *gpiod_chip_open(const char *path)
{
    if (is_linked && strcmp(path, "/dev/gpiochip11") == 0) {
        link_to_main = chips[0];
        open_chips++;
        return &link_to_main;
    }
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

static inline bool *wire(const char *name)
{
    for (int chip = 0; chip < CHIPS; chip++)
        for (unsigned i = 0; i < chips[chip].count; i++)
            if (chips[chip].lines[i].name && strcmp(chips[chip].lines[i].name, name) == 0)
                return &chips[chip].lines[i].high;
    fail_msg("no line %s", name);
    return NULL;
}

static bool data_command_high; /* of whichever line does that */
static inline void take_byte(unsigned byte)
{
    bytes_seen++;
    if (data_command_high)
        virtual_panel_data(&screen, (const uint8_t[]){(uint8_t)byte}, 1);
    else
        virtual_panel_command(&screen, (uint8_t)byte);
}

static inline void follow(bool clock_before, bool strobe_before)
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

static inline struct gpio_options wires(enum gpio_bus_kind kind)
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
    active_low_light = no_chips = is_linked = false;
    for (int chip = 0; chip < CHIPS; chip++) {
        chips[chip].refused = 0;
        for (unsigned i = 0; i < chips[chip].count; i++)
            chips[chip].lines[i].high = false;
    }
    return options;
}

enum { WIDTH = 20, HEIGHT = 12 };
static uint8_t seen[WIDTH * HEIGHT * 3];

static inline struct sink *opened(const struct gpio_options *options)
{
    static char *arguments[] = {"stream", "--offset=7,9", "--panel=st7789", NULL};
    argp_parse(&panel_options_argp, 3, arguments, 0, NULL, NULL);
    const struct virtual_glass glass = {.width = WIDTH, .height = HEIGHT, .x = 7, .y = 9, .inverted = true};
    virtual_panel_init(&screen, &glass);
    struct sink *sink = gpio_display_open(options, &(struct sink_wish){.width = WIDTH, .height = HEIGHT});
    assert_non_null(sink);
    assert_int_equal(sink->format, GLINT_RGB565_SWAPPED);
    return sink;
}

/* Two pieces whose pixels are told apart. */
static inline void send_two_pieces(struct sink *sink)
{
    static uint8_t pixels[WIDTH * HEIGHT * 2], dot[2] = {0xf8, 0x00};
    for (size_t i = 0; i < sizeof pixels; i++)
        pixels[i] = (uint8_t)(i * 37 >> 2);
    const struct piece pieces[] = {
        {.box = {0, 0, WIDTH, HEIGHT}, .bytes = sizeof pixels, .length = sizeof pixels, .data = pixels},
        {.box = {3, 2, 1, 1}, .bytes = 2, .length = 2, .data = dot}};
    assert_int_equal(gpio_display_send(sink, NULL, pieces, 2), SINK_SENT);
    virtual_panel_look(&screen, 0, seen);
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        const bool dotted = i == 2 * WIDTH + 3;
        const unsigned color = dotted ? 0xf800u : (unsigned)pixels[2 * i] << 8 | pixels[2 * i + 1];
        assert_int_equal(seen[3 * i], ((color >> 11) * 255 + 15) / 31);
        assert_int_equal(seen[3 * i + 1], ((color >> 5 & 63) * 255 + 31) / 63);
        assert_int_equal(seen[3 * i + 2], ((color & 31) * 255 + 15) / 31);
    }
}

static inline void close_and_check(struct sink *sink)
{
    gpio_display_close(sink);
    assert_false(screen.on || screen.awake || screen.lit);
    assert_int_equal(open_chips, 0);
    assert_int_equal(held_lines, 0);
}

#endif
