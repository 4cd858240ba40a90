/* SPDX-License-Identifier: MIT
 * A display that shades by itself until a computer takes it over. */
#include "board.h"
#include "cksum.h"
#include "demo.h"
#include "demo_map.h"
#include "gud_panel.h"
#include "orbit.h"
#include "relight.h"
#include "second_core.h"
#include "usb.h"
#include "usb_class.h"

#include <hardware/timer.h>
#include <pico.h>

/* Where a map fills RAM the lines are in a bank of 4 KB, beside the second core's stack. */
#if OFFERS_LIGHT
#define LINES_BANK __scratch_x("lines")
#else
#define LINES_BANK
#endif
static struct {
#if !OFFERS_LIGHT
    uint32_t normals[2][PANEL_WIDTH];
#endif
    uint16_t pixels[2][PANEL_WIDTH];
    struct relight_extent extents[PANEL_HEIGHT];
} lines LINES_BANK;
#if EXACT
static struct glint_prepared prepared;
#endif
static struct {
#if !EXACT
    uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4];
#endif
    union { /* only one of these hosts has the panel at a time */
        struct {
            uint32_t lines[(GUD_DEVICE_LINE_BYTES(PANEL_WIDTH, 2, 2) + 3) / 4];
            uint8_t lz4_window[LZ4_BLOCK_REACH];
        } gud;
#if OFFERS_LIGHT
        uint32_t map[PANEL_WIDTH * PANEL_HEIGHT];
#else
        uint32_t map[1]; /* no interface fills it */
#endif
    } host;
} memory;

/* ---- what there is ---- */

static struct panel panel = {.bus = &board_hal.bus};
static struct relight relight = {.hal = &board_hal,
                                 .panel = &panel,
#if EXACT
                                 .exact = &prepared,
#else
                                 .tables_memory = memory.tables,
#endif
                                 .pixels = {lines.pixels[0], lines.pixels[1]},
#if !OFFERS_LIGHT /* the map stays in flash */
                                 .normals = {lines.normals[0], lines.normals[1]},
#endif
                                 .extents = lines.extents};
static struct gud_device gud;
static struct gud_panel gud_panel = {.hal = &board_hal, .panel = &panel};
static struct light_device light = {
    .width = PANEL_WIDTH, .height = PANEL_HEIGHT, .interface = USB_LIGHT, .map = memory.host.map, .gud = &gud};
static struct gud_device_ops gud_ops;
static const uint8_t gud_formats[] = {GUD_RGB565, GUD_R1};
static const struct gud_device_config gud_config = {.width = PANEL_WIDTH,
                                                    .height = PANEL_HEIGHT,
                                                    .refresh_hz = 60,
                                                    .interface = USB_GUD,
                                                    .output = GLINT_RGB565,
                                                    .formats = gud_formats,
                                                    .format_count = sizeof gud_formats,
                                                    .dimmable = true,
                                                    .max_buffer = PANEL_WIDTH * PANEL_HEIGHT * 2,
                                                    .lines = (uint8_t *)memory.host.gud.lines,
                                                    .lines_bytes = sizeof memory.host.gud.lines,
                                                    .window = memory.host.gud.lz4_window,
                                                    .window_bytes = sizeof memory.host.gud.lz4_window,
                                                    .ops = &gud_ops,
                                                    .context = &gud_panel};

/* ---- who draws ---- */

/* The later, the stronger: a program that sends lights has been started on purpose. */
enum owner { NOBODY, FAULT, DEMO, GUD_HOST, LIGHT_HOST };
static enum owner owner;

/* While a host sends lights the panel is no other host's, and nor is the memory; until it has been handed over. */
static bool has_lights(void)
{
    return light.enabled || owner == LIGHT_HOST;
}

static bool gud_is_busy(void *context)
{
    (void)context;
    return has_lights();
}

static void gud_display(void *context, bool on, uint8_t brightness)
{
    if (!has_lights())
        gud_panel_ops.display(context, on, brightness);
}

/* ---- faults ---- */

/* What is shown instead of the demo, and until when. */
static struct {
    enum fault fault;
    bool stays;
    uint32_t since_us;
} wrong;
enum { FAULT_SHOWN_US = 2000000 };

static void say_fault(enum fault fault)
{
    const char number[] = {(char)('0' + fault), 0};
    board_say("error ");
    board_say(number);
    board_say(": ");
    board_say(fault_text(fault));
    board_say("\r\n");
}

/* The panel shows it after the watchdog's restart. */
static void fail(enum fault fault)
{
    say_fault(fault);
    board_fail(fault);
}

/* Hosts may draw in spite of these. */
static void find_faults(enum fault before)
{
    wrong.fault = before;
    if (before)
        say_fault(before);
    if (cksum(demo_map, sizeof demo_map) != DEMO_MAP_CKSUM) {
        wrong.fault = FAULT_MAP;
        wrong.stays = true;
        say_fault(FAULT_MAP);
    }
}

static bool has_fault_to_show(void)
{
    if (wrong.fault && !wrong.stays && time_us_32() - wrong.since_us > FAULT_SHOWN_US)
        wrong.fault = FAULT_NONE;
    return wrong.fault;
}

/* ---- start ---- */

static void start(void)
{
    enum { ROTATION = PANEL_WIDTH > PANEL_HEIGHT }; /* glass is upright */
    gud_ops = gud_panel_ops;
    gud_ops.busy = gud_is_busy;
    gud_ops.display = gud_display;
    if (!panel_defaults(&panel, PANEL_CONTROLLER, ROTATION, PANEL_WIDTH, PANEL_HEIGHT) ||
        !gud_device_init(&gud, &gud_config))
        fail(FAULT_BUILD);
    panel.tearing_line = HAS_TE;
    usb_start(&gud, &light);
#if SECOND_CORE
    board_say("both cores shade; the second core has run in a model only\r\n");
    second_core_start();
#endif
#if EXACT
    board_say("every pixel is exact\r\n");
#endif
    if (!panel_start(&panel))
        fail(FAULT_BUS);
    wrong.since_us = time_us_32();
}

static void show(uint8_t percent)
{
    if (!panel_show(&panel, percent))
        fail(FAULT_BUS);
}

/* ---- the panel changes hands ---- */

static enum owner wanted(void)
{
    if (light.enabled)
        return LIGHT_HOST;
    if (gud.controller)
        return GUD_HOST;
    if (usb_is_suspended())
        return NOBODY;
    return has_fault_to_show() ? FAULT : DEMO;
}

static void begin_relighting(const uint32_t *map, const struct glint_shader *shader, uint16_t background)
{
    relight.map = map;
    relight.background = background;
    if (relight_start(&relight, shader) != GLINT_OK)
        fail(FAULT_TABLES);
}

static void begin_demo(void)
{
    struct glint_shader shader;
    demo_shader(&shader);
#if OFFERS_LIGHT /* a map fits into RAM, from where it is faster */
    board_hal.fetch(board_hal.context, memory.host.map, demo_map, PANEL_WIDTH * PANEL_HEIGHT);
    while (!board_hal.fetched(board_hal.context))
        ;
    begin_relighting(memory.host.map, &shader, 0);
#else
    begin_relighting(demo_map, &shader, 0);
#endif
}

/* The panel changes hands, and is dark until the next one has a picture. */
static void hand_over(enum owner to)
{
    static const char *const names[] = {"dark", "showing the error", "relighting", "a computer draws",
                                        "a computer sends lights"};
    relight.in_frame = false;
    if (to != GUD_HOST)
        show(PANEL_OFF);
    else if (owner == LIGHT_HOST)
        show(gud_panel_percent(gud.shown, gud.brightness));
    else if (!gud.shown) /* no command, which would end a rectangle that may be open already */
        board_hal.bus.backlight(board_hal.bus.context, PANEL_OFF);
    if (to == DEMO)
        begin_demo();
    if (to == FAULT) {
        if (!fault_draw(&board_hal, &panel, lines.pixels[0], wrong.fault))
            fail(FAULT_BUS);
        show(PANEL_BRIGHTEST);
    }
    owner = to;
    board_say(names[to]);
    board_say("\r\n");
}

/* The light of the next frame; false: none yet. */
static bool next_light(int32_t to_light[3])
{
    static uint32_t frame;
    if (owner == DEMO) {
        orbit_light(to_light, frame++, ORBIT_FRAMES);
        return true;
    }
    if (light.is_new && light.has_material && light.has_map) {
        struct glint_shader shader;
        light_device_shader(&light, &shader);
        begin_relighting(light.map, &shader, light.material.background);
        light.is_new = false;
    }
    return light_device_next(&light, to_light);
}

/* A line at most; the display goes on with the first whole frame. */
static void draw(bool *is_shown)
{
    if (owner == LIGHT_HOST && !light.has_map)
        relight.in_frame = false; /* it is being replaced */
    const bool was_in_frame = relight.in_frame;
    if (relight_step(&relight) == RELIGHT_BUS_FAILED)
        fail(FAULT_BUS);
    light.is_drawing = owner == LIGHT_HOST && (relight.in_frame || relight.is_sending);
    if (relight.in_frame)
        return;
    if (was_in_frame && !*is_shown) {
        show(PANEL_BRIGHTEST);
        *is_shown = true;
    }
    int32_t to_light[3];
    if (next_light(to_light)) {
        relight_frame(&relight, to_light); /* after an invalid light the last picture stays */
        light.is_drawing = owner == LIGHT_HOST;
    }
}

int main(void)
{
    const enum fault before = board_start();
    board_say("glint " GLINT_VERSION_STRING ", " PANEL_NAME "\r\n");
    if (HAS_TE)
        board_say("frames in step with TE\r\n");
    find_faults(before);
    start();
    bool is_shown = false;
    for (;;) {
        board_alive();
        usb_poll();
        if (gud_panel.has_failed)
            fail(FAULT_BUS);
        const enum owner next = wanted();
        if (next != owner) {
            hand_over(next);
            is_shown = false;
        }
        if (owner == DEMO || owner == LIGHT_HOST)
            draw(&is_shown);
    }
}
