/* SPDX-License-Identifier: MIT
 * A display that shades by itself. */
#include "board.h"
#include "demo.h"
#include "demo_map.h"
#include "orbit.h"
#include "relight.h"

#define STRING(x) #x
#define STRING_OF(x) STRING(x)

static struct panel panel = {.bus = &board_hal.bus};
static struct relight relight;
static struct {
    uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4];
    uint32_t normals[2][PANEL_WIDTH];
    uint16_t pixels[2][PANEL_WIDTH];
    struct relight_extent extents[PANEL_HEIGHT];
} memory;

/* The watchdog then starts all over again. */
static void fail(const char *what)
{
    board_say("error: ");
    board_say(what);
    board_say("\r\n");
    for (;;)
        ;
}

static void start_panel(void)
{
    enum { ROTATION = PANEL_WIDTH > PANEL_HEIGHT }; /* glass is upright */
    if (!panel_defaults(&panel, PANEL_CONTROLLER, ROTATION, PANEL_WIDTH, PANEL_HEIGHT))
        fail("no such panel");
    if (!panel_start(&panel))
        fail("the panel's bus");
}

static void start_relight(void)
{
    struct glint_shader shader;
    demo_shader(&shader);
    relight.hal = &board_hal;
    relight.panel = &panel;
    relight.map = demo_map;
    relight.tables_memory = memory.tables;
    relight.extents = memory.extents;
    for (unsigned i = 0; i < 2; i++) {
        relight.normals[i] = memory.normals[i];
        relight.pixels[i] = memory.pixels[i];
    }
    if (relight_start(&relight, &shader) != GLINT_OK)
        fail("the tables");
}

int main(void)
{
    const bool restarted = board_start();
    board_say("glint " GLINT_VERSION_STRING
              ", " STRING_OF(PANEL_CONTROLLER) " " STRING_OF(PANEL_WIDTH) "x" STRING_OF(PANEL_HEIGHT) "\r\n");
    if (restarted)
        board_say("restarted by the watchdog\r\n");
    start_panel();
    board_alive();
    start_relight();
    board_say("relighting\r\n");
    for (uint32_t frame = 0;; frame++) {
        int32_t to_light[3];
        orbit_light(to_light, frame, ORBIT_FRAMES);
        if (relight_frame(&relight, to_light) != GLINT_OK)
            fail("the light");
        enum relight_step step;
        while ((step = relight_step(&relight)) == RELIGHT_BUSY && relight.in_frame)
            ;
        if (step == RELIGHT_BUS_FAILED || (frame == 0 && !panel_show(&panel, true)))
            fail("the panel's bus");
        board_alive();
    }
}
