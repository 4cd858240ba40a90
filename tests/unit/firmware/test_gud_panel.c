/* SPDX-License-Identifier: MIT
 * A GUD display on a panel: it shows what a host draws, whatever else the host asks for meanwhile. */
#include <string.h>

#include "alarm.h"
#include "gud_panel.h"
#include "unit.h"
#include "sinks/panel/virtual_panel.h"

enum { WIDTH = 135, HEIGHT = 240, X = 7, Y = 30, COLUMNS = 100, LINES = 20, BYTES = 2 * COLUMNS * LINES };

static struct virtual_panel screen; /* 150 KB: too much for the stack */
static struct hal hal;
static struct panel panel;
static struct gud_panel gud_panel;
static struct gud_device device;
static uint32_t lines[(GUD_DEVICE_LINE_BYTES(WIDTH, 2, 2) + 3) / 4];
static uint8_t pixels[BYTES];
static bool is_broken;

static void flush(void *context, const uint16_t *line, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    for (size_t i = 0; i < count; i++)
        virtual_panel_data(&screen, (const uint8_t[]){(uint8_t)(line[i] >> 8), (uint8_t)line[i]}, 2);
    done(argument);
}

static bool broken_command(void *context, uint8_t command)
{
    virtual_panel_command(context, command);
    return !is_broken;
}

static void set(uint8_t request, const uint8_t *data, uint16_t length)
{
    uint8_t reply[GUD_REPLY_BYTES];
    const struct gud_setup setup = {GUD_TYPE_OUT, request, 0, 0, length};
    assert_int_equal(gud_device_setup(&device, &setup, reply), length);
    assert_true(gud_device_set(&device, &setup, data));
}

static int start(void **state)
{
    static const uint8_t formats[] = {GUD_RGB565};
    static const struct gud_device_config config = {.width = WIDTH,
                                                    .height = HEIGHT,
                                                    .refresh_hz = 60,
                                                    .output = GLINT_RGB565,
                                                    .formats = formats,
                                                    .format_count = 1,
                                                    .max_buffer = BYTES,
                                                    .lines = (uint8_t *)lines,
                                                    .lines_bytes = sizeof lines,
                                                    .ops = &gud_panel_ops,
                                                    .context = &gud_panel};
    (void)state;
    is_broken = false;
    panel = (struct panel){.bus = &hal.bus};
    assert_true(panel_defaults(&panel, PANEL_ST7789, 0, WIDTH, HEIGHT));
    const struct virtual_glass glass = virtual_glass_of(&panel);
    virtual_panel_init(&screen, &glass);
    hal = (struct hal){.bus = virtual_panel_bus(&screen), .flush = flush};
    hal.bus.command = broken_command;
    gud_panel = (struct gud_panel){.hal = &hal, .panel = &panel};
    assert_true(panel_start(&panel));
    assert_true(gud_device_init(&device, &config));
    uint8_t data[GUD_STATE_BYTES] = {0};
    gud_mode_pack(data, &(struct gud_mode){.hdisplay = WIDTH, .vdisplay = HEIGHT});
    data[GUD_MODE_BYTES] = GUD_RGB565;
    set(GUD_SET_CONTROLLER_ENABLE, &(uint8_t){1}, 1);
    set(GUD_SET_STATE_CHECK, data, sizeof data);
    set(GUD_SET_STATE_COMMIT, data, 0);
    for (unsigned i = 0; i < BYTES; i++)
        pixels[i] = (uint8_t)(i * 7 + i / 256);
    return 0;
}

static void begin_rectangle(void)
{
    uint8_t data[GUD_RECTANGLE_BYTES];
    gud_rectangle_pack(data, &(struct gud_rectangle){X, Y, COLUMNS, LINES, BYTES, 0, 0});
    set(GUD_SET_BUFFER, data, sizeof data);
}

static void assert_drawn(void)
{
    static uint8_t seen[3 * WIDTH * HEIGHT];
    virtual_panel_look(&screen, 0, seen);
    for (unsigned i = 0; i < COLUMNS * LINES; i++) {
        const unsigned color = pixels[2 * i] | (unsigned)pixels[2 * i + 1] << 8;
        const uint8_t *at = seen + 3 * ((Y + i / COLUMNS) * WIDTH + X + i % COLUMNS);
        const uint8_t wanted[] = {(uint8_t)((color >> 11) * 255.0 / 31 + .5),
                                  (uint8_t)((color >> 5 & 63) * 255.0 / 63 + .5),
                                  (uint8_t)((color & 31) * 255.0 / 31 + .5)};
        if (memcmp(at, wanted, 3) != 0)
            fail_msg("pixel %u of line %u", i % COLUMNS, i / COLUMNS);
    }
}

static void a_rectangle_is_shown_where_the_host_puts_it(void **state)
{
    (void)state;
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    begin_rectangle();
    for (unsigned at = 0; at < BYTES; at += 64)
        gud_device_bulk(&device, pixels + at, BYTES - at < 64 ? BYTES - at : 64);
    assert_drawn();
    assert_false(gud_panel.has_failed);
}

/* Linux draws from a thread of its own, which does not wait for requests of other threads. */
static void a_display_that_is_switched_within_a_rectangle_gets_the_rest_of_it(void **state)
{
    (void)state;
    begin_rectangle();
    gud_device_bulk(&device, pixels, 500);
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    gud_device_bulk(&device, pixels + 500, 500);
    gud_device_suspend(&device);
    gud_device_bulk(&device, pixels + 1000, 1);
    gud_device_resume(&device);
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){0}, 1);
    gud_device_bulk(&device, pixels + 1001, 999);
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    gud_device_bulk(&device, pixels + 2000, BYTES - 2000);
    assert_drawn();
}

/* Before its first line, and after its last. */
static void a_display_that_is_switched_at_a_rectangles_ends_shows_all_of_it(void **state)
{
    (void)state;
    begin_rectangle();
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    gud_device_bulk(&device, pixels, BYTES);
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){0}, 1);
    assert_int_equal(screen.command, PANEL_DISPLAY_OFF); /* the panel takes no pixels any more */
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    assert_drawn();
}

static void a_bus_that_fails_is_noticed(void **state)
{
    (void)state;
    is_broken = true;
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    assert_true(gud_panel.has_failed);
    gud_panel.has_failed = false;
    begin_rectangle();
    assert_true(gud_panel.has_failed);
}

static bool fails_to_go_on(void *context, uint8_t command)
{
    virtual_panel_command(context, command);
    return command != PANEL_MEMORY_CONTINUE;
}

static void a_bus_that_fails_at_the_rest_of_a_rectangle_is_noticed(void **state)
{
    (void)state;
    hal.bus.command = fails_to_go_on;
    begin_rectangle();
    gud_device_bulk(&device, pixels, 500);
    assert_false(gud_panel.has_failed);
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    assert_true(gud_panel.has_failed);
}

static void a_display_that_is_on_is_never_quite_dark(void **state)
{
    (void)state;
    assert_int_equal(gud_panel_percent(true, 0), 1);
    assert_int_equal(gud_panel_percent(true, PANEL_BRIGHTEST), PANEL_BRIGHTEST);
    assert_int_equal(gud_panel_percent(false, PANEL_BRIGHTEST), PANEL_OFF);
}

static void flush_later(void *context, const uint16_t *line, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    for (size_t i = 0; i < count; i++)
        virtual_panel_data(&screen, (const uint8_t[]){(uint8_t)(line[i] >> 8), (uint8_t)line[i]}, 2);
    set_alarm(done, argument);
}

static void a_line_waits_until_the_one_before_is_sent(void **state)
{
    (void)state;
    alarms.count = 0;
    hal.flush = flush_later;
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){1}, 1);
    begin_rectangle();
    gud_device_bulk(&device, pixels, BYTES);
    assert_drawn();
    set(GUD_SET_DISPLAY_ENABLE, &(uint8_t){0}, 1); /* waits for the last */
    assert_int_equal(alarms.count, LINES);
    assert_false(gud_panel.is_sending);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_rectangle_is_shown_where_the_host_puts_it, start),
        cmocka_unit_test_setup(a_display_that_is_switched_within_a_rectangle_gets_the_rest_of_it, start),
        cmocka_unit_test_setup(a_display_that_is_switched_at_a_rectangles_ends_shows_all_of_it, start),
        cmocka_unit_test_setup(a_bus_that_fails_is_noticed, start),
        cmocka_unit_test_setup(a_bus_that_fails_at_the_rest_of_a_rectangle_is_noticed, start),
        cmocka_unit_test(a_display_that_is_on_is_never_quite_dark),
        cmocka_unit_test_setup(a_line_waits_until_the_one_before_is_sent, start),
    };
    return cmocka_run_group_tests_name("gud panel", tests, NULL, NULL);
}
