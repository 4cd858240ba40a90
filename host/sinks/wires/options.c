/* SPDX-License-Identifier: MIT */
#include "sinks/wires/options.h"

#include <errno.h>
#include <ini.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/argp.h"
#include "base/memory.h"
#include "base/message.h"
#include "base/parse.h"
#include "sinks/panel/options.h"

enum key { KEY_BUS = 256, KEY_CHIP, KEY_SPIDEV, KEY_SPI_HZ, KEY_SPI_MODE, KEY_LINES, KEY_BUS_CONFIG };
enum { TEXTS = KEY_LINES - KEY_BUS };

#define GROUP 50
static const struct argp_option options[] = {
    {NULL, 0, NULL, 0, "The wires to the panel (--to gpio, spi):", GROUP},
    {"lines", KEY_LINES, "ROLE=LINE,...", 0,
     "Which GPIO line does what; may be repeated. LINE is a NAME, CHIP:OFFSET or CHIP:NAME (`glint list` shows "
     "them); a ! before it: active low. --bus spi: sck, mosi, dc, and if wired cs, reset, backlight. --bus 8080: "
     "d0 ... d7, wr, dc, and if wired cs, rd, reset, backlight. --to spi: dc, and if wired reset, backlight",
     GROUP},
    {"chip", KEY_CHIP, "CHIP", 0, "The chip of lines that name none; then a LINE may be an OFFSET", GROUP},
    {"spi-mode", KEY_SPI_MODE, "N", 0,
     "SPI with a clock that rests low (0, the default) or high (3, for ST7789 modules without CS)", GROUP},
    {"bus-config", KEY_BUS_CONFIG, "FILE", 0,
     "Reads all of this and the panel's options from a file; the command line overrides it", GROUP},
    {0}};

static const struct argp_option line_options[] = {
    {"bus", KEY_BUS, "KIND", 0, "--to gpio: spi (default: 4-wire) or 8080 (8 bits)", GROUP}, {0}};

static const struct argp_option spidev_options[] = {
    {"spidev", KEY_SPIDEV, "DEVICE", 0, "--to spi: the kernel's SPI device (default /dev/spidev0.0)", GROUP},
    {"spi-hz", KEY_SPI_HZ, "N", 0,
     "--to spi: bits a second (default 16000000; an ST7789 is good for 62500000 on short wires, an ILI9341 for "
     "10000000 by its data sheet and often 40000000)",
     GROUP},
    {0}};

static const char *const bus_names[] = {"spi", "8080", NULL};
/* Panels take bits as the clock rises, for which the others are not. */
static const char *const mode_names[] = {"0", "3", NULL};

/* ---- roles ---- */

const char *const gpio_role_names[ROLES] = {"d0",  "d1",   "d2", "d3", "d4", "d5",    "d6",        "d7",
                                            "sck", "mosi", "dc", "cs", "rd", "reset", "backlight", "wr"};

/* As modules have them printed beside their pins. */
static const struct {
    const char *name;
    enum gpio_role role;
} aliases[] = {{"sclk", ROLE_SCK},     {"clk", ROLE_SCK},       {"scl", ROLE_SCK},      {"sda", ROLE_MOSI},
               {"din", ROLE_MOSI},     {"rs", ROLE_DC},         {"rst", ROLE_RESET},    {"res", ROLE_RESET},
               {"bl", ROLE_BACKLIGHT}, {"led", ROLE_BACKLIGHT}, {"blk", ROLE_BACKLIGHT}};

#define ROLE_BIT(role) ((uint32_t)1 << (role))
static const struct {
    const char *name;
    uint32_t needed, welcome;
} buses[] = {
    [GPIO_BUS_SPI] = {"--bus spi", ROLE_BIT(ROLE_SCK) | ROLE_BIT(ROLE_MOSI) | ROLE_BIT(ROLE_DC),
                      ROLE_BIT(ROLE_CS) | ROLE_BIT(ROLE_RESET) | ROLE_BIT(ROLE_BACKLIGHT)},
    [GPIO_BUS_8080] = {"--bus 8080", 0xff | ROLE_BIT(ROLE_WR) | ROLE_BIT(ROLE_DC),
                       ROLE_BIT(ROLE_CS) | ROLE_BIT(ROLE_RD) | ROLE_BIT(ROLE_RESET) | ROLE_BIT(ROLE_BACKLIGHT)},
    [GPIO_BUS_SPIDEV] = {"--to spi", ROLE_BIT(ROLE_DC), ROLE_BIT(ROLE_RESET) | ROLE_BIT(ROLE_BACKLIGHT)},
};

static const char *role_list(uint32_t roles) /* "sck, mosi" */
{
    static char text[128];
    *text = '\0';
    for (unsigned i = 0; i < ROLES; i++)
        if (roles & ROLE_BIT(i))
            sprintf(text + strlen(text), "%s%s", *text ? ", " : "", gpio_role_names[i]);
    return text;
}

static enum gpio_role parse_role(const struct argp_state *state, const char *origin, const char *name)
{
    for (unsigned i = 0; i < ROLES; i++)
        if (strcasecmp(name, gpio_role_names[i]) == 0)
            return (enum gpio_role)i;
    for (size_t i = 0; i < sizeof aliases / sizeof *aliases; i++)
        if (strcasecmp(name, aliases[i].name) == 0)
            return aliases[i].role;
    refuse(state, "%s: unknown line '%s'; choose from %s", origin, name, role_list((1u << ROLES) - 1));
}

/* ---- what was said ---- */

struct said {
    const char *texts[TEXTS]; /* by key; NULL: nothing */
    struct {
        const char *origin, *text;
    } lines[ROLES];
};
static struct said by_user, by_file;
static const char *config_path;

static void say_line(const struct argp_state *state, struct said *said, const char *origin, const char *role,
                     const char *text)
{
    const enum gpio_role wanted = parse_role(state, origin, role);
    if (!text[*text == '!'])
        refuse(state, "%s: %s names no line; write %s=NAME or %s=CHIP:OFFSET", origin, role, role, role);
    if (said->lines[wanted].text)
        refuse(state, "%s: %s is given twice, as %s and %s", origin, gpio_role_names[wanted], said->lines[wanted].text,
               text);
    said->lines[wanted].origin = copied(origin);
    said->lines[wanted].text = copied(text);
}

static void say_lines(const struct argp_state *state, const char *text)
{
    char *copy = copied(text), *rest = copy;
    for (char *word; (word = strsep(&rest, ","));) {
        char *equals = strchr(word, '=');
        if (!equals)
            refuse(state, "--lines: '%s' is not ROLE=LINE, as in dc=GPIO25", word);
        *equals = '\0';
        say_line(state, &by_user, "--lines", word, equals + 1);
    }
    free(copy);
}

/* Checks; what is kept is the text. */
static void say(const struct argp_state *state, struct said *said, const char *origin, enum key key, const char *text)
{
    if (key == KEY_BUS)
        parse_choice(state, origin, "bus", text, bus_names);
    else if (key == KEY_SPI_MODE)
        parse_choice(state, origin, "mode", text, mode_names);
    else if (key == KEY_SPI_HZ)
        parse_integer(state, origin, text, 1000, 200000000);
    else if (!*text)
        refuse(state, "%s: the name is empty", origin);
    said->texts[key - KEY_BUS] = copied(text);
}

/* ---- the file ---- */

struct reader {
    FILE *stream;
    unsigned line;
    char origin[128]; /* "pins.ini:7" */
    uint32_t seen;    /* keys before [lines] that came already */
};

static void set_origin(struct reader *reader)
{
    snprintf(reader->origin, sizeof reader->origin, "%.100s:%u", config_path, reader->line);
}

/* As fgets, but a zero byte is an error, and a line that begins with blanks is not the rest of the one before. Comments begin
 * with a # at the beginning or after a blank. */
static char *read_line(char *text, int room, void *context)
{
    struct reader *reader = context;
    int length = 0, byte = 0;
    reader->line++;
    set_origin(reader);
    while (byte != '\n' && (byte = getc(reader->stream)) != EOF) {
        if (byte == '\0')
            fail("%s: holds a zero byte; give a text file", reader->origin);
        if (length + 1 == room)
            fail("%s: the line is longer than %d characters", reader->origin, room - 2);
        if (length || (byte != ' ' && byte != '\t'))
            text[length++] = (char)byte;
    }
    text[length] = '\0';
    for (char *at = text; (at = strpbrk(at, " \t")); at++) /* inih itself takes only a ; in the middle of a line */
        if (at[1] == '#')
            *at = '\0';
    return length ? text : NULL;
}

/* First those that are said here, by key; then the panel's. */
static const char *const setting_names[] = {"bus",  "chip",     "spidev", "spi-hz", "spi-mode", "panel",
                                            "size", "rotation", "offset", "bgr",    "invert"};
enum { SETTINGS = sizeof setting_names / sizeof *setting_names };

static int take(void *context, const char *section, const char *name, const char *text)
{
    struct reader *reader = context;
    if (strcmp(section, "lines") == 0) {
        say_line(NULL, &by_file, reader->origin, name, text);
        return 1;
    }
    if (*section)
        fail("%s: [%s]: the only section is [lines], after the settings", reader->origin, section);
    unsigned i = 0;
    while (i < SETTINGS && strcmp(name, setting_names[i]) != 0)
        i++;
    if (i == SETTINGS)
        fail("%s: unknown setting '%s'; choose from bus, chip, spidev, spi-hz, spi-mode, panel, size, rotation, "
             "offset, bgr, invert; [lines] begins the lines",
             reader->origin, name);
    if (reader->seen >> i & 1)
        fail("%s: %s is given twice", reader->origin, name);
    reader->seen |= (uint32_t)1 << i;
    char origin[sizeof reader->origin + 16];
    snprintf(origin, sizeof origin, "%s: %s", reader->origin, name);
    if (i < TEXTS)
        say(NULL, &by_file, origin, (enum key)(KEY_BUS + i), text);
    else
        panel_options_set(origin, name, text);
    return 1;
}

static void read_config(void)
{
    static bool done;
    if (done) /* the options are three argps */
        return;
    done = true;
    struct reader reader = {.stream = fopen(config_path, "r")};
    struct stat status;
    if (!reader.stream)
        fail("--bus-config: %s: %s", config_path, strerror(errno));
    if (fstat(fileno(reader.stream), &status) == 0 && S_ISDIR(status.st_mode))
        fail("--bus-config: %s: this is a folder; name a file", config_path);
    const int bad = ini_parse_stream(read_line, &reader, take, &reader);
    if (ferror(reader.stream))
        fail("--bus-config: %s: %s", config_path, strerror(errno));
    fclose(reader.stream);
    if (bad > 0)
        fail("%s:%d: neither NAME = VALUE nor [lines] nor a # comment", config_path, bad);
}

/* ---- the command line ---- */

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    if (key >= KEY_BUS && key < KEY_LINES) {
        char origin[16];
        snprintf(origin, sizeof origin, "--%s", setting_names[key - KEY_BUS]);
        say(state, &by_user, origin, (enum key)key, text);
    } else if (key == KEY_LINES)
        say_lines(state, text);
    else if (key == KEY_BUS_CONFIG)
        config_path = parse_output(state, "--bus-config", text);
    else if (key == ARGP_KEY_SUCCESS && config_path) /* here, where a signal still ends the program at once */
        read_config();
    else
        return ARGP_ERR_UNKNOWN;
    return 0;
}

const struct argp gpio_options_argp = {options, parse_option, NULL, NULL, NULL, NULL, NULL};
const struct argp gpio_line_options_argp = {line_options, parse_option, NULL, NULL, NULL, NULL, NULL};
const struct argp gpio_spidev_options_argp = {spidev_options, parse_option, NULL, NULL, NULL, NULL, NULL};

/* ---- both together ---- */

static const char *text_of(enum key key, const char *usual)
{
    const char *user = by_user.texts[key - KEY_BUS], *file = by_file.texts[key - KEY_BUS];
    return user ? user : file ? file : usual;
}

static void check_lines(const struct gpio_options *o)
{
    uint32_t given = 0;
    for (unsigned i = 0; i < ROLES; i++)
        given |= o->lines[i].text ? ROLE_BIT(i) : 0;
    const uint32_t needed = buses[o->kind].needed, missing = needed & ~given;
    if (missing)
        fail("--lines: %s needs a line for %s; give it by --lines %s=NAME or in a file by --bus-config",
             buses[o->kind].name, role_list(missing), gpio_role_names[__builtin_ctz(missing)]);
    const uint32_t unwelcome = given & ~(needed | buses[o->kind].welcome);
    if (!unwelcome)
        return;
    const unsigned first = (unsigned)__builtin_ctz(unwelcome);
    fail("%s: %s has no line %s%s; it has %s", o->lines[first].origin, buses[o->kind].name, gpio_role_names[first],
         o->kind == GPIO_BUS_SPIDEV ? " (the SPI device drives its own)" : "",
         role_list(needed | buses[o->kind].welcome));
}

const struct gpio_options *gpio_options_ready(bool spidev)
{
    static struct gpio_options ready;
    const bool parallel = strcmp(text_of(KEY_BUS, "spi"), "8080") == 0;
    ready.kind = spidev ? GPIO_BUS_SPIDEV : parallel ? GPIO_BUS_8080 : GPIO_BUS_SPI;
    ready.chip = text_of(KEY_CHIP, NULL);
    ready.spidev = text_of(KEY_SPIDEV, "/dev/spidev0.0");
    ready.spi_hz = (uint32_t)strtoul(text_of(KEY_SPI_HZ, "16000000"), NULL, 10);
    const char *mode = text_of(KEY_SPI_MODE, NULL);
    ready.clock_rests_high = mode && *mode == '3';
    if (mode && ready.kind == GPIO_BUS_8080)
        fail("--spi-mode: is for SPI; leave it out for --bus 8080");
    for (unsigned i = 0; i < ROLES; i++) {
        const bool user = by_user.lines[i].text != NULL;
        ready.lines[i].text = user ? by_user.lines[i].text : by_file.lines[i].text;
        ready.lines[i].origin = user ? by_user.lines[i].origin : by_file.lines[i].origin;
    }
    check_lines(&ready);
    return &ready;
}
