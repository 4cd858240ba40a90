/* SPDX-License-Identifier: MIT
 * A display that shades by itself until a computer takes it over. */
#include "board.h"
#include "gud_panel.h"
#include "hand.h"
#include "second_core.h"
#include "shown.h"
#include "usb.h"

/* ---- what there is ---- */

static struct panel panel = {.bus = &board_hal.bus};
static struct gud_device gud;
static struct gud_panel gud_panel = {.hal = &board_hal, .panel = &panel};
static struct light_device light = {
    .width = PANEL_WIDTH, .height = PANEL_HEIGHT, .interface = USB_LIGHT, .sense = hand_sense, .gud = &gud};
static struct gud_device_ops gud_ops;
static const uint8_t gud_formats[] = {GUD_RGB565, GUD_R1};
static struct gud_device_config gud_config = {.width = PANEL_WIDTH,
                                              .height = PANEL_HEIGHT,
                                              .refresh_hz = 60,
                                              .interface = USB_GUD,
                                              .output = GLINT_RGB565,
                                              .formats = gud_formats,
                                              .format_count = sizeof gud_formats,
                                              .dimmable = true,
                                              .whole_frames = IS_QSPI,
                                              .max_buffer = PANEL_WIDTH * PANEL_HEIGHT * 2,
                                              .ops = &gud_ops,
                                              .context = &gud_panel};

/* ---- who draws ---- */

/* The later, the stronger: a program that sends lights has been started on purpose. */
enum owner { NOBODY, FAULT, DEMO, GUD_HOST, LIT_DEMO, LIGHT_HOST }; /* LIT_DEMO: under a computer's light */
static enum owner owner;

static bool is_demo(enum owner it)
{
    return it == DEMO || it == LIT_DEMO;
}

/* What is shown instead of the demo, and until when. */
static struct {
    enum fault fault;
    bool stays;
    uint32_t since_us;
} wrong;
enum { FAULT_SHOWN_US = 2000000 };

/* A fault that stays hides the demo, whatever its light. */
static bool is_lit(void)
{
    return light.is_given && !wrong.stays;
}

/* While a host sends lights the panel is no other host's, and nor is the memory; until it has been handed over. */
static bool has_lights(void)
{
    return light.enabled || is_lit() || owner == LIGHT_HOST || owner == LIT_DEMO;
}

static bool gud_is_busy(void *context)
{
    (void)context;
    return has_lights();
}

/* Panel or memory are not as their owner left them, and nor is the display. Of a host that came and went within one usb_poll nothing
 * else tells. */
static bool is_disturbed;
/* GUD's display has changed while the panel was another's. */
static bool is_missed;

static void gud_display(void *context, bool on, uint8_t brightness)
{
    is_missed |= has_lights();
    if (has_lights())
        return;
    is_disturbed = true;
    gud_panel_ops.display(context, on, brightness);
}

/* Of a host whose pixels arrive faster than they are drawn usb_poll returns late, or never. */
static void gud_window(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height)
{
    board_alive();
    is_disturbed = true;
    gud_panel_ops.window(context, x, y, width, height);
}

/* ---- faults ---- */

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
    if (!shown_is_intact()) {
        wrong.fault = FAULT_MAP;
        wrong.stays = true;
        say_fault(FAULT_MAP);
    }
}

static bool has_fault_to_show(void)
{
    if (wrong.fault && !wrong.stays && board_us() - wrong.since_us > FAULT_SHOWN_US)
        wrong.fault = FAULT_NONE;
    return wrong.fault;
}

/* ---- start ---- */

static void start(void)
{
    gud_ops = gud_panel_ops;
    gud_ops.busy = gud_is_busy;
    gud_ops.display = gud_display;
    gud_ops.window = gud_window;
    struct shown_gud_memory *const memory = shown_gud_memory();
    gud_config.lines = (uint8_t *)memory->lines;
    gud_config.lines_bytes = sizeof memory->lines;
    if (!IS_QSPI) {
        gud_config.window = memory->lz4_window;
        gud_config.window_bytes = sizeof memory->lz4_window;
    }
    shown_prepare(&panel, &light);
    if (!panel_defaults(&panel, PANEL_CONTROLLER, BOARD_ROTATION, PANEL_WIDTH, PANEL_HEIGHT) ||
        !gud_device_init(&gud, &gud_config))
        fail(FAULT_BUILD);
    panel.tearing_line = HAS_TE;
    usb_start(&gud, &light);
    hand_start();
#if SECOND_CORE
    board_say("both cores shade; the second core has run in a model only\r\n");
    second_core_start();
#endif
#if EXACT
    board_say("every pixel is exact\r\n");
#endif
    if (!panel_start(&panel))
        fail(FAULT_BUS);
    wrong.since_us = board_us();
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
    if (is_lit() && !has_fault_to_show())
        return LIT_DEMO;
    if (gud.controller)
        return GUD_HOST;
    if (usb_is_suspended())
        return NOBODY;
    return has_fault_to_show() ? FAULT : DEMO;
}

static void begin_drawing(enum glint_err (*begin)(void))
{
    if (begin() != GLINT_OK)
        fail(FAULT_TABLES);
}

static struct {
    bool in_frame;    /* lines of it are to be drawn */
    bool has_picture; /* a whole one */
    bool is_shown;    /* the display is on */
} drawn;

/* The panel changes hands, and is dark until the next one has a picture. */
static void hand_over(enum owner to)
{
    const char *const names[] = {"dark",
                                 "showing the error",
                                 shown_words,
                                 "a computer draws",
                                 "a computer gives the light",
                                 "a computer sends lights"};
    shown_abandon();
    drawn.in_frame = drawn.has_picture = drawn.is_shown = false;
    if (to != GUD_HOST)
        show(PANEL_OFF);
    else if (owner == LIGHT_HOST || owner == LIT_DEMO || light.was_enabled || is_missed)
        /* gud_display did nothing; a rectangle may be open already */
        gud_panel_ops.display(&gud_panel, gud.shown, gud.brightness);
    else if (!gud.shown &&
             board_hal.bus.backlight) /* no command, which would end a rectangle that may be open already */
        board_hal.bus.backlight(board_hal.bus.context, PANEL_OFF);
    else if (!gud.shown)
        gud_panel_ops.display(&gud_panel, false, gud.brightness);
    if (is_demo(to))
        begin_drawing(shown_begin_demo);
    if (to == FAULT) {
        if (!fault_draw(&board_hal, &panel, shown_line(), wrong.fault))
            fail(FAULT_BUS);
        show(PANEL_BRIGHTEST);
    }
    is_disturbed = is_missed = light.was_enabled = false;
    owner = to;
    board_say(names[to]);
    board_say("\r\n");
}

/* Has a host come and gone that is not the owner? */
static bool must_restart(void)
{
    if (owner == GUD_HOST)
        return is_missed || light.was_enabled;
    return is_disturbed || (light.was_enabled && owner != LIGHT_HOST);
}

/* Begins it; false: there is none yet. */
static bool next_frame(void)
{
    if (is_demo(owner))
        return shown_next_demo();
    if (light.is_new && light.has_material && light_device_has_scene(&light)) {
        begin_drawing(shown_begin_light);
        light.is_new = false;
    }
    return shown_next_light();
}

/* The display goes on with the first whole picture. That of a program that shades is dark while its computer sleeps, or was unplugged from
 * a board with power of its own, and is then as it was. */
static void show_picture(void)
{
    const bool is_shown = drawn.has_picture && !(owner == LIGHT_HOST && usb_is_suspended());
    if (is_shown != drawn.is_shown)
        show(is_shown ? PANEL_BRIGHTEST : PANEL_OFF);
    drawn.is_shown = is_shown;
}

/* Some lines at most. */
static void draw(void)
{
    if (drawn.in_frame && owner == LIGHT_HOST && !light_device_has_scene(&light)) { /* it is being replaced */
        shown_abandon();
        drawn.in_frame = false;
    }
    const enum shown_state state = shown_step();
    if (state == SHOWN_FAILED)
        fail(FAULT_BUS);
    light.is_drawing = owner == LIGHT_HOST && state != SHOWN_DONE;
    if (state == SHOWN_DRAWING)
        return;
    drawn.has_picture |= drawn.in_frame;
    show_picture();
    drawn.in_frame = next_frame();
    light.is_drawing = owner == LIGHT_HOST && (drawn.in_frame || light.is_drawing);
}

static void change_scene(void)
{
    shown_next_scene();
    shown_abandon();
    drawn.in_frame = false;
    begin_drawing(shown_begin_demo);
}

int main(void)
{
    const enum fault before = board_start();
    board_say("glint " GLINT_VERSION_STRING ", " PANEL_NAME "\r\n");
    if (HAS_TE)
        board_say("frames in step with TE\r\n");
    find_faults(before);
    start();
    for (;;) {
        board_alive();
        usb_poll();
        const bool is_knocked = hand_poll();
        if (gud_panel.has_failed)
            fail(FAULT_BUS);
        if (gud.open)
            gud_device_time(&gud, board_us());
        if (light.is_given)
            light_device_time(&light, board_us());
        const enum owner next = wanted();
        if (must_restart() || (next != owner && !(is_demo(next) && is_demo(owner))))
            hand_over(next);
        owner = next;
        if (is_knocked && is_demo(owner))
            change_scene();
        if (is_demo(owner) || owner == LIGHT_HOST)
            draw();
    }
}
