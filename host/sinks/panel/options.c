/* SPDX-License-Identifier: MIT */
#include "sinks/panel/options.h"

#include <string.h>

#include "base/argp.h"
#include "base/message.h"
#include "base/parse.h"
#include "image/format.h"

enum key { KEY_PANEL = 256, KEY_ROTATION, KEY_SIZE, KEY_OFFSET, KEY_BGR, KEY_INVERT, KEY_END };

static const struct argp_option options[] = {
    {NULL, 0, NULL, 0, "The panel (--to panel, gpio, spi):", 40},
    {"panel", KEY_PANEL, "NAME", 0,
     "Its controller: st7789 (default), ili9341, gc9a01 (round), or ssd1306 (black and white: try --dither)", 40},
    {"rotation", KEY_ROTATION, "DEGREES", 0,
     "Turns the picture on the glass clockwise: 0, 90, 180 or 270 (default 0, or 90 if the size is that of a turned "
     "glass)",
     40},
    {"offset", KEY_OFFSET, "X,Y", 0,
     "Where the glass begins in the controller's memory, unturned (default 0,0; 52,40 for 135x240, 35,0 for 170x320, "
     "34,0 for 172x320, 0,20 for 240x280)",
     40},
    {"bgr", KEY_BGR, "yes|no", OPTION_ARG_OPTIONAL,
     "The glass is wired blue first: if red and blue are exchanged, give the other value (default: yes for ili9341 and "
     "gc9a01)",
     40},
    {"invert", KEY_INVERT, "yes|no", OPTION_ARG_OPTIONAL,
     "The glass needs inversion: if the picture is a negative, give the other value (default: yes for st7789 and "
     "gc9a01)",
     40},
    {0}};

/* By key: the options, and the same in a bus's file. */
static const char *const setting_names[KEY_END - KEY_PANEL] = {"panel", "rotation", "size", "offset", "bgr", "invert"};
static const char *const controller_names[] = {
#define NAME_ON_SPI(name) name
#define NAME_ON_QSPI(name) NULL /* last in the table; a computer's lines and pictures are of those on SPI */
#define CONTROLLER(id, name, columns, rows, bgr, inverted, mirrored, clk_hz, values, bus, ...) NAME_ON_##bus(name),
#include "panels.def"
    NULL}; /* by enum panel_controller */
static const uint16_t controller_rows[] = {
#define CONTROLLER(id, name, columns, rows, ...) rows,
#include "panels.def"
};

/* ---- values ---- */

struct setting {
    bool given;
    int values[2];
};
static struct setting from_user[KEY_END - KEY_PANEL], from_file[KEY_END - KEY_PANEL];

static const struct setting *setting_of(enum key key)
{
    const struct setting *user = &from_user[key - KEY_PANEL];
    return user->given ? user : &from_file[key - KEY_PANEL];
}

static int or_usual(enum key key, int usual)
{
    return setting_of(key)->given ? setting_of(key)->values[0] : usual;
}

static void parse_pair(const struct argp_state *state, const char *origin, const char *text, char between, int low,
                       int values[2])
{
    char rest;
    const char format[] = {'%', 'd', between, '%', 'd', '%', 'c', '\0'};
    const char *const unsure = "0123456789,x"; /* sscanf would skip blanks and take signs */
    if (text[strspn(text, unsure)] || sscanf(text, format, &values[0], &values[1], &rest) != 2 || values[0] < low ||
        values[1] < low || values[0] > PANEL_ROWS || values[1] > PANEL_ROWS)
        refuse(state, "%s: '%s' is not two numbers from %d to %d with '%c' between", origin, text, low, PANEL_ROWS,
               between);
}

static void parse(const struct argp_state *state, const char *origin, enum key key, const char *text,
                  struct setting *setting)
{
    static const char *const turns[] = {"0", "90", "180", "270", NULL}, *const answers[] = {"no", "yes", NULL};
    setting->given = true;
    switch (key) {
    case KEY_PANEL:
        setting->values[0] = (int)parse_choice(state, origin, "panel", text, controller_names);
        break;
    case KEY_ROTATION:
        setting->values[0] = (int)parse_choice(state, origin, "rotation", text, turns);
        break;
    case KEY_SIZE:
        parse_pair(state, origin, text, 'x', 1, setting->values);
        break;
    case KEY_OFFSET:
        parse_pair(state, origin, text, ',', 0, setting->values);
        break;
    default:
        setting->values[0] = (int)parse_choice(state, origin, "answer", text, answers);
        break;
    }
}

static error_t parse_option(int key, char *text, struct argp_state *state)
{
    if (key < KEY_PANEL || key >= KEY_END)
        return ARGP_ERR_UNKNOWN;
    char origin[16];
    snprintf(origin, sizeof origin, "--%s", setting_names[key - KEY_PANEL]);
    parse(state, origin, (enum key)key, text ? text : "yes", &from_user[key - KEY_PANEL]);
    return 0;
}

const struct argp panel_options_argp = {options, parse_option, NULL, NULL, NULL, NULL, NULL};

bool panel_options_set(const char *origin, const char *name, const char *text)
{
    for (int i = 0; i < KEY_END - KEY_PANEL; i++) {
        if (strcmp(name, setting_names[i]) != 0)
            continue;
        parse(NULL, origin, (enum key)(KEY_PANEL + i), text, &from_file[i]);
        return true;
    }
    return false;
}

/* ---- the panel ---- */

static enum panel_controller controller(void)
{
    return (enum panel_controller)or_usual(KEY_PANEL, PANEL_ST7789);
}

/* The rotation where none is given: upright, unless the size fits a known glass, or the memory, only when turned. */
static uint8_t usual_rotation(uint16_t width, uint16_t height)
{
    struct panel panel;
    for (uint8_t rotation = 0; rotation < 2; rotation++)
        if (panel_defaults(&panel, controller(), rotation, width, height))
            return rotation;
    return controller() != PANEL_SSD1306 && width > PANEL_COLUMNS;
}

static bool usual_panel(struct panel *panel, uint16_t width, uint16_t height)
{
    const int rotation = or_usual(KEY_ROTATION, usual_rotation(width, height));
    return panel_defaults(panel, controller(), (uint8_t)rotation, width, height);
}

static void choose_size(const struct sink_wish *wish, bool any_size, uint16_t *width, uint16_t *height)
{
    struct panel whole;
    const bool turned = or_usual(KEY_ROTATION, 0) % 2, paged = controller() == PANEL_SSD1306;
    const uint16_t rows = controller_rows[controller()];
    *width = paged ? PANEL_PAGED_COLUMNS : turned ? rows : PANEL_COLUMNS;
    *height = !paged && turned ? PANEL_COLUMNS : rows;
    if (wish->width) {
        *width = wish->width;
        *height = wish->height;
    } else if (setting_of(KEY_SIZE)->given) {
        *width = (uint16_t)setting_of(KEY_SIZE)->values[0];
        *height = (uint16_t)setting_of(KEY_SIZE)->values[1];
    } else if (any_size && (usual_panel(&whole, wish->default_width, wish->default_height) || panel_fits(&whole))) {
        *width = wish->default_width;
        *height = wish->default_height;
    }
}

/* Fails with a hint where width and height are exchanged. */
static void check_turn(const struct panel *panel)
{
    struct panel other;
    if (!usual_panel(&other, panel->height, panel->width) || panel->width == panel->height)
        return;
    const char *name = controller_names[panel->controller];
    const bool lying = panel->rotation % 2;
    fail("--size: an %s glass of %ux%u shows %ux%u at --rotation %u; give that --size, or --rotation %s", name,
         lying ? panel->width : panel->height, lying ? panel->height : panel->width, panel->height, panel->width,
         90u * panel->rotation, lying ? "0 or 180" : "90 or 270");
}

void panel_of_options(struct panel *panel, const struct sink_wish *wish, bool any_size)
{
    uint16_t width, height;
    const bool paged = controller() == PANEL_SSD1306;
    if (wish->format >= 0 && (paged ? wish->format != GLINT_MONO : !format_is_565((enum glint_format)wish->format)))
        fail("--format: the panel's pixels are %s, not %s; leave it out", paged ? "mono" : "rgb565",
             format_names[wish->format]);
    if (paged && or_usual(KEY_ROTATION, 0) % 2)
        fail("--rotation: an ssd1306 turns by 0 or 180 only");
    choose_size(wish, any_size, &width, &height);
    const bool known = usual_panel(panel, width, height);
    const char *name = controller_names[panel->controller];
    const struct setting *offset = setting_of(KEY_OFFSET);
    if (!known && !any_size)
        check_turn(panel);
    if (offset->given) {
        panel->x_offset = (uint16_t)offset->values[0];
        panel->y_offset = (uint16_t)offset->values[1];
    }
    if (paged && !panel_fits(panel))
        fail("--size: %ux%u%s does not fit an ssd1306: at most %dx%d, lines a multiple of %d, offset X,0", width,
             height, offset->given ? " at --offset" : "", PANEL_PAGED_COLUMNS, PANEL_PAGED_ROWS, PANEL_PAGE);
    if (!panel_fits(panel))
        fail("--size: %ux%u%s is more than the %dx%d pixels of %s; choose a smaller --size%s%s", width, height,
             offset->given ? " at --offset" : "",
             panel->rotation % 2 ? controller_rows[panel->controller] : PANEL_COLUMNS,
             panel->rotation % 2 ? PANEL_COLUMNS : controller_rows[panel->controller], name,
             offset->given ? " or --offset" : "", any_size ? ", or --to png" : "");
    if (!known && !offset->given && !any_size)
        fail("--size: no %s glass of %ux%u is known; give the place where it begins in the controller's memory: "
             "--offset 0,0, "
             "or as its maker says",
             name, width, height);
    panel->bgr = or_usual(KEY_BGR, panel->bgr);
    panel->inverted = or_usual(KEY_INVERT, panel->inverted);
}
