/* SPDX-License-Identifier: MIT
 * Who else has a display, which of several it is, and signals. */
#include "hour.h"
#include "usb_run.h"

#include <fcntl.h>
#include <signal.h>
#include <time.h>

/* ---- who else has it ---- */

static void another_programs_display_is_left_to_it(void **state)
{
    (void)state;
    honest();
    usb_display_be(&display, &config);
    const pid_t stream = start("exec " STREAM OURS);
    assert_soon(display.seen->rectangles > 1);
    assert_fails(STREAM OURS "--frames 1", "(1209:0001): another program uses it; end that first");
    kill(stream, SIGTERM);
    assert_exits(stream, 143);
}

/* As the display of a stream that waits for its return, which another program takes first. */
static void wait_gives_another_program_a_moment_and_no_longer(void **state)
{
    (void)state;
    char command[300];
    honest();
    usb_display_be(&display, &config);
    const pid_t stream = start("exec " STREAM OURS);
    assert_soon(display.seen->rectangles > 1);
    assert_fails(STREAM OURS "--frames 1 --wait", "(1209:0001): another program uses it; end that first");
    snprintf(command, sizeof command, "(sleep 1; kill %d) & " STREAM OURS "--frames 1 --wait", (int)stream);
    assert_ends(command, 0, "");
    assert_exits(stream, 143);
}

static void a_display_without_permission_is_told_apart_from_none(void **state)
{
    (void)state;
    honest();
    usb_display_be(&display, &config);
    assert_ends("chmod 755 .; setpriv --reuid 65534 --clear-groups " STREAM OURS "--frames 1", 1,
                "permission denied; install glint's udev rule");
}

/* A device that has just been plugged in is there before udev lets the user in. */
static void wait_gives_udev_a_moment_and_no_longer(void **state)
{
    (void)state;
    static const struct {
        const char *options, *end;
        int status;
    } ways[] = {{"--frames 1", "", 0}, {"--shade device", "it does not shade by itself", 1}};
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        char command[300];
        usb_displays_unplug(NULL);
        honest();
        usb_display_be(&display, &config);
        snprintf(command, sizeof command, "chmod 755 .; setpriv --reuid 65534 --clear-groups " STREAM OURS "%s --wait",
                 ways[i].options);
        assert_ends(command, 1, "permission denied; install glint's udev rule");
        snprintf(command, sizeof command,
                 "(sleep 1; chmod 666 /dev/bus/usb/001/*) & setpriv --reuid 65534 --clear-groups " STREAM OURS
                 "%s --wait",
                 ways[i].options);
        assert_ends(command, ways[i].status, ways[i].end);
    }
}

static void the_kernels_display_is_taken_only_by_detach_and_given_back(void **state)
{
    (void)state;
    usb_displays_unplug(NULL);
    honest();
    config.ids.vendor = 0x1d50;
    config.ids.product = 0x614d;
    usb_display_be(&display, &config);
    assert_soon(access("/sys/bus/usb/drivers/gud/1-1:1.0", F_OK) == 0);
    assert_contains(run("$GLINT list")->out, "1d50:614d  taken by the kernel (driver gud)  Lab display  serial lab");
    assert_fails(STREAM "--frames 1", "(1d50:614d): the kernel's driver gud has it; --detach takes the monitor from");
    assert_ends(STREAM "--frames 2 --detach", 0, "");
    assert_soon(access("/sys/bus/usb/drivers/gud/1-1:1.0", F_OK) == 0);
    const pid_t stream = start("exec " STREAM "--detach");
    assert_soon(access("/sys/bus/usb/drivers/gud/1-1:1.0", F_OK) != 0 && display.seen->rectangles > 1);
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    assert_soon(access("/sys/bus/usb/drivers/gud/1-1:1.0", F_OK) == 0);
    assert_fails(STREAM "--detach --size 3x3", "it has no mode 3x3");
    assert_soon(access("/sys/bus/usb/drivers/gud/1-1:1.0", F_OK) == 0);
    usb_display_unplug(&display);
}

static void of_two_displays_one_is_to_be_named(void **state)
{
    (void)state;
    usb_displays_unplug(NULL);
    static struct usb_display_config second;
    static struct usb_display other;
    honest();
    config.ids.serial = "left";
    second = config;
    second.ids.serial = "right";
    second.controller = 1;
    usb_display_be(&display, &config);
    usb_display_be(&other, &second);
    assert_fails(STREAM "--frames 1",
                 "1-1 (1209:0001 serial left), 2-1 (1209:0001 serial right); choose one by --usb-path");
    assert_ends(STREAM "--frames 1 --serial right", 0, "");
    assert_soon(other.seen->rectangles == 1);
    assert_int_equal(display.seen->rectangles, 0);
    assert_ends(STREAM "--frames 1 --usb-path 1-1", 0, "");
    assert_soon(display.seen->rectangles == 1);
    usb_display_unplug(&other);
    usb_display_unplug(&display);
}

static void a_device_whose_interface_is_not_guds_is_asked_only_by_name(void **state)
{
    (void)state;
    usb_displays_unplug(NULL);
    honest();
    config.ids.interface = "Printer";
    usb_display_be(&display, &config);
    assert_null(strstr(run("$GLINT list")->out, "1209:0001"));
    assert_fails(STREAM "--frames 1", "no USB display: no device has the IDs");
    assert_int_equal(display.seen->request_count, 0);
    assert_ends(STREAM OURS "--frames 1", 0, "");
    assert_true(display.seen->request_count > 0);
    usb_display_unplug(&display);
    honest();
    usb_display_be(&display, &config);
    assert_contains(run("$GLINT list")->out, "1209:0001  free");
    usb_display_unplug(&display);
}

/* Its serial number carries ESC and, as U+009B, the control sequence introducer. */
static void what_a_device_says_of_itself_reaches_the_terminal_without_control_characters(void **state)
{
    (void)state;
    usb_displays_unplug(NULL);
    honest();
    config.ids.serial = "a\033[31m\302\233"
                        "1mz";
    usb_display_be(&display, &config);
    static const char *const commands[] = {"$GLINT list", "$GLINT list --json", STREAM "--frames 1 --stats",
                                           STREAM "--frames 1 --json", STREAM "--frames 1 --size 9x9"};
    for (size_t i = 0; i < sizeof commands / sizeof *commands; i++) {
        const struct run *result = run(commands[i]);
        assert_null(strchr(result->out, '\033'));
        assert_null(strchr(result->err, '\033'));
        assert_null(strstr(result->out, "\302\233"));
        assert_null(strstr(result->err, "\302\233"));
        if (i < 2)
            assert_contains(result->out, "a?[31m?1mz");
    }
    usb_display_unplug(&display);
}

/* In the guest's time, which no other program takes. Also where the kernel's own driver waits for the same device, which holds
 * back everybody who opens it. */
static void the_list_answers_in_time_whatever_a_device_does(void **state)
{
    (void)state;
    static const struct {
        uint16_t vendor, product;
        uint8_t request;
    } silent[] = {
        {0x1209, 1, GUD_GET_DESCRIPTOR}, {0x1209, 1, GUD_GET_CONNECTOR_MODES}, {0x1d50, 0x614d, GUD_GET_DESCRIPTOR}};
    for (size_t i = 0; i < sizeof silent / sizeof *silent; i++) {
        usb_displays_unplug(NULL);
        honest();
        config.ids.vendor = silent[i].vendor;
        config.ids.product = silent[i].product;
        config.trouble = CONTROL_SILENT;
        config.trouble_lasts = true;
        config.trouble_ms = 4000;
        config.trouble_request = silent[i].request;
        usb_display_be(&display, &config);
        struct timespec from, to;
        clock_gettime(CLOCK_MONOTONIC, &from);
        const struct run *result = run("$GLINT list");
        clock_gettime(CLOCK_MONOTONIC, &to);
        assert_int_equal(result->status, 0);
        assert_contains(result->out, "\nnone ");
        const double seconds = (double)(to.tv_sec - from.tv_sec) + 1e-9 * (double)(to.tv_nsec - from.tv_nsec);
        if (seconds > 2)
            fail_msg("silent to request %#x, %04x: %.1f s", silent[i].request, silent[i].vendor, seconds);
    }
    usb_displays_unplug(NULL);
}

static void an_hours_stream_keeps_its_memory_and_its_descriptors(void **state)
{
    (void)state;
    usb_displays_unplug(NULL);
    honest();
    usb_display_be(&display, &config);
    const pid_t stream = start("exec " STREAM OURS "--fps 1 --period 7.3");
    keeps_what_it_has_for_an_hour(stream);
    assert_true(display.seen->rectangles > 3590);
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    usb_display_unplug(&display);
}

/* ---- signals ---- */

static void an_interrupt_ends_waiting(void **state)
{
    (void)state;
    usb_displays_unplug(NULL);
    const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
    assert_true(terminal >= 0 && grantpt(terminal) == 0 && unlockpt(terminal) == 0);
    const pid_t stream = start_to(ptsname(terminal), "exec " STREAM "--wait --serial none");
    char text[1000] = "";
    for (size_t length = 0; !strstr(text, "waiting for a USB display; Ctrl-C ends it");) {
        const ssize_t count = read(terminal, text + length, sizeof text - 1 - length);
        assert_true(count > 0);
        length += (size_t)count;
    }
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    close(terminal);
}

static void every_signal_that_ends_a_stream_switches_the_display_off(void **state)
{
    (void)state;
    static const int signals[] = {SIGHUP,  SIGINT,  SIGQUIT,   SIGTERM, SIGPIPE, SIGUSR1,
                                  SIGUSR2, SIGALRM, SIGVTALRM, SIGPROF, SIGXCPU, SIGXFSZ};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        print_message("signal %d\n", signals[i]);
        usb_displays_unplug(NULL);
        honest();
        usb_display_be(&display, &config);
        const pid_t stream = start("exec env --default-signal=PIPE --default-signal=XFSZ " STREAM OURS);
        assert_soon(display.seen->rectangles > 1);
        kill(stream, signals[i]);
        assert_exits(stream, 128 + signals[i]);
        assert_soon(!display.seen->display && !display.seen->controller);
    }
}

static void an_interrupt_ends_requests_and_data_that_are_not_taken(void **state)
{
    (void)state;
    trouble(BULK_NAK, true);
    pid_t stream = start("exec " STREAM OURS);
    assert_soon(display.seen->rectangles == 1);
    usleep(300000);
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    assert_soon(!display.seen->display);
    honest();
    config.trouble = CONTROL_SILENT;
    config.trouble_ms = 2000;
    config.trouble_request = GUD_GET_CONNECTOR_MODES;
    usb_display_be(&display, &config);
    stream = start("exec " STREAM OURS);
    assert_soon(display.seen->request_count > 0 &&
                display.seen->requests[display.seen->request_count - 1] == GUD_GET_CONNECTOR_MODES);
    kill(stream, SIGINT);
    assert_exits(stream, 130);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(another_programs_display_is_left_to_it),
        cmocka_unit_test(wait_gives_another_program_a_moment_and_no_longer),
        cmocka_unit_test(a_display_without_permission_is_told_apart_from_none),
        cmocka_unit_test(wait_gives_udev_a_moment_and_no_longer),
        cmocka_unit_test(the_kernels_display_is_taken_only_by_detach_and_given_back),
        cmocka_unit_test(of_two_displays_one_is_to_be_named),
        cmocka_unit_test(a_device_whose_interface_is_not_guds_is_asked_only_by_name),
        cmocka_unit_test(what_a_device_says_of_itself_reaches_the_terminal_without_control_characters),
        cmocka_unit_test(the_list_answers_in_time_whatever_a_device_does),
        cmocka_unit_test(an_hours_stream_keeps_its_memory_and_its_descriptors),
        cmocka_unit_test(an_interrupt_ends_waiting),
        cmocka_unit_test(every_signal_that_ends_a_stream_switches_the_display_off),
        cmocka_unit_test(an_interrupt_ends_requests_and_data_that_are_not_taken),
    };
    return cmocka_run_group_tests_name("usb sharing", tests, scratch_make, clean);
}
