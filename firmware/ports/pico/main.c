/* SPDX-License-Identifier: MIT
 * A display that shades by itself until a computer wants to be the one who draws. */
#include "board.h"
#include "demo.h"
#include "demo_map.h"
#include "gud_panel.h"
#include "orbit.h"
#include "relight.h"
#include "usb.h"

static struct {
    uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4];
    uint32_t normals[2][PANEL_WIDTH];
    uint16_t pixels[2][PANEL_WIDTH];
    struct relight_extent extents[PANEL_HEIGHT];
    uint32_t gud_lines[(GUD_DEVICE_LINE_BYTES(PANEL_WIDTH, 2, 2) + 3) / 4];
    uint8_t lz4_window[LZ4_BLOCK_REACH];
} memory;

/* ---- what there is ---- */

static struct panel panel = {.bus = &board_hal.bus};
static struct relight relight = {.hal = &board_hal,
                                 .panel = &panel,
                                 .map = demo_map,
                                 .tables_memory = memory.tables,
                                 .pixels = {memory.pixels[0], memory.pixels[1]},
                                 .normals = {memory.normals[0], memory.normals[1]},
                                 .extents = memory.extents};
static struct gud_device gud;
static struct gud_panel gud_panel = {.hal = &board_hal, .panel = &panel};
static const uint8_t gud_formats[] = {GUD_RGB565, GUD_R1};
static const struct gud_device_config gud_config = {.width = PANEL_WIDTH,
                                                    .height = PANEL_HEIGHT,
                                                    .refresh_hz = 60,
                                                    .interface = USB_GUD_INTERFACE,
                                                    .output = GLINT_RGB565,
                                                    .formats = gud_formats,
                                                    .format_count = sizeof gud_formats,
                                                    .max_buffer = PANEL_WIDTH * PANEL_HEIGHT * 2,
                                                    .lines = (uint8_t *)memory.gud_lines,
                                                    .lines_bytes = sizeof memory.gud_lines,
                                                    .window = memory.lz4_window,
                                                    .window_bytes = sizeof memory.lz4_window,
                                                    .ops = &gud_panel_ops,
                                                    .context = &gud_panel};

/* The watchdog then starts all over again. */
static void fail(const char *what)
{
    board_say("error: ");
    board_say(what);
    board_say("\r\n");
    for (;;)
        ;
}

static void start(void)
{
    enum { ROTATION = PANEL_WIDTH > PANEL_HEIGHT }; /* glass is upright */
    struct glint_shader shader;
    if (!panel_defaults(&panel, PANEL_CONTROLLER, ROTATION, PANEL_WIDTH, PANEL_HEIGHT))
        fail("no such panel");
    if (!gud_device_init(&gud, &gud_config))
        fail("the GUD display");
    usb_start(&gud);
    if (!panel_start(&panel))
        fail("the panel's bus");
    demo_shader(&shader);
    board_alive();
    if (relight_start(&relight, &shader) != GLINT_OK)
        fail("the tables");
}

/* ---- who draws ---- */

enum owner { NOBODY, DEMO, HOST };

static enum owner wanted(void)
{
    if (gud.controller)
        return HOST;
    return usb_is_suspended() ? NOBODY : DEMO;
}

/* The panel changes hands. A host may have opened a rectangle already, which a command would end: then only the light. */
static void hand_over(enum owner from, enum owner to)
{
    static const char *const names[] = {"dark", "relighting", "a computer draws"};
    const bool good = to == HOST ? gud.shown || board_hal.bus.backlight(board_hal.bus.context, false)
                                 : from == NOBODY || panel_show(&panel, false);
    if (!good)
        fail("the panel's bus");
    board_say(names[to]);
    board_say("\r\n");
}

/* A line at most; the display goes on with the first whole frame. */
static void relight_a_line(uint32_t *frame, bool *is_shown)
{
    const bool was_in_frame = relight.in_frame;
    const enum relight_step step = relight_step(&relight);
    if (step == RELIGHT_BUS_FAILED)
        fail("the panel's bus");
    if (was_in_frame && !relight.in_frame)
        ++*frame;
    if (relight.in_frame)
        return;
    if (was_in_frame && !*is_shown) {
        if (!panel_show(&panel, true))
            fail("the panel's bus");
        *is_shown = true;
    }
    int32_t to_light[3];
    orbit_light(to_light, *frame, ORBIT_FRAMES);
    if (relight_frame(&relight, to_light) != GLINT_OK)
        fail("the light");
}

int main(void)
{
    const bool restarted = board_start();
    board_say("glint " GLINT_VERSION_STRING ", " PANEL_NAME "\r\n");
    if (restarted)
        board_say("restarted by the watchdog\r\n");
    start();
    enum owner owner = NOBODY;
    uint32_t frame = 0;
    bool is_shown = false;
    for (;;) {
        board_alive();
        usb_poll();
        if (gud_panel.has_failed)
            fail("the panel's bus");
        if (wanted() != owner) {
            hand_over(owner, wanted());
            owner = wanted();
            relight.in_frame = false;
            is_shown = false;
        }
        if (owner == DEMO)
            relight_a_line(&frame, &is_shown);
    }
}
