/* SPDX-License-Identifier: MIT
 * The virtual panel, and panel.c seen through it: what the eye sees of what was drawn. */
#include <stdlib.h>
#include <string.h>

#include "sinks/panel/virtual_panel.h"
#include "unit.h"

/* As modules are sold: the place of the glass in the memory, and its wiring, by hand. */
static const struct module {
    enum panel_controller controller;
    struct virtual_glass glass;
} modules[] = {
    {PANEL_ST7789, {240, 320, 0, 0, false, false, true, false, false, 0, 0, false}},
    {PANEL_ST7789, {240, 280, 0, 20, false, false, true, false, false, 0, 0, false}},
    {PANEL_ST7789, {240, 240, 0, 0, false, false, true, false, false, 0, 0, false}},
    {PANEL_ST7789, {172, 320, 34, 0, false, false, true, false, false, 0, 0, false}},
    {PANEL_ST7789, {170, 320, 35, 0, false, false, true, false, false, 0, 0, false}},
    {PANEL_ST7789, {135, 240, 52, 40, false, false, true, false, false, 0, 0, false}},
    {PANEL_ILI9341, {240, 320, 0, 0, true, true, false, false, false, 0, 0, false}},
    {PANEL_GC9A01, {240, 240, 0, 0, true, true, true, false, false, 240, 0, false}},
};
enum { MODULES = sizeof modules / sizeof *modules, PIXELS = PANEL_COLUMNS * PANEL_ROWS };

static struct virtual_panel screen; /* 150 KB: not for the stack */
static struct panel_bus bus;
static uint8_t seen[PIXELS * 3], wanted[PIXELS * 3], sent[PIXELS * 2];

static uint32_t noise_state = 1;
static uint32_t noise(void) /* xorshift32 */
{
    noise_state ^= noise_state << 13;
    noise_state ^= noise_state >> 17;
    noise_state ^= noise_state << 5;
    return noise_state;
}

/* The panel on a module of its own, awake and shown. */
static struct panel started(const struct module *module, unsigned rotation)
{
    virtual_panel_init(&screen, &module->glass);
    bus = virtual_panel_bus(&screen);
    struct panel panel = {.bus = &bus};
    const uint16_t sides[] = {module->glass.width, module->glass.height};
    assert_true(
        panel_defaults(&panel, module->controller, (uint8_t)rotation, sides[rotation % 2], sides[1 - rotation % 2]));
    assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST));
    return panel;
}

/* Draws a rectangle of noise, in pieces of odd lengths, and notes what it should look like. */
static void draw(const struct panel *panel, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    const size_t bytes = (size_t)width * height * 2;
    for (size_t i = 0; i < bytes; i += 2) {
        const unsigned color = noise() & 0xffff, column = x + (unsigned)(i / 2) % width;
        const unsigned row = y + (unsigned)(i / 2) / width;
        sent[i] = (uint8_t)(color >> 8);
        sent[i + 1] = (uint8_t)color;
        uint8_t *rgb = &wanted[3 * ((size_t)row * panel->width + column)];
        rgb[0] = (uint8_t)((color >> 11) * 255.0 / 31 + .5);
        rgb[1] = (uint8_t)((color >> 5 & 63) * 255.0 / 63 + .5);
        rgb[2] = (uint8_t)((color & 31) * 255.0 / 31 + .5);
    }
    assert_true(panel_window(panel, x, y, width, height));
    for (size_t at = 0; at < bytes;) {
        const size_t step = noise() % 777 + 1, count = step < bytes - at ? step : bytes - at;
        assert_true(bus.data(bus.context, &sent[at], count));
        at += count;
    }
}

static void assert_seen(const struct panel *panel)
{
    virtual_panel_look(&screen, panel->rotation, seen);
    assert_memory_equal(seen, wanted, (size_t)panel->width * panel->height * 3);
}

static void assert_black(const struct panel *panel)
{
    virtual_panel_look(&screen, panel->rotation, seen);
    for (size_t i = 0; i < (size_t)panel->width * panel->height * 3; i++)
        assert_int_equal(seen[i], 0);
}

/* ---- tests ---- */

static void every_glass_shows_every_rotation_upright_and_in_its_colours(void **state)
{
    (void)state;
    for (size_t i = 0; i < MODULES; i++) {
        for (unsigned rotation = 0; rotation < 4; rotation++) {
            const struct panel panel = started(&modules[i], rotation);
            draw(&panel, 0, 0, panel.width, panel.height);
            assert_seen(&panel);
        }
    }
}

static void windows_change_their_own_pixels_only(void **state)
{
    (void)state;
    for (size_t i = 0; i < MODULES; i++) {
        for (unsigned rotation = 0; rotation < 4; rotation++) {
            const struct panel panel = started(&modules[i], rotation);
            draw(&panel, 0, 0, panel.width, panel.height);
            for (int k = 0; k < 20; k++) {
                const uint16_t x = (uint16_t)(noise() % panel.width), y = (uint16_t)(noise() % panel.height);
                draw(&panel, x, y, (uint16_t)(noise() % (panel.width - x) + 1u),
                     (uint16_t)(noise() % (panel.height - y) + 1u));
            }
            draw(&panel, (uint16_t)(panel.width - 1), (uint16_t)(panel.height - 1), 1, 1);
            assert_seen(&panel);
        }
    }
}

static void a_glass_that_the_panel_tells_of_is_the_module_s_own(void **state)
{
    (void)state;
    for (size_t i = 0; i < MODULES; i++) {
        for (unsigned rotation = 0; rotation < 4; rotation++) {
            const struct panel panel = started(&modules[i], rotation);
            const struct virtual_glass told = virtual_glass_of(&panel), *own = &modules[i].glass;
            assert_true(told.width == own->width && told.height == own->height && told.x == own->x && told.y == own->y);
            assert_true(told.mirrored == own->mirrored && told.bgr == own->bgr && told.inverted == own->inverted);
        }
    }
}

static void an_unturned_picture_begins_at_the_top_left_of_the_glass(void **state)
{
    (void)state;
    /* A quarter turn clockwise takes its first pixel to the top right, then to the bottom right, then to the bottom left. */
    for (size_t i = 0; i < MODULES; i++) {
        const size_t right = modules[i].glass.width - 1u, bottom = modules[i].glass.height - 1u, width = right + 1;
        const size_t corners[4] = {0, right, bottom * width + right, bottom * width};
        for (unsigned rotation = 0; rotation < 4; rotation++) {
            const struct panel panel = started(&modules[i], rotation);
            memset(sent, 0, sizeof sent);
            assert_true(panel_window(&panel, 0, 0, panel.width, panel.height));
            virtual_panel_data(&screen, sent, (size_t)panel.width * panel.height * 2);
            assert_true(panel_window(&panel, 0, 0, 1, 1));
            virtual_panel_data(&screen, (const uint8_t[]){0xff, 0xff}, 2);
            virtual_panel_look(&screen, 0, seen);
            for (size_t k = 0; k < width * (bottom + 1); k++)
                assert_int_equal(seen[3 * k], k == corners[rotation] ? 255 : 0);
        }
    }
}

static void nothing_is_seen_before_it_is_shown_nor_after_a_stop(void **state)
{
    (void)state;
    for (size_t i = 0; i < MODULES; i++) {
        virtual_panel_init(&screen, &modules[i].glass);
        bus = virtual_panel_bus(&screen);
        struct panel panel = {.bus = &bus};
        panel_defaults(&panel, modules[i].controller, 0, modules[i].glass.width, modules[i].glass.height);
        assert_black(&panel);
        assert_true(panel_start(&panel));
        draw(&panel, 0, 0, panel.width, panel.height);
        assert_black(&panel);
        assert_true(panel_show(&panel, PANEL_BRIGHTEST));
        assert_seen(&panel);
        assert_true(panel_stop(&panel));
        assert_black(&panel);
    }
}

static void a_panel_recovers_after_bytes_that_were_cut_off(void **state)
{
    (void)state;
    for (size_t cut = 0; cut < 12; cut++) {
        struct panel panel = started(&modules[0], 1);
        assert_true(panel_window(&panel, 0, 0, panel.width, panel.height));
        virtual_panel_data(&screen, sent, cut);
        assert_true(panel_stop(&panel));
        assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST));
        draw(&panel, 0, 0, panel.width, panel.height);
        assert_seen(&panel);
    }
}

/* Straight to the controller, 240x320 unturned, RGB565, nothing inverted. */
static void bare(void)
{
    virtual_panel_init(&screen, &(struct virtual_glass){.width = PANEL_COLUMNS, .height = PANEL_ROWS});
    virtual_panel_command(&screen, PANEL_PIXEL_FORMAT);
    virtual_panel_data(&screen, (const uint8_t[]){0x55}, 1);
}

static void range(uint8_t command, unsigned first, unsigned last)
{
    virtual_panel_command(&screen, command);
    virtual_panel_data(
        &screen, (const uint8_t[]){(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last}, 4);
}

static void pixels(uint8_t command, unsigned first, unsigned count)
{
    virtual_panel_command(&screen, command);
    for (unsigned i = 0; i < count; i++)
        virtual_panel_data(&screen, (const uint8_t[]){(uint8_t)((first + i) >> 8), (uint8_t)(first + i)}, 2);
}

static void pixels_beyond_the_window_s_last_begin_it_again(void **state)
{
    (void)state;
    bare();
    range(PANEL_COLUMN_ADDRESS, 10, 12);
    range(PANEL_ROW_ADDRESS, 300, 301);
    pixels(PANEL_MEMORY_WRITE, 1, 8); /* two more than it holds */
    static const uint16_t rows[2][3] = {{7, 8, 3}, {4, 5, 6}};
    for (int row = 0; row < 2; row++)
        assert_memory_equal(&screen.memory[300 + row][10], rows[row], sizeof rows[row]);
    assert_int_not_equal(screen.memory[302][10], 7);
    assert_int_not_equal(screen.memory[300][13], 8);
}

static void a_write_that_is_continued_goes_on_where_it_stopped(void **state)
{
    (void)state;
    bare();
    range(PANEL_COLUMN_ADDRESS, 0, 1);
    range(PANEL_ROW_ADDRESS, 0, 9);
    pixels(PANEL_MEMORY_WRITE, 1, 3);
    virtual_panel_data(&screen, (const uint8_t[]){9}, 1); /* half a pixel, which the next command drops */
    pixels(PANEL_MEMORY_CONTINUE, 4, 2);
    assert_int_equal(screen.memory[1][1], 4);
    assert_int_equal(screen.memory[2][0], 5);
    pixels(PANEL_MEMORY_WRITE, 11, 1);
    assert_int_equal(screen.memory[0][0], 11);
}

static void a_window_whose_end_is_before_its_start_changes_nothing(void **state)
{
    (void)state;
    bare();
    range(PANEL_COLUMN_ADDRESS, 5, 6);
    range(PANEL_ROW_ADDRESS, 7, 8);
    range(PANEL_COLUMN_ADDRESS, 6, 5);
    range(PANEL_ROW_ADDRESS, 100, 99);
    pixels(PANEL_MEMORY_WRITE, 1, 4);
    assert_int_equal(screen.memory[7][5], 1);
    assert_int_equal(screen.memory[8][6], 4);
}

static void pixels_outside_the_memory_are_dropped(void **state)
{
    (void)state;
    bare();
    range(PANEL_COLUMN_ADDRESS, 239, 240);
    range(PANEL_ROW_ADDRESS, 319, 65535);
    pixels(PANEL_MEMORY_WRITE, 1, 5);
    assert_int_equal(screen.memory[319][239], 1);
}

static void after_a_reset_a_pixel_is_three_bytes(void **state)
{
    (void)state;
    bare();
    virtual_panel_command(&screen, PANEL_SOFTWARE_RESET);
    virtual_panel_command(&screen, PANEL_MEMORY_WRITE);
    virtual_panel_data(&screen, (const uint8_t[]){0xf8, 0x04, 0x08, 0, 0xfc, 0}, 6);
    assert_int_equal(screen.memory[0][0], 31 << 11 | 1 << 5 | 1);
    assert_int_equal(screen.memory[0][1], 63 << 5);
}

static void wrong_wiring_is_seen(void **state)
{
    (void)state;
    struct panel panel = started(&modules[0], 0);
    panel.inverted = false;
    assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST));
    assert_true(panel_window(&panel, 0, 0, 1, 1));
    virtual_panel_data(&screen, (const uint8_t[]){0xf8, 0x00}, 2); /* red */
    virtual_panel_look(&screen, 0, seen);
    assert_memory_equal(seen, ((const uint8_t[]){0, 255, 255}), 3);
    panel.inverted = true;
    panel.bgr = true;
    assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST));
    virtual_panel_look(&screen, 0, seen);
    assert_memory_equal(seen, ((const uint8_t[]){0, 0, 255}), 3);
}

/* Commands are few among 256: half of them are drawn from those that the panel knows. */
static void any_bytes_in_any_order_are_taken(void **state)
{
    (void)state;
    static const uint8_t known[] = {0x01, 0x11, 0x20, 0x21, 0x29, 0x2a, 0x2b, 0x2c, 0x36, 0x3a, 0x3c};
    static uint8_t bytes[512];
    for (size_t i = 0; i < MODULES; i++) {
        virtual_panel_init(&screen, &modules[i].glass);
        for (int k = 0; k < 20000; k++) {
            const uint32_t draw_of = noise();
            virtual_panel_command(&screen, draw_of % 2 ? known[draw_of / 2 % sizeof known] : (uint8_t)(draw_of >> 8));
            const size_t count = noise() % (k % 16 ? 6 : sizeof bytes);
            for (size_t at = 0; at < count; at++)
                bytes[at] = (uint8_t)(noise() >> 16);
            virtual_panel_data(&screen, bytes, count);
            if (k % 1000 == 0)
                virtual_panel_look(&screen, noise() % 4, seen);
        }
        /* And it still works. */
        bus = virtual_panel_bus(&screen);
        struct panel panel = {.bus = &bus};
        assert_true(panel_defaults(&panel, modules[i].controller, 0, modules[i].glass.width, modules[i].glass.height));
        assert_true(panel_start(&panel) && panel_show(&panel, PANEL_BRIGHTEST));
        draw(&panel, 0, 0, panel.width, panel.height);
        assert_seen(&panel);
    }
}

/* Rectangles of noise in mono, at any place, on each glass and half turn; what lies around them in their pages is the picture's. */
static void parts_of_mono_pictures_stand_upright_on_an_ssd1306(void **state)
{
    (void)state;
    static const struct virtual_glass glasses[] = {{128, 64, 0, 0, false, false, false, true, false, 0, 0, false},
                                                   {128, 32, 0, 0, false, false, false, true, false, 0, 0, false},
                                                   {72, 40, 28, 0, false, false, false, true, false, 0, 0, false},
                                                   {64, 48, 32, 0, false, false, false, true, false, 0, 0, false}};
    for (unsigned i = 0; i < 8; i++) {
        const struct module module = {PANEL_SSD1306, glasses[i / 2]};
        const struct panel panel = started(&module, i % 2 * 2);
        uint8_t lines[64 * 16];
        memset(lines, 0, sizeof lines);
        assert_true(panel_mono(&panel, lines, 16, 0, 0, panel.width, panel.height));
        for (unsigned round = 0; round < 50; round++) {
            const unsigned x = noise() % panel.width, y = noise() % panel.height, w = 1 + noise() % (panel.width - x),
                           h = 1 + noise() % (panel.height - y);
            for (unsigned row = y; row < y + h; row++)
                for (unsigned column = x; column < x + w; column++) {
                    const unsigned bit = 0x80u >> column % 8, on = noise() & 1;
                    uint8_t *at = &lines[16 * row + column / 8];
                    *at = (uint8_t)(on ? *at | bit : *at & ~bit);
                }
            assert_true(panel_mono(&panel, lines, 16, (uint16_t)x, (uint16_t)y, (uint16_t)w, (uint16_t)h));
            for (unsigned p = 0; p < (unsigned)panel.width * panel.height; p++)
                memset(&wanted[3 * p],
                       lines[16 * (p / panel.width) + p % panel.width / 8] >> (7 - p % panel.width % 8) & 1 ? 255 : 0,
                       3);
            assert_seen(&panel);
        }
        assert_true(panel_stop(&panel));
        assert_black(&panel);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_of_mono_pictures_stand_upright_on_an_ssd1306),
        cmocka_unit_test(every_glass_shows_every_rotation_upright_and_in_its_colours),
        cmocka_unit_test(windows_change_their_own_pixels_only),
        cmocka_unit_test(a_glass_that_the_panel_tells_of_is_the_module_s_own),
        cmocka_unit_test(an_unturned_picture_begins_at_the_top_left_of_the_glass),
        cmocka_unit_test(nothing_is_seen_before_it_is_shown_nor_after_a_stop),
        cmocka_unit_test(a_panel_recovers_after_bytes_that_were_cut_off),
        cmocka_unit_test(pixels_beyond_the_window_s_last_begin_it_again),
        cmocka_unit_test(a_write_that_is_continued_goes_on_where_it_stopped),
        cmocka_unit_test(a_window_whose_end_is_before_its_start_changes_nothing),
        cmocka_unit_test(pixels_outside_the_memory_are_dropped),
        cmocka_unit_test(after_a_reset_a_pixel_is_three_bytes),
        cmocka_unit_test(wrong_wiring_is_seen),
        cmocka_unit_test(any_bytes_in_any_order_are_taken),
    };
    return cmocka_run_group_tests_name("virtual panel", tests, NULL, NULL);
}
