/* SPDX-License-Identifier: MIT
 * glint-gadget from its start to its end, with stand-ins for the kernel. */
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include "unit.h"

#include "../../../firmware/ports/linux/display.c"

static bool *is_lit; /* the panel; shared with a child */

void fail(const char *format, ...)
{
    (void)format;
    exit(1);
}
const char *configfs_create(const struct options *options)
{
    (void)options;
    return "/nowhere";
}
void configfs_remove(void)
{
}
void functionfs_hold_signals(void)
{
}

static void switch_panel(void *context, bool on, uint8_t brightness)
{
    (void)context, (void)brightness;
    *is_lit = on;
}
const struct gud_device_ops picture_ops = {.display = switch_panel};
void picture_open(struct picture *picture, const struct options *options)
{
    (void)picture, (void)options;
}
bool picture_write(const struct picture *picture)
{
    (void)picture;
    return true;
}

static bool kernel_fails;

/* The host switches the display on. */
void functionfs_run(const char *folder, const struct usb_function *function, bool verbose,
                    void (*write_now)(void *context))
{
    (void)folder, (void)verbose, (void)write_now;
    static const uint8_t on = 1, requests[] = {GUD_SET_CONTROLLER_ENABLE, GUD_SET_STATE_COMMIT, GUD_SET_DISPLAY_ENABLE};
    uint8_t state[GUD_STATE_BYTES], modes[GUD_REPLY_BYTES];
    struct gud_setup setup = {GUD_TYPE_IN, GUD_GET_CONNECTOR_MODES, 0, 0, sizeof modes};
    assert_int_equal(function->setup(function->context, &setup, modes), GUD_MODE_BYTES);
    memcpy(state, modes, GUD_MODE_BYTES);
    state[GUD_MODE_BYTES] = GUD_RGB565;
    state[GUD_MODE_BYTES + 1] = 0;
    setup = (struct gud_setup){GUD_TYPE_OUT, GUD_SET_STATE_CHECK, 0, 0, sizeof state};
    assert_int_equal(function->setup(function->context, &setup, modes), sizeof state);
    assert_true(function->set(function->context, &setup, state));
    for (unsigned i = 0; i < sizeof requests; i++) {
        setup = (struct gud_setup){GUD_TYPE_OUT, requests[i], 0, 0, requests[i] != GUD_SET_STATE_COMMIT};
        assert_true(function->setup(function->context, &setup, modes) >= 0);
        assert_true(function->set(function->context, &setup, &on));
    }
    assert_true(*is_lit);
    if (kernel_fails)
        fail("FunctionFS: it fails");
}

static int end_of_a_run(void)
{
    fflush(NULL);
    const pid_t child = fork();
    assert_true(child >= 0);
    if (child == 0) {
        static struct display display;
        const struct options options = {
            .width = 8, .height = 4, .max_buffer = 64, .format_count = 1, .formats = {GUD_RGB565}};
        display_open(&display, &options);
        const struct usb_function function = display_function(&display);
        exit(display_run(&display, &options, &function) ? 0 : 9);
    }
    int status;
    assert_int_equal(waitpid(child, &status, 0), child);
    return WEXITSTATUS(status);
}

static void the_panel_is_dark_however_the_program_ends(void **state)
{
    (void)state;
    is_lit = mmap(NULL, sizeof *is_lit, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    assert_true(is_lit != MAP_FAILED);
    for (unsigned i = 0; i < 2; i++) {
        kernel_fails = i;
        assert_int_equal(end_of_a_run(), i);
        assert_false(*is_lit);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_panel_is_dark_however_the_program_ends)};
    return cmocka_run_group_tests_name("gadget display", tests, NULL, NULL);
}
