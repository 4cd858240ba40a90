/* SPDX-License-Identifier: MIT
 * The Pico's main loop whole, with the portable devices, on a board and beside pictures that are stood in for: whatever hosts do, and however
 * much of it one usb_poll handles, the panel is afterwards its owner's, and as bright as that one wants it. */
#define PANEL_WIDTH 240
#define PANEL_HEIGHT 240
#define PANEL_CONTROLLER PANEL_ST7789
#define PANEL_TURN 0
#define BOARD_ID pico
#define BOARD_NAME "pico"
#define PANEL_NAME "a model"
#define PIN_TE (-1)
#define EXACT 0
#define SECOND_CORE 0
int pico_main(void);
#define main pico_main
#include "../../../firmware/ports/pico/main.c"
#undef main

#include <setjmp.h>

#include "unit.h"

/* ---- the board ---- */

static jmp_buf end;
static unsigned percent; /* of the backlight */

static bool on_command(void *context, uint8_t command)
{
    (void)context;
    (void)command;
    return true;
}

static bool on_data(void *context, const uint8_t *bytes, size_t count)
{
    (void)context;
    (void)bytes;
    (void)count;
    return true;
}

static bool on_backlight(void *context, uint8_t value)
{
    (void)context;
    percent = value;
    return true;
}

static void on_wait(void *context, unsigned ms)
{
    (void)context;
    (void)ms;
}

static void on_flush(void *context, const uint16_t *pixels, size_t count, void (*done)(void *), void *argument)
{
    (void)context;
    (void)pixels;
    (void)count;
    done(argument);
}

const struct hal board_hal = {
    {on_command, on_data, NULL, NULL, on_backlight, on_wait, NULL}, on_flush, NULL, NULL, NULL, NULL, NULL, NULL};

enum fault board_start(void)
{
    return FAULT_NONE;
}

void board_fail(enum fault fault)
{
    fail_msg("fault %d", (int)fault);
}

void board_say(const char *text)
{
    (void)text;
}

static uint32_t now_us, alive_us;
void board_alive(void)
{
    alive_us = now_us;
}

uint32_t board_us(void)
{
    return now_us;
}

void second_core_start(void)
{
}

void hand_start(void)
{
}

bool hand_poll(void)
{
    return false;
}

enum light_sense hand_sense(int32_t to_light[3])
{
    (void)to_light;
    return LIGHT_NO_SENSOR;
}

void shown_next_scene(void)
{
}

/* ---- pictures ---- */

static enum { OTHERS, WHOLE_DEMO, LIGHT } picture; /* on the panel; OTHERS: some of it is a host's or unknown */
static struct {
    bool is_demo, is_first, runs;
    unsigned steps;
} frame;
const char *const shown_words = "a demo";

struct shown_gud_memory *shown_gud_memory(void)
{
    static struct shown_gud_memory memory;
    return &memory;
}

static bool is_intact = true;
bool shown_is_intact(void)
{
    return is_intact;
}

void shown_prepare(struct panel *of_panel, struct light_device *of_light)
{
    (void)of_panel;
    (void)of_light;
}

uint16_t *shown_line(void)
{
    static uint16_t line[PANEL_WIDTH];
    return line;
}

enum glint_err shown_begin_demo(void)
{
    frame.is_demo = frame.is_first = true;
    return GLINT_OK;
}

enum glint_err shown_begin_light(void)
{
    frame.is_demo = false;
    frame.is_first = true;
    return GLINT_OK;
}

static bool next(bool is_demo)
{
    assert_true(frame.is_demo == is_demo);
    frame.runs = true;
    frame.steps = 3;
    return true;
}

bool shown_next_demo(void)
{
    return next(true);
}

bool shown_next_light(void)
{
    return light.has_material && light_device_has_scene(&light) && next(false);
}

/* Frames after the first draw what changes only. */
enum shown_state shown_step(void)
{
    if (frame.runs && --frame.steps > 0)
        return SHOWN_DRAWING;
    if (frame.runs && frame.is_first)
        picture = frame.is_demo ? WHOLE_DEMO : LIGHT;
    if (frame.runs)
        frame.is_first = false;
    frame.runs = false;
    return SHOWN_DONE;
}

void shown_abandon(void)
{
    frame.runs = false;
}

/* ---- a host ---- */

static unsigned state = 1, polls;
static bool is_suspended;

static unsigned below(unsigned n)
{
    state = state * 1664525 + 1013904223;
    return (state >> 10) % n;
}

static void request(bool of_light, uint8_t number, uint8_t value)
{
    uint8_t reply[GUD_REPLY_BYTES];
    const struct gud_setup setup = {GUD_TYPE_OUT, number, 0, of_light ? USB_LIGHT : USB_GUD, 1};
    if (of_light ? light_device_setup(&light, &setup, reply) == 1 : gud_device_setup(&gud, &setup, reply) == 1)
        (void)(of_light ? light_device_set(&light, &setup, &value) : gud_device_set(&gud, &setup, &value));
}

static void give_light(void)
{
    uint8_t message[LIGHT_MESSAGE_BYTES], reply[GUD_REPLY_BYTES];
    const struct gud_setup setup = {GUD_TYPE_OUT, LIGHT_SET_LIGHT, 0, USB_LIGHT, sizeof message};
    light_message_pack(message, 0, (int32_t[]){1, 2, 3});
    assert_int_equal(light_device_setup(&light, &setup, reply), sizeof message);
    (void)light_device_set(&light, &setup, message);
}

/* As usb.c does. */
static void reset(void)
{
    is_suspended = false;
    gud_device_reset(&gud);
    light_device_reset(&light);
}

/* The device opens a rectangle where no host sends lights. */
static void draw_rectangle(void)
{
    if (!gud.controller || gud_ops.busy(&gud_panel))
        return;
    gud_ops.window(&gud_panel, 1, 2, 3, 4);
    picture = OTHERS;
    gud_ops.end(&gud_panel, true);
}

/* Of a host that then sends no byte of it. */
static void announce_rectangle(void)
{
    uint8_t mode[GUD_STATE_BYTES] = {0}, rectangle[GUD_RECTANGLE_BYTES], reply[GUD_REPLY_BYTES];
    const struct gud_setup check = {GUD_TYPE_OUT, GUD_SET_STATE_CHECK, 0, USB_GUD, sizeof mode},
                           commit = {GUD_TYPE_OUT, GUD_SET_STATE_COMMIT, 0, USB_GUD, 0},
                           buffer = {GUD_TYPE_OUT, GUD_SET_BUFFER, 0, USB_GUD, sizeof rectangle};
    gud_mode_pack(mode, &(struct gud_mode){.hdisplay = PANEL_WIDTH, .vdisplay = PANEL_HEIGHT});
    mode[GUD_MODE_BYTES] = GUD_RGB565;
    gud_rectangle_pack(rectangle, &(struct gud_rectangle){.width = 1, .height = 1, .length = 2});
    assert_int_equal(gud_device_setup(&gud, &check, reply), sizeof mode);
    assert_true(gud_device_set(&gud, &check, mode));
    assert_int_equal(gud_device_setup(&gud, &commit, reply), 0);
    assert_true(gud_device_set(&gud, &commit, NULL));
    assert_int_equal(gud_device_setup(&gud, &buffer, reply), sizeof rectangle);
    assert_true(gud_device_set(&gud, &buffer, rectangle));
    picture = OTHERS;
}

/* For longer than the watchdog waits, one after the other and all in one poll: lines of one bit a pixel arrive faster than they are drawn. */
static void draw_many_rectangles(void)
{
    enum { RECTANGLE_US = 30000 };
    for (unsigned us = 0; us < 2 * 1000 * WATCHDOG_MS; us += RECTANGLE_US) {
        draw_rectangle();
        now_us += RECTANGLE_US;
        assert_true(!gud.controller || gud_ops.busy(&gud_panel) || now_us - alive_us < 1000 * WATCHDOG_MS);
    }
}

/* What goes before a light. */
static void send_scene(void)
{
    light.has_material = light.has_map = light.is_new = light.enabled;
}

enum { EVENTS = 13, EVENT_ANNOUNCED = EVENTS + 2 /* in scripts alone */ };
static void happen(unsigned event)
{
    switch (event) {
    case 0:
        request(false, GUD_SET_CONTROLLER_ENABLE, 1);
        return;
    case 1:
        request(false, GUD_SET_DISPLAY_ENABLE, 1);
        return;
    case 2:
        reset();
        return;
    case 3:
        request(false, GUD_SET_DISPLAY_ENABLE, 0);
        return;
    case 4:
        request(false, GUD_SET_CONTROLLER_ENABLE, 0);
        return;
    case 5:
        request(true, LIGHT_SET_ENABLE, 1);
        return;
    case 6:
        request(true, LIGHT_SET_ENABLE, 0);
        return;
    case 7:
        draw_rectangle();
        return;
    case 8:
        is_suspended = true;
        gud_device_suspend(&gud);
        return;
    case 9:
        give_light();
        return;
    case 11:
        send_scene();
        return;
    case 12:
        draw_many_rectangles();
        return;
    case EVENT_ANNOUNCED:
        announce_rectangle();
        return;
    default:
        is_suspended = false;
        gud_device_resume(&gud);
    }
}
enum { QUIET = 16 /* polls: the longest frame takes fewer */, POLL_US = 40000 };

/* After polls in which nothing happens. */
static void check_owner(void)
{
    if (light.enabled) {
        assert_int_equal(owner, LIGHT_HOST);
        if (is_suspended)
            assert_int_equal(percent, 0);
        else if (light_device_has_scene(&light)) /* else what it has drawn before stays */
            assert_int_equal(percent, PANEL_BRIGHTEST);
    } else if (light.is_given && is_intact) {
        assert_true(is_demo(owner));
        assert_int_equal(percent, PANEL_BRIGHTEST);
        assert_int_equal(picture, WHOLE_DEMO);
    } else if (gud.controller) {
        assert_int_equal(owner, GUD_HOST);
        assert_int_equal(percent, gud_panel_percent(gud.shown, gud.brightness));
        assert_false(gud_ops.busy(&gud_panel));
    } else if (is_suspended) {
        assert_int_equal(owner, NOBODY);
        assert_int_equal(percent, 0);
    } else {
        assert_int_equal(owner, is_intact ? DEMO : FAULT);
        assert_int_equal(percent, PANEL_BRIGHTEST);
        assert_true(picture == WHOLE_DEMO || !is_intact);
    }
}

static const unsigned
    *script; /* events, after which EVENTS ends those of one poll, and EVENTS + 1 all; NULL: random ones */

void usb_start(struct gud_device *of_gud, struct light_device *of_light)
{
    (void)of_gud;
    (void)of_light;
}

bool usb_is_suspended(void)
{
    return is_suspended;
}

void usb_poll(void)
{
    now_us += POLL_US;
    if (polls-- == 0)
        longjmp(end, 1);
    if (polls % QUIET != QUIET - 1)
        return;
    if (owner != NOBODY || is_suspended) /* it has begun */
        check_owner();
    for (; script && *script != EVENTS && *script != EVENTS + 1; script++)
        happen(*script);
    if (script && *script == EVENTS)
        script++;
    for (unsigned i = script ? 0 : below(6); i > 0; i--)
        happen(below(EVENTS));
}

static void run_main(unsigned count)
{
    owner = NOBODY;
    polls = count;
    reset();
    if (setjmp(end) == 0)
        pico_main();
    check_owner();
}

static void a_host_that_comes_and_goes_within_one_poll_leaves_the_demo_shown(void **unused)
{
    (void)unused;
    static const unsigned events[] = {EVENTS, 0, 1, 2, EVENTS + 1};
    script = events;
    run_main(3 * QUIET);
    assert_int_equal(owner, DEMO);
}

static void a_light_that_is_given_shows_the_demo_until_it_expires_and_gives_the_panel_back(void **unused)
{
    (void)unused;
    static const unsigned events[] = {0, 1, 7, EVENTS, 9, EVENTS, EVENTS + 1};
    script = events;
    run_main(2 * QUIET);
    assert_int_equal(owner, LIT_DEMO); /* in the place of what the GUD host drew */
    script = events + 6;
    run_main((1000 * LIGHT_HELD_MS / POLL_US / QUIET + 2) * QUIET);
    assert_int_equal(owner, DEMO);
}

/* So is that of a board with power of its own whose computer was unplugged. */
static void the_panel_of_a_program_that_shades_is_dark_while_its_computer_sleeps(void **unused)
{
    (void)unused;
    static const unsigned shading[] = {5, EVENTS, EVENTS + 1}, drawing[] = {5, 11, EVENTS, EVENTS + 1},
                          sleeping[] = {5, 11, EVENTS, 8, EVENTS, EVENTS + 1},
                          waking[] = {5, 11, EVENTS, 8, EVENTS, 10, EVENTS, EVENTS + 1};
    const struct {
        const unsigned *script;
        unsigned percent;
    } cases[] = {{shading, 0}, {drawing, PANEL_BRIGHTEST}, {sleeping, 0}, {waking, PANEL_BRIGHTEST}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        script = cases[i].script;
        run_main(4 * QUIET);
        assert_int_equal(owner, LIGHT_HOST);
        assert_int_equal(percent, cases[i].percent);
    }
}

static void a_host_that_draws_without_a_pause_does_not_starve_the_watchdog(void **unused)
{
    (void)unused;
    static const unsigned events[] = {0, 1, EVENTS, 12, EVENTS, EVENTS + 1};
    script = events;
    run_main(3 * QUIET);
    assert_int_equal(owner, GUD_HOST);
}

static void a_program_that_was_killed_in_a_rectangle_keeps_no_light_away(void **unused)
{
    (void)unused;
    static const unsigned killed[] = {0, 1, EVENT_ANNOUNCED, EVENTS, 5, EVENTS + 1},
                          soon[] = {0, 1, EVENT_ANNOUNCED, EVENTS, EVENTS, EVENTS, 5, EVENTS + 1},
                          later[] = {0,      1,      EVENT_ANNOUNCED, EVENTS, EVENTS, EVENTS,    EVENTS,
                                     EVENTS, EVENTS, EVENTS,          EVENTS, 5,      EVENTS + 1};
    const struct {
        const unsigned *script;
        enum owner owner;
    } cases[] = {{killed, GUD_HOST}, {soon, GUD_HOST}, {later, LIGHT_HOST}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        script = cases[i].script;
        run_main(12 * QUIET);
        assert_int_equal(owner, cases[i].owner);
    }
}

static void whatever_hosts_do_the_panel_is_its_owners(void **unused)
{
    (void)unused;
    script = NULL;
    run_main(100000 * QUIET);
}

static void a_light_that_a_wrong_map_cannot_show_keeps_no_host_away(void **unused)
{
    (void)unused;
    static const unsigned events[] = {0, 1, 9, EVENTS, EVENTS + 1};
    script = events;
    is_intact = false;
    run_main(2 * QUIET);
    assert_true(light.is_given && owner == GUD_HOST);
    script = NULL;
    run_main(10000 * QUIET);
    is_intact = true;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_host_that_comes_and_goes_within_one_poll_leaves_the_demo_shown),
        cmocka_unit_test(a_light_that_is_given_shows_the_demo_until_it_expires_and_gives_the_panel_back),
        cmocka_unit_test(the_panel_of_a_program_that_shades_is_dark_while_its_computer_sleeps),
        cmocka_unit_test(a_host_that_draws_without_a_pause_does_not_starve_the_watchdog),
        cmocka_unit_test(a_program_that_was_killed_in_a_rectangle_keeps_no_light_away),
        cmocka_unit_test(whatever_hosts_do_the_panel_is_its_owners),
        cmocka_unit_test(a_light_that_a_wrong_map_cannot_show_keeps_no_host_away),
    };
    return cmocka_run_group_tests_name("pico main", tests, NULL, NULL);
}
