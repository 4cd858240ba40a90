/* SPDX-License-Identifier: MIT
 * What a board shows when something is wrong, and the checksum that finds a damaged map. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "alarm.h"
#include "cksum.h"
#include "fault.h"
#include "unit.h"
#include "sinks/panel/virtual_panel.h"

enum { SIDE_MAX = 320 };

/* How often white begins in a line; -1 where the line has another colour than red and white. */
static int blocks_in(const uint16_t *pixels, unsigned width)
{
    int count = 0;
    for (unsigned x = 0; x < width; x++) {
        if (pixels[x] != FAULT_WHITE && pixels[x] != FAULT_RED)
            return -1;
        count += pixels[x] == FAULT_WHITE && (x == 0 || pixels[x - 1] != FAULT_WHITE);
    }
    return count;
}

static void the_bar_has_as_many_blocks_as_the_faults_number(void **state)
{
    (void)state;
    static const uint16_t sizes[][2] = {{240, 240}, {240, 320}, {135, 240}, {320, 240}, {172, 320}};
    uint16_t line[SIDE_MAX];
    for (unsigned i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (unsigned fault = FAULT_HUNG; fault < FAULTS; fault++) {
            const uint16_t w = sizes[i][0], h = sizes[i][1];
            fault_line(line, w, h, h / 2, (enum fault)fault);
            assert_int_equal(blocks_in(line, w), fault);
            assert_int_equal(line[0], FAULT_RED);
            assert_int_equal(line[w - 1], FAULT_RED);
            fault_line(line, w, h, (uint16_t)(h * 2 / 5), (enum fault)fault);
            assert_int_equal(blocks_in(line, w), 0);
            for (unsigned y = 0; y < h; y += h - 1u) {
                fault_line(line, w, h, (uint16_t)y, (enum fault)fault);
                for (unsigned x = 0; x < w; x++)
                    assert_int_equal(line[x], FAULT_BLACK);
            }
        }
}

static void every_fault_has_a_text(void **state)
{
    (void)state;
    for (unsigned fault = FAULT_HUNG; fault < FAULTS; fault++)
        for (unsigned other = 0; other < fault; other++)
            assert_string_not_equal(fault_text((enum fault)fault), fault_text((enum fault)other));
    assert_string_equal(fault_text(FAULTS), "");
}

/* ---- on a panel ---- */

static struct virtual_panel screen;
static struct panel_bus bus;

static void flush(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    for (size_t i = 0; i < count; i++) {
        const uint8_t bytes[] = {(uint8_t)(pixels[i] >> 8), (uint8_t)pixels[i]};
        bus.data(bus.context, bytes, sizeof bytes);
    }
    done(argument);
}

static bool broken_command(void *context, uint8_t command)
{
    (void)context;
    (void)command;
    return false;
}

static void the_picture_is_on_the_panel_line_for_line(void **state)
{
    (void)state;
    enum { WIDTH = 135, HEIGHT = 240 };
    static uint8_t rgb[WIDTH * HEIGHT * 3];
    uint16_t line[WIDTH], wanted[WIDTH];
    struct panel panel = {.bus = &bus};
    assert_true(panel_defaults(&panel, PANEL_ST7789, 0, WIDTH, HEIGHT));
    const struct virtual_glass glass = virtual_glass_of(&panel);
    virtual_panel_init(&screen, &glass);
    bus = virtual_panel_bus(&screen);
    const struct hal hal = {.bus = bus, .flush = flush};
    assert_true(panel_start(&panel) && fault_draw(&hal, &panel, line, FAULT_MAP) &&
                panel_show(&panel, PANEL_BRIGHTEST));
    virtual_panel_look(&screen, 0, rgb);
    for (uint16_t y = 0; y < HEIGHT; y++) {
        fault_line(wanted, WIDTH, HEIGHT, y, FAULT_MAP);
        for (unsigned x = 0; x < WIDTH; x++) {
            const uint8_t *const pixel = rgb + 3 * (y * WIDTH + x);
            assert_int_equal(pixel[0], wanted[x] ? 255 : 0);
            assert_int_equal(pixel[1], wanted[x] == FAULT_WHITE ? 255 : 0);
            assert_int_equal(pixel[2], wanted[x] == FAULT_WHITE ? 255 : 0);
        }
    }
    bus.command = broken_command;
    assert_false(fault_draw(&hal, &panel, line, FAULT_MAP));
}

static void flush_later(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    (void)pixels;
    (void)count;
    set_alarm(done, argument);
}

static void the_next_line_waits_until_the_one_before_is_sent(void **state)
{
    (void)state;
    enum { WIDTH = 8, HEIGHT = 5 };
    uint16_t line[WIDTH];
    struct panel panel = {.bus = &bus, .width = WIDTH, .height = HEIGHT};
    const struct virtual_glass glass = virtual_glass_of(&panel);
    virtual_panel_init(&screen, &glass);
    bus = virtual_panel_bus(&screen);
    const struct hal hal = {.bus = bus, .flush = flush_later};
    alarms.count = 0;
    assert_true(fault_draw(&hal, &panel, line, FAULT_MAP));
    assert_int_equal(alarms.count, HEIGHT);
}

/* ---- the checksum ---- */

static uint32_t by_the_command(const uint8_t *bytes, size_t count)
{
    char command[64];
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, count, file), count);
    assert_int_equal(fflush(file), 0);
    snprintf(command, sizeof command, "cksum </dev/fd/%d", fileno(file));
    FILE *pipe = popen(command, "r");
    unsigned long sum = 0;
    assert_true(pipe && fscanf(pipe, "%lu", &sum) == 1);
    assert_int_equal(pclose(pipe), 0);
    fclose(file);
    return (uint32_t)sum;
}

static void the_checksum_is_the_commands(void **state)
{
    (void)state;
    static const size_t lengths[] = {0, 1, 3, 255, 256, 257, 65535, 65536, 70001};
    static uint8_t bytes[70001];
    srand(1);
    for (unsigned i = 0; i < sizeof lengths / sizeof *lengths; i++) {
        for (size_t k = 0; k < lengths[i]; k++)
            bytes[k] = (uint8_t)rand();
        assert_int_equal(cksum(bytes, lengths[i]), by_the_command(bytes, lengths[i]));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_bar_has_as_many_blocks_as_the_faults_number),
        cmocka_unit_test(every_fault_has_a_text),
        cmocka_unit_test(the_picture_is_on_the_panel_line_for_line),
        cmocka_unit_test(the_next_line_waits_until_the_one_before_is_sent),
        cmocka_unit_test(the_checksum_is_the_commands),
    };
    return cmocka_run_group_tests_name("fault", tests, NULL, NULL);
}
