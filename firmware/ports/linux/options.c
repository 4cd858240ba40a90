/* SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "options.h"

enum { SIDE_MAX = 8192, BUFFER_MAX = 64 << 20, EACH_DEFAULT = 1000, EACH_MAX = 999999 };

static const struct {
    const char *name;
    uint8_t format;
} formats[] = {{"rgb565", GUD_RGB565}, {"rgb888", GUD_RGB888}, {"xrgb8888", GUD_XRGB8888}, {"r8", GUD_R8},
               {"r1", GUD_R1},         {"rgb332", GUD_RGB332}, {"xrgb1111", GUD_XRGB1111}, {"argb8888", GUD_ARGB8888}};
enum { FORMATS = sizeof formats / sizeof *formats };

enum { MAX_BUFFER = 256, NO_LZ4, SERIAL, UDC, NAME, SPEED, VID_PID, EACH, FRAMEBUFFER };
static const struct argp_option list[] = {
    {0, 0, 0, 0, "The display", 1},
    {"size", 's', "WxH", 0, "Pixels (default 240x240)", 0},
    {"formats", 'f', "LIST", 0,
     "Pixel formats offered, the best first: rgb565, rgb888, xrgb8888, argb8888, r8, r1, rgb332, xrgb1111, by commas "
     "(default rgb565,rgb888,xrgb8888,r8,r1)",
     0},
    {"max-buffer", MAX_BUFFER, "BYTES", 0,
     "The largest rectangle before compression; hosts split larger ones (default: a whole frame)", 0},
    {"no-lz4", NO_LZ4, 0, 0, "Do not offer compression", 0},
    {0, 0, 0, 0, "Where pictures go", 2},
    {"output", 'o', "FILE", 0,
     "The picture, written on SIGUSR1 and at the end: PNG or PPM by its suffix, else raw rows of r, g, b", 0},
    {"each", EACH, "COUNT", OPTION_ARG_OPTIONAL,
     "Also write one after each rectangle, with a number before the suffix, FILE-000001.png; COUNT files at most "
     "(default 1000)",
     0},
    {"framebuffer", FRAMEBUFFER, "DEVICE", 0,
     "Draw on this framebuffer, such as /dev/fb0, of 16, 24 or 32 bits a pixel", 0},
    {0, 0, 0, 0, "USB", 3},
    {"udc", UDC, "NAME", 0, "The device controller (default: the first of /sys/class/udc that is free)", 0},
    {"name", NAME, "NAME", 0, "The gadget's name in configfs, for several at a time (default glint)", 0},
    {"serial", SERIAL, "TEXT", 0, "Serial number (default 1)", 0},
    {"vid-pid", VID_PID, "VVVV:PPPP", 0, "Hexadecimal IDs (default 1d50:614d, GUD's)", 0},
    {"speed", SPEED, "SPEED", 0, "At most full, high or super (default: what the controller can)", 0},
    {"verbose", 'v', 0, 0, "Print requests and rectangles on standard error", 0},
    {0}};

static const char description[] =
    "Makes this board a USB display: any Linux machine that it is plugged into takes it for a monitor (GUD, the "
    "Generic USB Display), and `glint stream --to usb` draws on it."
    "\vNeeds root, a USB device controller and a kernel with FunctionFS (CONFIG_USB_CONFIGFS_F_FS). Prints a line when "
    "it is on the bus; ends on SIGINT or SIGTERM.\n\n"
    "Examples:\n"
    "  glint-gadget --size 320x240 --framebuffer /dev/fb0\n"
    "  glint-gadget --formats rgb565 --max-buffer 32768 -o picture.png";

static void parse_size(const struct argp_state *state, const char *text, struct options *options)
{
    unsigned width, height;
    int length = 0;
    if (strspn(text, "0123456789x") != strlen(text) || sscanf(text, "%5ux%5u%n", &width, &height, &length) < 2 ||
        text[length] || width < 1 || height < 1 || width > SIDE_MAX || height > SIDE_MAX)
        argp_error(state, "--size: '%s' is not WxH, each from 1 to %d", text, SIDE_MAX);
    options->width = (uint16_t)width;
    options->height = (uint16_t)height;
}

static void parse_formats(const struct argp_state *state, const char *text, struct options *options)
{
    options->format_count = 0;
    for (const char *word = text;;) {
        const size_t length = strcspn(word, ",");
        unsigned i = 0;
        while (i < FORMATS && (strlen(formats[i].name) != length || memcmp(formats[i].name, word, length) != 0))
            i++;
        if (i == FORMATS)
            argp_error(state,
                       "--formats: unknown format '%.*s'; choose from rgb565, rgb888, xrgb8888, argb8888, r8, r1, "
                       "rgb332, xrgb1111",
                       (int)length, word);
        if (options->format_count == GUD_FORMATS_MAX ||
            memchr(options->formats, formats[i].format, options->format_count))
            argp_error(state, "--formats: '%.*s' is listed twice", (int)length, word);
        options->formats[options->format_count++] = formats[i].format;
        if (word[length] == 0)
            return;
        word += length + 1;
    }
}

static uint32_t parse_vid_pid(const struct argp_state *state, const char *text)
{
    unsigned vendor, product;
    int length = 0;
    if (strspn(text, "0123456789abcdefABCDEF:") != strlen(text) ||
        sscanf(text, "%4x:%4x%n", &vendor, &product, &length) < 2 || text[length])
        argp_error(state, "--vid-pid: '%s' is not two hexadecimal numbers as in 1d50:614d", text);
    return (uint32_t)vendor << 16 | product;
}

static const char *parse_speed(const struct argp_state *state, const char *text)
{
    static const char *const speeds[] = {"full", "full-speed", "high", "high-speed", "super", "super-speed"};
    for (unsigned i = 0; i < 6; i += 2)
        if (strcmp(text, speeds[i]) == 0)
            return speeds[i + 1];
    argp_error(state, "--speed: '%s' is not full, high or super", text);
    return NULL;
}

static const char *parse_name(const struct argp_state *state, const char *text)
{
    if (!*text || strlen(text) > 32 ||
        strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-") != strlen(text))
        argp_error(state, "--name: '%s' is not 1 to 32 letters, digits, '_' or '-'", text);
    return text;
}

static uint32_t parse_max_buffer(const struct argp_state *state, const char *text)
{
    char *end;
    const unsigned long value = strtoul(text, &end, 10);
    if (*text < '0' || *text > '9' || *end || value < 1 || value > BUFFER_MAX)
        argp_error(state, "--max-buffer: '%s' is not a number of bytes from 1 to %d", text, BUFFER_MAX);
    return (uint32_t)value;
}

static unsigned parse_each(const struct argp_state *state, const char *text)
{
    if (!text)
        return EACH_DEFAULT;
    char *end;
    const unsigned long value = strtoul(text, &end, 10);
    if (*text < '0' || *text > '9' || *end || value < 1 || value > EACH_MAX)
        argp_error(state, "--each: '%s' is not a number of files from 1 to %d", text, EACH_MAX);
    return (unsigned)value;
}

/* A rectangle has at least a line, and by default the whole frame. */
static void settle_max_buffer(const struct argp_state *state, struct options *options)
{
    size_t line = 0;
    for (unsigned i = 0; i < options->format_count; i++) {
        const size_t bytes = gud_line_bytes((enum gud_format)options->formats[i], options->width);
        line = bytes > line ? bytes : line;
    }
    const size_t frame = line * options->height;
    if (options->max_buffer == 0)
        options->max_buffer = frame < BUFFER_MAX ? (uint32_t)frame : BUFFER_MAX;
    if (options->max_buffer < line)
        argp_error(state, "--max-buffer: %u is less than a line of the widest format, %zu", options->max_buffer, line);
}

static error_t parse(int key, char *text, struct argp_state *state)
{
    struct options *options = state->input;
    switch (key) {
    case 's':
        parse_size(state, text, options);
        break;
    case 'f':
        parse_formats(state, text, options);
        break;
    case MAX_BUFFER:
        options->max_buffer = parse_max_buffer(state, text);
        break;
    case NO_LZ4:
        options->lz4 = false;
        break;
    case 'o':
        options->output = text;
        break;
    case EACH:
        options->each = parse_each(state, text);
        break;
    case FRAMEBUFFER:
        options->framebuffer = text;
        break;
    case UDC:
        options->udc = text;
        break;
    case NAME:
        options->name = parse_name(state, text);
        break;
    case SERIAL:
        options->serial = text;
        break;
    case VID_PID:
        options->vid_pid = parse_vid_pid(state, text);
        break;
    case SPEED:
        options->speed = parse_speed(state, text);
        break;
    case 'v':
        options->verbose = true;
        break;
    case ARGP_KEY_ARG:
        argp_error(state, "unexpected argument '%s'; there are only options", text);
        break;
    case ARGP_KEY_END:
        if (options->each && !options->output)
            argp_error(state, "--each: give -o FILE, too");
        settle_max_buffer(state, options);
        break;
    default:
        return ARGP_ERR_UNKNOWN;
    }
    return 0;
}

const struct argp gadget_argp = {list, parse, NULL, description, NULL, NULL, NULL};

void options_default(struct options *options)
{
    *options = (struct options){
        .width = 240, .height = 240, .lz4 = true, .vid_pid = GUD_ID_OPENMOKO, .serial = "1", .name = "glint"};
    static const uint8_t usual[] = {GUD_RGB565, GUD_RGB888, GUD_XRGB8888, GUD_R8, GUD_R1};
    memcpy(options->formats, usual, sizeof usual);
    options->format_count = sizeof usual;
}
