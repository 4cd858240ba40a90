/* SPDX-License-Identifier: MIT
 * The panel driver: what it sends, when, and what it refuses. */
#include <stdio.h>
#include <string.h>

#include "panel.h"
#include "sinks/panel/options.h"
#include "sinks/panel/virtual_panel.h"
#include "unit.h"

/* ---- a bus that records what happens ---- */

enum kind { COMMAND, DATA, END, RESET, LIGHT, WAIT };
struct happening {
    enum kind kind;
    unsigned value; /* the command, the byte, on or off, ms */
};
static struct happening record[4096];
static size_t happenings, calls, calls_that_work;

static bool happen(enum kind kind, unsigned value)
{
    assert_true(happenings < sizeof record / sizeof *record);
    record[happenings++] = (struct happening){kind, value};
    return true;
}

static bool works(void)
{
    return calls++ < calls_that_work;
}

static bool on_command(void *context, uint8_t command)
{
    (void)context;
    return works() && happen(COMMAND, command);
}

static bool on_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    if (!works())
        return false;
    for (size_t i = 0; i < count; i++)
        happen(DATA, bytes[i]);
    return true;
}

static bool on_reset(void *context, bool active)
{
    (void)context;
    return works() && happen(RESET, active);
}

static bool on_backlight(void *context, uint8_t percent)
{
    (void)context;
    return works() && happen(LIGHT, percent);
}

static void on_wait(void *context, unsigned ms)
{
    (void)context;
    happen(WAIT, ms);
}

static const struct panel_bus bus = {on_command, on_data, NULL, on_reset, on_backlight, on_wait, NULL};
static const struct panel_bus bare_bus = {on_command, on_data, NULL, NULL, NULL, on_wait, NULL};

static struct panel made(const struct panel_bus *on, enum panel_controller controller, unsigned rotation,
                         unsigned width, unsigned height)
{
    struct panel panel = {.bus = on};
    assert_true(panel_defaults(&panel, controller, (uint8_t)rotation, (uint16_t)width, (uint16_t)height));
    happenings = calls = 0;
    calls_that_work = SIZE_MAX;
    return panel;
}

/* The place of an event in the record. */
static size_t place_of(enum kind kind, unsigned value)
{
    for (size_t i = 0; i < happenings; i++)
        if (record[i].kind == kind && record[i].value == value)
            return i;
    fail_msg("%d, %u did not happen", (int)kind, value);
    return 0;
}

static unsigned ms_between(size_t first, size_t last)
{
    unsigned ms = 0;
    for (size_t i = first; i < last; i++)
        ms += record[i].kind == WAIT ? record[i].value : 0;
    return ms;
}

static const unsigned glasses[][3] = {{PANEL_ST7789, 240, 320},  {PANEL_ST7789, 240, 280}, {PANEL_ST7789, 240, 240},
                                      {PANEL_ST7789, 172, 320},  {PANEL_ST7789, 170, 320}, {PANEL_ST7789, 135, 240},
                                      {PANEL_ILI9341, 240, 320}, {PANEL_GC9A01, 240, 240}, {PANEL_SSD1306, 128, 64},
                                      {PANEL_SSD1306, 72, 40}};
enum { GLASSES = sizeof glasses / sizeof *glasses, DCS_GLASSES = GLASSES - 2 };

/* ---- tests ---- */

static void windows_are_where_widely_used_drivers_put_them(void **state)
{
    (void)state;
    static const struct {
        unsigned width, height, starts[4][2];
    } known[] = {{135, 240, {{52, 40}, {40, 53}, {53, 40}, {40, 52}}}, {240, 240, {{0, 0}, {0, 0}, {0, 80}, {80, 0}}},
                 {240, 280, {{0, 20}, {20, 0}, {0, 20}, {20, 0}}},     {170, 320, {{35, 0}, {0, 35}, {35, 0}, {0, 35}}},
                 {172, 320, {{34, 0}, {0, 34}, {34, 0}, {0, 34}}},     {240, 320, {{0, 0}, {0, 0}, {0, 0}, {0, 0}}}};
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        for (unsigned rotation = 0; rotation < 4; rotation++) {
            const unsigned *sides[2] = {&known[i].width, &known[i].height};
            const unsigned width = *sides[rotation % 2], height = *sides[1 - rotation % 2];
            const struct panel panel = made(&bus, PANEL_ST7789, rotation, width, height);
            assert_true(panel_window(&panel, 3, 5, (uint16_t)(width - 3), (uint16_t)(height - 5)));
            const unsigned x = known[i].starts[rotation][0], y = known[i].starts[rotation][1];
            const unsigned wanted[] = {0x2a, 0, x + 3, (x + width - 1) >> 8,  (x + width - 1) & 255,
                                       0x2b, 0, y + 5, (y + height - 1) >> 8, (y + height - 1) & 255,
                                       0x2c};
            assert_int_equal(happenings, sizeof wanted / sizeof *wanted);
            for (size_t k = 0; k < happenings; k++) {
                assert_int_equal(record[k].kind, k % 5 == 0 ? COMMAND : DATA);
                assert_int_equal(record[k].value, wanted[k]);
            }
        }
    }
}

static void the_picture_is_turned_as_widely_used_drivers_turn_it(void **state)
{
    (void)state;
    static const unsigned wanted[2][4] = {{0x00, 0x60, 0xc0, 0xa0}, {0x48, 0x28, 0x88, 0xe8}};
    for (unsigned controller = 0; controller < 2; controller++) {
        for (unsigned rotation = 0; rotation < 4; rotation++) {
            const struct panel panel = made(&bus, (enum panel_controller)controller, rotation, rotation % 2 ? 320 : 240,
                                            rotation % 2 ? 240 : 320);
            assert_true(panel_start(&panel));
            assert_int_equal(record[place_of(COMMAND, PANEL_MADCTL) + 1].value, wanted[controller][rotation]);
        }
    }
}

static void a_start_gives_the_controller_its_time_and_shows_nothing(void **state)
{
    (void)state;
    for (size_t i = 0; i < DCS_GLASSES; i++) {
        const struct panel panel = made(&bus, (enum panel_controller)glasses[i][0], 0, glasses[i][1], glasses[i][2]);
        assert_true(panel_start(&panel));
        const size_t awake = place_of(COMMAND, PANEL_SLEEP_OUT);
        assert_int_equal(place_of(LIGHT, 0), 0);
        assert_true(ms_between(place_of(RESET, 1), place_of(RESET, 0)) >= 1);
        assert_true(ms_between(place_of(RESET, 0), awake) >= 120);
        assert_true(ms_between(awake, happenings) >= 120);
        assert_int_equal(record[place_of(COMMAND, PANEL_PIXEL_FORMAT) + 1].value, 0x55);
        for (size_t k = 0; k < happenings; k++)
            assert_false((record[k].kind == COMMAND && record[k].value == PANEL_DISPLAY_ON) ||
                         (record[k].kind == LIGHT && record[k].value));
    }
}

static void the_backlight_is_on_only_while_the_display_is(void **state)
{
    (void)state;
    const struct panel panel = made(&bus, PANEL_ST7789, 0, 240, 240);
    assert_true(panel_show(&panel, 37));
    assert_true(place_of(LIGHT, 37) > place_of(COMMAND, PANEL_DISPLAY_ON));
    happenings = 0;
    assert_true(panel_stop(&panel));
    assert_true(place_of(LIGHT, 0) < place_of(COMMAND, PANEL_DISPLAY_OFF));
    assert_true(place_of(COMMAND, PANEL_DISPLAY_OFF) < place_of(COMMAND, PANEL_SLEEP_IN));
    assert_true(ms_between(place_of(COMMAND, PANEL_SLEEP_IN), happenings) >= 5);
}

static void the_tearing_line_is_driven_where_it_is_wired(void **state)
{
    (void)state;
    struct panel panel = made(&bus, PANEL_ST7789, 0, 240, 240);
    assert_true(panel_start(&panel));
    for (size_t k = 0; k < happenings; k++)
        assert_false(record[k].kind == COMMAND && record[k].value == 0x35);
    happenings = 0;
    panel.tearing_line = true;
    assert_true(panel_start(&panel));
    const size_t at = place_of(COMMAND, 0x35);
    assert_true(record[at + 1].kind == DATA && record[at + 1].value == 0);
}

/* Command, bytes: what widely used drivers send, whatever their order; -1 ends each. */
/* MADCTL of Adafruit_GC9A01A's four rotations; windows begin at 0, 0 at every turn. */
static void the_gc9a01_turns_as_widely_used_drivers_turn_it(void **state)
{
    (void)state;
    static const unsigned turns[4] = {0x48, 0x28, 0x88, 0xe8};
    for (unsigned rotation = 0; rotation < 4; rotation++) {
        const struct panel panel = made(&bus, PANEL_GC9A01, rotation, 240, 240);
        assert_true(panel_start(&panel));
        assert_int_equal(record[place_of(COMMAND, PANEL_MADCTL) + 1].value, turns[rotation]);
        assert_true(place_of(COMMAND, 0xfe) < place_of(COMMAND, 0xef) &&
                    place_of(COMMAND, 0xef) < place_of(COMMAND, 0x98));
        happenings = 0;
        assert_true(panel_window(&panel, 0, 0, 240, 240));
        const unsigned wanted[] = {0x2a, 0, 0, 0, 239, 0x2b, 0, 0, 0, 239, 0x2c};
        for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++)
            assert_int_equal(record[i].value, wanted[i]);
    }
}

static void the_columns_of_a_round_glass_are_those_that_its_circle_touches(void **state)
{
    (void)state;
    const struct panel panel = made(&bus, PANEL_GC9A01, 0, 240, 240), square = made(&bus, PANEL_ST7789, 0, 240, 240);
    unsigned pixels = 0;
    for (unsigned y = 0; y < 240; y++) {
        const struct panel_columns seen = panel_visible(&panel, y, 1), all = panel_visible(&square, y, 1);
        assert_true(all.first == 0 && all.count == 240);
        for (unsigned x = 0; x < 240; x++) {
            const int across = x < 120 ? 119 - (int)x : (int)x - 120, down = y < 120 ? 119 - (int)y : (int)y - 120;
            assert_int_equal(x >= seen.first && x < seen.first + seen.count, across * across + down * down < 120 * 120);
        }
        pixels += seen.count;
        for (unsigned lines = 2; lines < 20 && y + lines <= 240; lines++) {
            const struct panel_columns band = panel_visible(&panel, y, lines);
            unsigned widest = 0;
            for (unsigned i = 0; i < lines; i++) {
                const struct panel_columns line = panel_visible(&panel, y + i, 1);
                widest = line.count > widest ? line.count : widest;
            }
            assert_int_equal(band.count, widest);
        }
    }
    assert_int_equal(pixels, 45692); /* of 57600 */
}

static bool ends_fail;
static bool on_end(void *context)
{
    (void)context;
    happen(END, 0);
    return !ends_fail;
}
static const struct panel_bus framed_bus = {on_command, on_data, on_end, on_reset, NULL, on_wait, NULL};

static void on_qspi_each_command_is_ended_but_one_that_takes_pixels(void **state)
{
    (void)state;
    const struct panel panel = made(&framed_bus, PANEL_CO5300, 0, 466, 466);
    assert_true(panel_start(&panel));
    size_t commands = 0, ends = 0;
    for (size_t i = 0; i < happenings; i++) {
        commands += record[i].kind == COMMAND;
        ends += record[i].kind == END;
        assert_int_equal(commands - ends, record[i].kind == COMMAND || record[i].kind == DATA);
    }
    assert_true(place_of(COMMAND, PANEL_SLEEP_OUT) > place_of(COMMAND, 0xc4)); /* pixels by four lines */
    happenings = 0;
    assert_true(panel_window(&panel, 4, 8, 40, 2));
    assert_int_equal(record[happenings - 1].kind, COMMAND);
    assert_int_equal(record[2].value, 10); /* columns begin at 6 */
    ends_fail = true;
    assert_false(panel_window(&panel, 4, 8, 40, 2) || panel_start(&panel) || panel_stop(&panel));
    ends_fail = false;
}

static void glass_that_emits_light_is_dark_until_it_is_shown_and_as_bright_as_told(void **state)
{
    (void)state;
    const struct panel panel = made(&framed_bus, PANEL_CO5300, 0, 466, 466);
    assert_true(panel_start(&panel));
    assert_int_equal(record[place_of(COMMAND, PANEL_BRIGHTNESS) + 1].value, 0);
    static const unsigned levels[][2] = {{1, 2}, {50, 127}, {100, 255}, {0, 0}};
    for (unsigned i = 0; i < 4; i++) {
        happenings = 0;
        assert_true(panel_show(&panel, (uint8_t)levels[i][0]));
        assert_int_equal(record[place_of(COMMAND, PANEL_BRIGHTNESS) + 1].value, levels[i][1]);
        (void)place_of(COMMAND, levels[i][0] ? PANEL_DISPLAY_ON : PANEL_DISPLAY_OFF);
    }
}

static void odd_windows_and_small_ones_are_refused_on_qspi_and_send_nothing(void **state)
{
    (void)state;
    struct panel panel = made(&framed_bus, PANEL_CO5300, 0, 466, 466);
    static const uint16_t bad[][4] = {{1, 0, 40, 2}, {0, 1, 40, 2}, {0, 0, 41, 2},
                                      {0, 0, 40, 3}, {0, 0, 16, 2}, {0, 0, 2, 16}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_false(panel_window(&panel, bad[i][0], bad[i][1], bad[i][2], bad[i][3]));
    assert_int_equal(happenings, 0);
    assert_true(panel_window(&panel, 0, 0, 18, 2) && panel_window(&panel, 464, 430, 2, 36)); /* 72 bytes */
    panel.x_offset++;
    assert_false(panel_fits(&panel));
    panel.x_offset--;
    panel.round = false;
    panel.width--;
    assert_false(panel_fits(&panel));
    for (unsigned rotation = 1; rotation < 4; rotation++)
        assert_false(panel_defaults(&panel, PANEL_CO5300, (uint8_t)rotation, 466, 466));
}

static void bands_of_an_even_round_glass_hold_the_circle_and_are_even(void **state)
{
    (void)state;
    const struct panel panel = made(&framed_bus, PANEL_CO5300, 0, 466, 466);
    unsigned pixels = 0, first;
    for (unsigned y = 0; y < 466; y += panel_band(&panel, y)) {
        const unsigned lines = panel_band(&panel, y);
        const struct panel_columns seen = panel_visible(&panel, y, lines);
        for (unsigned row = y; row < y + lines; row++) {
            const int down = row < 233 ? 232 - (int)row : (int)row - 233;
            for (first = 0; (232 - (int)first) * (232 - (int)first) + down * down >= 233 * 233;)
                first++;
            assert_true(seen.first <= first);
        }
        assert_true(panel_window(&panel, seen.first, (uint16_t)y, seen.count, (uint16_t)lines));
        pixels += seen.count * lines;
        happenings = 0;
    }
    assert_int_equal(pixels, 174620); /* of 217156 */
}

static void around_a_picture_in_the_middle_the_glass_is_black(void **state)
{
    (void)state;
    static struct virtual_panel screen;
    static uint8_t seen[466 * 466 * 3];
    struct panel panel = {0};
    assert_true(panel_defaults(&panel, PANEL_CO5300, 0, 466, 466));
    const struct virtual_glass glass = virtual_glass_of(&panel);
    virtual_panel_init(&screen, &glass);
    const struct panel_bus on = virtual_panel_bus(&screen);
    assert_true(panel_defaults(&panel, PANEL_CO5300, 0, 240, 240) && !panel.round);
    panel.bus = &on;
    assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST) && panel_window(&panel, 0, 0, 240, 240));
    for (unsigned i = 0; i < 240 * 240; i++)
        assert_true(on.data(on.context, (const uint8_t *)"\xff\xff", 2));
    virtual_panel_look(&screen, 0, seen);
    for (unsigned y = 0; y < 466; y++)
        for (unsigned x = 0; x < 466; x++)
            assert_int_equal(seen[3 * (466 * y + x)], x >= 112 && x < 352 && y >= 112 && y < 352 ? 255 : 0);
}

static void a_round_glass_that_is_no_square_is_refused(void **state)
{
    (void)state;
    struct panel panel = made(&bus, PANEL_GC9A01, 0, 240, 240);
    assert_true(panel.round && panel_fits(&panel));
    panel.height = 200;
    assert_false(panel_fits(&panel));
}

/* Each: a command and its bytes, then -1. After the last one comes what all get. */
static void assert_gets(const struct panel *panel, const int16_t (*values)[17], size_t count)
{
    assert_true(panel_start(panel));
    size_t at = 0;
    for (size_t i = 0; i < count; i++) {
        at = place_of(COMMAND, (unsigned)values[i][0]);
        for (const int16_t *byte = values[i] + 1; *byte >= 0; byte++) {
            assert_int_equal(record[++at].kind, DATA);
            assert_int_equal(record[at].value, *byte);
        }
        assert_int_not_equal(record[at + 1].kind, DATA);
    }
    while (record[++at].kind != COMMAND)
        assert_int_equal(record[at].kind, END);
    assert_int_equal(record[at].value, PANEL_PIXEL_FORMAT);
}

static void the_co5300_gets_its_page_its_four_lines_and_its_brightness(void **state)
{
    (void)state;
    static const int16_t values[][17] = {{0xfe, 0, -1}, {0xc4, 0x80, -1}, {0x53, 0x20, -1}, {0x51, 0, -1}};
    const struct panel panel = made(&framed_bus, PANEL_CO5300, 0, 466, 466);
    assert_gets(&panel, values, sizeof values / sizeof *values);
}

/* Those of Adafruit_GC9A01A, and 0x70 of Waveshare's driver. */
static void the_gc9a01_gets_the_values_of_its_makers_glass(void **state)
{
    (void)state;
    static const int16_t values[][17] = {
        {0xeb, 0x14, -1},
        {0x84, 0x40, -1},
        {0x85, 0xff, -1},
        {0x86, 0xff, -1},
        {0x87, 0xff, -1},
        {0x88, 0x0a, -1},
        {0x89, 0x21, -1},
        {0x8a, 0, -1},
        {0x8b, 0x80, -1},
        {0x8c, 1, -1},
        {0x8d, 1, -1},
        {0x8e, 0xff, -1},
        {0x8f, 0xff, -1},
        {0xb6, 0, 0, -1},
        {0x90, 8, 8, 8, 8, -1},
        {0xbd, 6, -1},
        {0xbc, 0, -1},
        {0xff, 0x60, 1, 4, -1},
        {0xc3, 0x13, -1},
        {0xc4, 0x13, -1},
        {0xc9, 0x22, -1},
        {0xbe, 0x11, -1},
        {0xe1, 0x10, 0x0e, -1},
        {0xdf, 0x21, 0x0c, 2, -1},
        {0xf0, 0x45, 9, 8, 8, 0x26, 0x2a, -1},
        {0xf1, 0x43, 0x70, 0x72, 0x36, 0x37, 0x6f, -1},
        {0xf2, 0x45, 9, 8, 8, 0x26, 0x2a, -1},
        {0xf3, 0x43, 0x70, 0x72, 0x36, 0x37, 0x6f, -1},
        {0xed, 0x1b, 0x0b, -1},
        {0xae, 0x77, -1},
        {0xcd, 0x63, -1},
        {0x70, 7, 7, 4, 0x0e, 0x0f, 9, 7, 8, 3, -1},
        {0xe8, 0x34, -1},
        {0x62, 0x18, 0x0d, 0x71, 0xed, 0x70, 0x70, 0x18, 0x0f, 0x71, 0xef, 0x70, 0x70, -1},
        {0x63, 0x18, 0x11, 0x71, 0xf1, 0x70, 0x70, 0x18, 0x13, 0x71, 0xf3, 0x70, 0x70, -1},
        {0x64, 0x28, 0x29, 0xf1, 1, 0xf1, 0, 7, -1},
        {0x66, 0x3c, 0, 0xcd, 0x67, 0x45, 0x45, 0x10, 0, 0, 0, -1},
        {0x67, 0, 0x3c, 0, 0, 0, 1, 0x54, 0x10, 0x32, 0x98, -1},
        {0x74, 0x10, 0x85, 0x80, 0, 0, 0x4e, 0, -1},
        {0x98, 0x3e, 7, -1}};
    const struct panel panel = made(&bus, PANEL_GC9A01, 0, 240, 240);
    assert_gets(&panel, values, sizeof values / sizeof *values);
}

static void the_ili9341_gets_its_voltages_and_gamma_curves(void **state)
{
    (void)state;
    static const int16_t values[][17] = {{0xcb, 0x39, 0x2c, 0, 0x34, 2, -1},
                                         {0xcf, 0, 0xc1, 0x30, -1},
                                         {0xe8, 0x85, 0, 0x78, -1},
                                         {0xed, 0x64, 3, 0x12, 0x81, -1},
                                         {0xea, 0, 0, -1},
                                         {0xf7, 0x20, -1},
                                         {0xc0, 0x23, -1},
                                         {0xc1, 0x10, -1},
                                         {0xc5, 0x3e, 0x28, -1},
                                         {0xc7, 0x86, -1},
                                         {0xb1, 0, 27, -1},
                                         {0xb6, 8, 0x82, 0x27, -1},
                                         {0xf2, 0, -1},
                                         {0xe0, 15, 49, 43, 12, 14, 8, 78, 241, 55, 7, 16, 3, 14, 9, 0, -1},
                                         {0xe1, 0, 14, 20, 3, 17, 7, 49, 193, 72, 8, 15, 12, 49, 54, 15, -1}};
    const struct panel panel = made(&bus, PANEL_ILI9341, 0, 240, 320);
    assert_gets(&panel, values, sizeof values / sizeof *values);
}

static void without_a_reset_line_the_command_resets(void **state)
{
    (void)state;
    const struct panel panel = made(&bare_bus, PANEL_ILI9341, 1, 320, 240);
    assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST) && panel_stop(&panel));
    assert_int_equal(place_of(COMMAND, PANEL_SOFTWARE_RESET), 0);
    assert_true(ms_between(0, place_of(COMMAND, PANEL_SLEEP_OUT)) >= 120);
}

static void a_bus_that_fails_at_any_call_fails_the_panel(void **state)
{
    (void)state;
    for (size_t i = 0; i < 2 * GLASSES; i++) {
        const unsigned *glass = glasses[i / 2];
        struct panel panel = made(i % 2 ? &bare_bus : &bus, (enum panel_controller)glass[0], 0, glass[1], glass[2]);
        panel.tearing_line = i / 2 % 2;
        size_t whole = SIZE_MAX;
        for (size_t limit = 0; limit <= whole; limit++) {
            calls = happenings = 0;
            calls_that_work = limit;
            const bool good = panel_start(&panel) && panel_window(&panel, 0, 0, 1, panel_is_paged(&panel) ? 8 : 1) &&
                              panel_show(&panel, PANEL_BRIGHTEST) && panel_stop(&panel);
            assert_int_equal(good, limit == whole || calls <= limit);
            assert_true(calls <= limit + 1); /* nothing is sent after a failure */
            if (good)
                whole = limit;
        }
        assert_true(whole > 10);
    }
}

static void a_bus_that_fails_while_glass_is_made_black_fails_the_start(void **state)
{
    (void)state;
    struct panel panel = made(&bus, PANEL_CO5300, 0, 240, 240);
    for (size_t limit = 0; limit < 60; limit++) { /* of 13,600 and more */
        calls = happenings = 0;
        calls_that_work = limit;
        assert_false(panel_start(&panel));
        assert_int_equal(calls, limit + 1);
    }
}

static void a_bus_that_fails_in_any_page_fails_the_pages(void **state)
{
    (void)state;
    const uint8_t lines[64 * 16] = {0};
    const struct panel panel = made(&bus, PANEL_SSD1306, 0, 128, 64);
    assert_true(panel_mono(&panel, lines, 16, 0, 9, 30, 9));
    const size_t whole = calls;
    for (size_t limit = 0; limit < whole; limit++) {
        calls = happenings = 0;
        calls_that_work = limit;
        assert_false(panel_mono(&panel, lines, 16, 0, 9, 30, 9));
        assert_int_equal(calls, limit + 1);
    }
}

/* ---- the SSD1306 ---- */

static void commands_are(const uint8_t *wanted, size_t count, size_t from)
{
    for (size_t i = 0; i < count; i++) {
        assert_int_equal(record[from + i].kind, COMMAND);
        assert_int_equal(record[from + i].value, wanted[i]);
    }
}

static void an_ssd1306_gets_its_addresses_as_commands_and_its_pixels_in_pages(void **state)
{
    (void)state;
    uint8_t lines[64][16];
    for (unsigned i = 0; i < sizeof lines; i++)
        lines[i / 16][i % 16] = (uint8_t)(i * i * 7 + i);
    for (unsigned rotation = 0; rotation < 4; rotation += 2) {
        const struct panel panel = made(&bus, PANEL_SSD1306, rotation, 72, 40);
        assert_true(panel_start(&panel));
        assert_true(place_of(COMMAND, rotation ? 0xa0 : 0xa1) < place_of(COMMAND, 0x8d));
        assert_true(place_of(COMMAND, rotation ? 0xc0 : 0xc8) < place_of(COMMAND, 0x8d));
        happenings = 0;
        /* lines 9 to 17 are of pages 1 and 2 */
        assert_true(panel_mono(&panel, lines[0], 16, 5, 9, 30, 9));
        const uint8_t window[] = {0x21, 28 + 5, 28 + 34, 0x22, 1, 2};
        commands_are(window, sizeof window, 0);
        assert_int_equal(happenings, sizeof window + 60);
        for (unsigned page = 0; page < 2; page++)
            for (unsigned x = 5; x < 35; x++) {
                const struct happening *byte = &record[sizeof window + 30 * page + x - 5];
                assert_int_equal(byte->kind, DATA);
                for (unsigned bit = 0; bit < 8; bit++)
                    assert_int_equal(byte->value >> bit & 1, lines[8 + 8 * page + bit][x / 8] >> (7 - x % 8) & 1);
            }
        happenings = 0;
        assert_true(panel_show(&panel, PANEL_BRIGHTEST) && panel_stop(&panel));
        assert_true(place_of(COMMAND, 0xaf) < place_of(COMMAND, 0xae));
    }
}

static void an_ssd1306_of_32_rows_has_their_pins_and_one_that_is_inverted_is_told(void **state)
{
    (void)state;
    struct panel panel = made(&bare_bus, PANEL_SSD1306, 0, 128, 32);
    panel.inverted = true;
    assert_true(panel_start(&panel));
    assert_int_equal(record[place_of(COMMAND, 0xda) + 1].value, 0x02);
    assert_true(place_of(COMMAND, 0xa7) > place_of(COMMAND, 0xa4));
    panel = made(&bus, PANEL_SSD1306, 0, 128, 64);
    assert_true(panel_start(&panel));
    assert_int_equal(record[place_of(COMMAND, 0xda) + 1].value, 0x12);
    assert_true(place_of(COMMAND, 0xa6) > place_of(COMMAND, 0xa4));
}

/* The glass of 72x40 has no resistor that sets its current. */
static void an_ssd1306_sets_its_current_by_itself_on_glass_of_72x40_alone(void **state)
{
    (void)state;
    static const unsigned sizes[][2] = {{128, 64}, {128, 32}, {72, 40}, {64, 48}};
    for (unsigned i = 0; i < 8; i++) {
        const unsigned width = sizes[i / 2][0];
        const struct panel panel = made(&bus, PANEL_SSD1306, i % 2 * 2, width, sizes[i / 2][1]);
        unsigned found = 0;
        assert_true(panel_start(&panel));
        for (size_t at = 0; at + 1 < happenings; at++)
            found += record[at].kind == COMMAND && record[at].value == 0xad && record[at + 1].value == 0x30;
        assert_int_equal(found, width == 72);
    }
}

static void an_ssd1306_takes_whole_pages_and_half_turns_alone(void **state)
{
    (void)state;
    const uint8_t lines[64 * 16] = {0};
    struct panel panel = made(&bus, PANEL_SSD1306, 0, 128, 64);
    assert_false(panel_window(&panel, 0, 4, 8, 8));
    assert_false(panel_window(&panel, 0, 8, 8, 4));
    assert_false(panel_mono(&panel, lines, 16, 0, 60, 8, 5));
    assert_false(panel_mono(&panel, lines, 16, 0, 0, 129, 8));
    assert_false(panel_mono(&panel, lines, 16, 0, 0, 8, 0));
    assert_int_equal(happenings, 0);
    assert_true(panel_mono(&panel, lines, 16, 120, 63, 8, 1));
    static const struct panel wrong[] = {
        {.controller = PANEL_SSD1306, .width = 0, .height = 64},
        {.controller = PANEL_SSD1306, .width = 128, .height = 0},
        {.controller = PANEL_SSD1306, .width = 128, .height = 72},
        {.controller = PANEL_SSD1306, .width = 129, .height = 64},
        {.controller = PANEL_SSD1306, .width = 128, .height = 56, .y_offset = 8},
        {.controller = PANEL_SSD1306, .width = 128, .height = 64, .rotation = 4},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++)
        assert_false(panel_fits(&wrong[i]));
    panel.rotation = 1;
    assert_false(panel_fits(&panel));
    panel.rotation = 0;
    panel.height = 60;
    assert_false(panel_fits(&panel));
    panel.height = 64;
    panel.x_offset = 1;
    assert_false(panel_fits(&panel));
    const struct panel other = made(&bus, PANEL_ST7789, 0, 240, 240);
    assert_false(panel_mono(&other, lines, 16, 0, 0, 8, 8));
    assert_false(panel_defaults(&panel, PANEL_SSD1306, 1, 128, 64));
}

static void windows_beyond_the_picture_are_refused_and_send_nothing(void **state)
{
    (void)state;
    const struct panel panel = made(&bus, PANEL_ST7789, 1, 240, 135);
    static const uint16_t bad[][4] = {{0, 0, 0, 1},     {0, 0, 1, 0},     {0, 0, 241, 1},      {0, 0, 1, 136},
                                      {240, 0, 1, 1},   {0, 135, 1, 1},   {1, 0, 240, 1},      {0, 1, 1, 135},
                                      {65535, 0, 2, 1}, {0, 65535, 1, 2}, {1, 1, 65535, 65535}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_false(panel_window(&panel, bad[i][0], bad[i][1], bad[i][2], bad[i][3]));
    assert_int_equal(happenings, 0);
    assert_true(panel_window(&panel, 239, 134, 1, 1));
}

static void a_panel_that_is_unknown_or_does_not_fit_is_refused(void **state)
{
    (void)state;
    struct panel panel = {.bus = &bus};
    assert_false(panel_defaults(&panel, PANEL_ST7789, 0, 320, 240)); /* lying, unturned */
    assert_false(panel_fits(&panel));
    assert_false(panel_start(&panel));
    assert_false(panel_defaults(&panel, PANEL_ILI9341, 0, 240, 240));
    assert_false(panel_defaults(&panel, PANEL_ST7789, 1, 160, 128));
    assert_true(panel_fits(&panel)); /* an offset of its own makes it fit, and it starts, whatever its glass is */
    calls_that_work = SIZE_MAX;
    assert_true(panel_start(&panel));
    panel.x_offset = PANEL_COLUMNS - 128;
    assert_true(panel_fits(&panel));
    panel.x_offset++;
    assert_false(panel_fits(&panel));
    assert_false(panel_defaults(&panel, PANEL_ST7789, 4, 240, 320));
    assert_false(panel_fits(&panel));
    assert_false(panel_defaults(&panel, PANEL_CONTROLLERS, 0, 240, 320));
    assert_false(panel_fits(&panel));
    assert_true(panel_defaults(&panel, PANEL_ST7789, 0, 240, 240));
    panel.y_offset = PANEL_ROWS - 240;
    assert_true(panel_fits(&panel));
    panel.y_offset++;
    assert_false(panel_fits(&panel));
    panel.y_offset = 0;
    panel.width = 0;
    assert_false(panel_fits(&panel));
    panel.width = 240;
    panel.height = 0;
    assert_false(panel_fits(&panel));
}

static void colour_order_and_inversion_are_as_given_else_the_controllers_usual_ones(void **state)
{
    (void)state;
    const struct sink_wish wish = {.width = 240, .height = 240, .format = -1};
    struct panel panel = {.bgr = true}; /* what was there is gone */
    panel_of_options(&panel, &wish, false);
    assert_true(panel.inverted && !panel.bgr);
    assert_true(panel_options_set("pins.ini:1", "invert", "no") && panel_options_set("pins.ini:2", "bgr", "yes"));
    panel_of_options(&panel, &wish, false);
    assert_true(!panel.inverted && panel.bgr);
    assert_false(panel_options_set("pins.ini:3", "contrast", "no"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(windows_are_where_widely_used_drivers_put_them),
        cmocka_unit_test(the_picture_is_turned_as_widely_used_drivers_turn_it),
        cmocka_unit_test(a_start_gives_the_controller_its_time_and_shows_nothing),
        cmocka_unit_test(the_backlight_is_on_only_while_the_display_is),
        cmocka_unit_test(the_tearing_line_is_driven_where_it_is_wired),
        cmocka_unit_test(the_co5300_gets_its_page_its_four_lines_and_its_brightness),
        cmocka_unit_test(the_gc9a01_gets_the_values_of_its_makers_glass),
        cmocka_unit_test(the_gc9a01_turns_as_widely_used_drivers_turn_it),
        cmocka_unit_test(the_columns_of_a_round_glass_are_those_that_its_circle_touches),
        cmocka_unit_test(on_qspi_each_command_is_ended_but_one_that_takes_pixels),
        cmocka_unit_test(glass_that_emits_light_is_dark_until_it_is_shown_and_as_bright_as_told),
        cmocka_unit_test(odd_windows_and_small_ones_are_refused_on_qspi_and_send_nothing),
        cmocka_unit_test(bands_of_an_even_round_glass_hold_the_circle_and_are_even),
        cmocka_unit_test(around_a_picture_in_the_middle_the_glass_is_black),
        cmocka_unit_test(a_round_glass_that_is_no_square_is_refused),
        cmocka_unit_test(the_ili9341_gets_its_voltages_and_gamma_curves),
        cmocka_unit_test(without_a_reset_line_the_command_resets),
        cmocka_unit_test(a_bus_that_fails_at_any_call_fails_the_panel),
        cmocka_unit_test(a_bus_that_fails_while_glass_is_made_black_fails_the_start),
        cmocka_unit_test(a_bus_that_fails_in_any_page_fails_the_pages),
        cmocka_unit_test(an_ssd1306_gets_its_addresses_as_commands_and_its_pixels_in_pages),
        cmocka_unit_test(an_ssd1306_of_32_rows_has_their_pins_and_one_that_is_inverted_is_told),
        cmocka_unit_test(an_ssd1306_sets_its_current_by_itself_on_glass_of_72x40_alone),
        cmocka_unit_test(an_ssd1306_takes_whole_pages_and_half_turns_alone),
        cmocka_unit_test(windows_beyond_the_picture_are_refused_and_send_nothing),
        cmocka_unit_test(a_panel_that_is_unknown_or_does_not_fit_is_refused),
        cmocka_unit_test(colour_order_and_inversion_are_as_given_else_the_controllers_usual_ones),
    };
    return cmocka_run_group_tests_name("panel", tests, NULL, NULL);
}
