/* SPDX-License-Identifier: MIT
 * The conformance image and the frame rate: the report goes to the UART as it comes and, whole, again and again, to USB's
 * serial port, whenever it is opened. No panel is needed, but one is used. */
#include "../board.h"
#include "../second_core.h"
#include "conformance.h"
#include "demo.h"
#include "demo_map.h"
#include "machine.h"
#include "orbit.h"
#include "relight.h"

#include <hardware/timer.h>
#include <hardware/watchdog.h>
#include <pico/stdio.h>
#include <pico/stdio_usb.h>

static char report[4096];
static unsigned report_length;

void machine_put(char c)
{
    const char text[] = {c, 0};
    if (report_length < sizeof report)
        report[report_length++] = c;
    board_say(c == '\n' ? "\r\n" : text);
}

/* ---- the frame rate ---- */

static struct {
    uint32_t tables[GLINT_TABLES_COLOUR_BYTES / 4];
    uint32_t normals[2][PANEL_WIDTH];
    uint16_t pixels[2][PANEL_WIDTH];
    struct relight_extent extents[PANEL_HEIGHT];
} memory;
static struct panel panel = {.bus = &board_hal.bus};
static struct glint_paint paint;
static struct relight relight = {.hal = &board_hal,
                                 .panel = &panel,
                                 .map = demo_map,
                                 .paint = &paint,
                                 .pixels = {memory.pixels[0], memory.pixels[1]},
                                 .normals = {memory.normals[0], memory.normals[1]},
                                 .extents = memory.extents};

static bool draw(uint32_t frame)
{
    int32_t to_light[3];
    orbit_light(to_light, frame, ORBIT_FRAMES);
    if (relight_frame(&relight, to_light) != GLINT_OK)
        return false;
    enum relight_step step;
    while ((step = relight_step(&relight)) == RELIGHT_BUSY)
        ;
    return step == RELIGHT_DONE;
}

static void measure_frames(void)
{
    enum { FRAMES = 8 };
    bool good = panel_defaults(&panel, PANEL_CONTROLLER, BOARD_ROTATION, PANEL_WIDTH, PANEL_HEIGHT);
    panel.tearing_line = HAS_TE;
    relight_start(&relight);
    good = good && panel_start(&panel) &&
           glint_paint_tables_for(&paint, &glint_use_colour, &demo_gold, &demo_output, memory.tables,
                                  sizeof memory.tables, &glint_use_msh, &glint_use_rgb565) == GLINT_OK &&
           draw(0) && panel_show(&panel, PANEL_BRIGHTEST);
    const uint32_t begin = time_us_32();
    for (uint32_t frame = 1; good && frame <= FRAMES; frame++)
        good = draw(frame);
    const uint32_t us = (time_us_32() - begin) / FRAMES;
    conformance_say("# relit from flash, sent to the panel: ");
    conformance_say_number(good ? us : 0);
    conformance_say(good ? " us a frame, " : "; it failed, ");
    conformance_say_number(good && us ? 1000000 / us : 0);
    conformance_say(" frames/s\n");
}

int main(void)
{
    extern uint8_t __StackBottom[]; /* the SDK's */
    (void)board_start();
    watchdog_disable(); /* a check takes longer */
#if SECOND_CORE
    second_core_start();
#endif
    conformance_say("# glint " GLINT_VERSION_STRING ", conformance, " BOARD_NAME ", " PANEL_NAME "\n");
    measure_frames();
    stdio_usb_init(); /* not before: its interrupts would be in the frame rate */
    (void)machine_run(__StackBottom);
    for (;;) {
        if (stdio_usb_connected())
            for (unsigned i = 0; i < report_length; i++)
                putchar_raw(report[i]);
        busy_wait_us(2000000);
    }
}
