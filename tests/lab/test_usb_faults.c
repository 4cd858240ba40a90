/* SPDX-License-Identifier: MIT
 * What goes wrong with USB displays, and what the user reads of it. */
#include "run.h"

#include <fcntl.h>
#include <signal.h>
#include <stdbool.h>
#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include "gud_protocol.h"
#include "usb_display.h"

#define STREAM "$GLINT stream watchface --to usb "
#define OURS "--vid-pid 1209:0001 "

static struct usb_display_config config;
static struct usb_display display;

/* A stream that goes on while the test does; what it says on standard error goes to a file or a terminal. */
static pid_t start_to(const char *path, const char *command)
{
    const pid_t process = fork();
    assert_true(process >= 0);
    if (process == 0) {
        if (!freopen(path, "w", stderr))
            _exit(126);
        execl("/bin/sh", "sh", "-c", command, NULL);
        _exit(127);
    }
    return process;
}

static pid_t start(const char *command)
{
    return start_to("stream.err", command);
}

static void assert_exits(pid_t process, int status)
{
    int result;
    assert_int_equal(waitpid(process, &result, 0), process);
    assert_true(WIFEXITED(result));
    assert_int_equal(WEXITSTATUS(result), status);
}

static void honest(void)
{
    usb_display_defaults(&config, 120, 80);
}

static struct gud_descriptor descriptor(void)
{
    struct gud_descriptor d;
    gud_descriptor_unpack(&d, config.descriptor);
    return d;
}

static void set_descriptor(struct gud_descriptor d)
{
    gud_descriptor_pack(config.descriptor, &d);
}

/* ---- what it says of itself ---- */

static void assert_says(const char *part)
{
    usb_display_be(&display, &config);
    char whole[256];
    snprintf(whole, sizeof whole, "glint: usb 1-1 (1209:0001): %s", part);
    assert_fails("timeout 20 " STREAM OURS "--frames 1", whole);
}

static void a_missing_display_is_told_with_what_was_looked_for(void **state)
{
    (void)state;
    assert_fails(STREAM, "no USB display: no device has the IDs 1d50:614d, 16d0:10a9 or 1209:4fb3");
    assert_fails(STREAM "--serial 77 --vid-pid 1209:0001", "no USB device with serial number 77 with IDs 1209:0001");
    assert_fails(STREAM "--usb-path 9-1", "no USB device at 9-1");
}

static void a_descriptor_that_is_none_of_guds_is_named(void **state)
{
    (void)state;
    honest();
    config.descriptor[0] ^= 1;
    assert_says("it is no GUD display: its descriptor begins with 1d50614c, not 1d50614d");
    honest();
    config.descriptor[4] = 2;
    assert_says("it speaks GUD version 2; this glint knows version 1");
    honest();
    config.descriptor_bytes = 12;
    assert_says("it is no GUD display: its descriptor has 12 bytes, not 30");
}

static void sizes_that_cannot_be_are_refused(void **state)
{
    (void)state;
    honest();
    struct gud_descriptor d = descriptor();
    d.max_width = d.min_width = 0;
    set_descriptor(d);
    assert_says("its descriptor says that it is at most 0x80 pixels");
    honest();
    d = descriptor();
    d.min_height = 81;
    set_descriptor(d);
    assert_says("its descriptor says at least 120x81 and at most 120x80 pixels");
    honest();
    d = descriptor();
    d.max_buffer = 239;
    set_descriptor(d);
    assert_says("it takes 239 bytes a rectangle, and a line has 240");
    honest();
    d = descriptor();
    d.max_height = 79;
    d.min_height = 1;
    set_descriptor(d);
    assert_says("its mode 120x80 is not within its descriptor's 120x1 to 120x79 pixels");
    usb_display_defaults(&config, 65535, 65535);
    assert_says("its mode 65535x65535 takes 8589672450 bytes a frame");
}

static void lists_that_cannot_be_are_refused(void **state)
{
    (void)state;
    honest();
    config.formats_bytes = 0;
    assert_says("it offers no pixel format");
    honest();
    config.formats[0] = GUD_RGB332;
    config.formats[1] = 0x77;
    config.formats_bytes = 2;
    assert_says("it does not take any format of glint's; it offers rgb332, GUD's 77");
    honest();
    config.connectors_bytes = 0;
    assert_says("it has no connector");
    honest();
    config.connectors_bytes = 7;
    assert_says("its connectors take 7 bytes, which is not a multiple of 5");
    honest();
    config.status = GUD_DISCONNECTED;
    assert_says("no panel is connected to it");
    honest();
    config.status_bytes = 0;
    assert_says("connector 0 has a status of no bytes");
    honest();
    config.modes_bytes = 0;
    assert_says("it has no mode");
    honest();
    config.modes_bytes = 30;
    assert_says("its modes take 30 bytes, which is not a multiple of 24");
}

static void a_huge_max_buffer_and_long_lists_do_no_harm(void **state)
{
    (void)state;
    honest();
    struct gud_descriptor d = descriptor();
    d.max_buffer = 0xffffffff;
    set_descriptor(d);
    config.status = GUD_CONNECTION_UNKNOWN;
    config.connectors_bytes = 60;
    config.formats_bytes = 60;
    for (size_t i = 1; i < 170; i++)
        memcpy(config.modes + i * GUD_MODE_BYTES, config.modes, GUD_MODE_BYTES);
    config.modes_bytes = sizeof config.modes;
    usb_display_be(&display, &config);
    assert_ends(STREAM OURS "--frames 1", 0, "");
    assert_soon(display.seen->rectangles == 1);
}

/* ---- requests that fail ---- */

static void a_refused_request_is_told_with_its_status(void **state)
{
    (void)state;
    honest();
    config.trouble = CONTROL_STALL;
    config.trouble_lasts = true;
    config.trouble_request = GUD_SET_STATE_CHECK;
    config.trouble_status = GUD_PARAMETER;
    assert_says("the mode and format: it refuses (STALL; status 4: a value that cannot be)");
    config.trouble_request = GUD_GET_FORMATS;
    config.trouble_status = GUD_BUSY;
    assert_says("its formats: it refuses (STALL; status 1: busy)");
    config.trouble_request = GUD_GET_CONNECTOR_STATUS;
    config.trouble_status = 99;
    assert_says("a connector's status: it refuses (STALL; status 99: an unknown status)");
}

static void a_request_without_answer_ends_after_its_time(void **state)
{
    (void)state;
    honest();
    config.trouble = CONTROL_SILENT;
    config.trouble_ms = 6000;
    config.trouble_request = GUD_GET_CONNECTORS;
    assert_says("its connectors: it does not answer");
}

/* ---- data that fails ---- */

/* The last of so many frames is on the display, bit by bit. */
static void assert_last_frame(unsigned frames)
{
    static uint8_t frame[120 * 80 * 2];
    char command[200];
    snprintf(command, sizeof command,
             "$GLINT stream watchface --to raw --size 120x80 --frames %u --fps 10 | tail -c %zu >frame.raw", frames,
             sizeof frame);
    assert_ends(command, 0, "");
    FILE *file = fopen("frame.raw", "r");
    assert_non_null(file);
    assert_int_equal(fread(frame, 1, sizeof frame, file), sizeof frame);
    fclose(file);
    assert_soon(!display.seen->display);
    assert_memory_equal(display.seen->picture, frame, sizeof frame);
}

static void assert_recovers(const char *options, const char *words)
{
    char command[200];
    snprintf(command, sizeof command, "timeout 60 " STREAM OURS "--frames 4 --fps 10 %s", options);
    const struct run *result = assert_ends(command, 0, words);
    if (*words)
        assert_one_line(result->err);
    assert_last_frame(4);
}

static void trouble(enum usb_trouble what, bool lasts)
{
    honest();
    struct gud_descriptor d = descriptor();
    d.compression = 0;
    set_descriptor(d);
    config.trouble = what;
    config.trouble_at = 19200 + 50; /* within the second frame */
    config.trouble_lasts = lasts;
    usb_display_be(&display, &config);
}

static void a_halted_endpoint_is_cleared_and_the_picture_sent_again(void **state)
{
    (void)state;
    trouble(BULK_STALL, false);
    assert_recovers("", "the picture's data: it refuses (STALL); starting it anew");
}

static void an_endpoint_that_halts_again_and_again_ends_the_stream(void **state)
{
    (void)state;
    trouble(BULK_STALL, true);
    assert_ends("timeout 60 " STREAM OURS, 1, "it refuses (STALL), also after 3 new starts; plug it in again");
    assert_soon(!display.seen->display);
    usb_display_unplug(&display);
}

static void a_display_that_takes_no_data_is_started_anew(void **state)
{
    (void)state;
    trouble(BULK_NAK, false);
    assert_recovers("", "the picture's data: it does not answer; starting it anew");
}

static void a_display_that_never_takes_data_again_ends_the_stream(void **state)
{
    (void)state;
    trouble(BULK_NAK, true);
    assert_ends("timeout 60 " STREAM OURS, 1, "it does not answer, also after 3 new starts; plug it in again");
}

static void a_display_unplugged_within_a_frame_ends_the_stream(void **state)
{
    (void)state;
    trouble(UNPLUG, false);
    assert_ends("timeout 60 " STREAM OURS, 1, "unplugged; start again when it is back, or use --wait");
    usb_display_unplug(&display);
}

static void a_display_that_comes_back_is_waited_for_and_shows_the_whole_picture(void **state)
{
    (void)state;
    trouble(UNPLUG, false);
    config.trouble_ms = 1000;
    usb_display_be(&display, &config);
    assert_recovers("--wait", "");
    assert_true(display.seen->starts > 0);
}

static void a_display_reset_by_another_program_shows_the_whole_picture_again(void **state)
{
    (void)state;
    honest();
    usb_display_be(&display, &config);
    const pid_t stream = start("exec " STREAM OURS "--frames 30 --fps 10");
    assert_soon(display.seen->rectangles > 1);
    const char *node = run("ls /dev/bus/usb/001/* | tail -1 | tr -d '\\n'")->out;
    const int file = open(node, O_RDWR);
    assert_true(file >= 0);
    assert_int_equal(ioctl(file, USBDEVFS_RESET, NULL), 0);
    close(file);
    assert_soon(display.seen->starts > 0 && display.seen->display);
    assert_exits(stream, 0);
    char text[1000];
    read_text("stream.err", text, sizeof text);
    assert_one_line(text);
    assert_contains(text, "starting it anew");
    assert_last_frame(30);
}

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

static void a_display_without_permission_is_told_apart_from_none(void **state)
{
    (void)state;
    honest();
    usb_display_be(&display, &config);
    assert_ends("chmod 755 .; setpriv --reuid 65534 --clear-groups " STREAM OURS "--frames 1", 1,
                "permission denied; install glint's udev rule");
}

static void the_kernels_display_is_taken_only_by_detach_and_given_back(void **state)
{
    (void)state;
    usb_displays_unplug(NULL);
    honest();
    config.vendor = 0x1d50;
    config.product = 0x614d;
    usb_display_be(&display, &config);
    assert_soon(access("/sys/bus/usb/drivers/gud/1-1:1.0", F_OK) == 0);
    assert_contains(run("$GLINT list")->out, "1d50:614d  taken by the kernel (driver gud)  Lab display  serial lab");
    assert_fails(STREAM "--frames 1", "(1d50:614d): the kernel's driver gud has it; --detach takes the monitor away");
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
    config.serial = "left";
    second = config;
    second.serial = "right";
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

static void an_interrupt_switches_the_display_off(void **state)
{
    (void)state;
    honest();
    usb_display_be(&display, &config);
    const pid_t stream = start("exec " STREAM OURS);
    assert_soon(display.seen->rectangles > 1);
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    assert_soon(!display.seen->display && !display.seen->controller);
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

static int clean(void **state)
{
    usb_displays_unplug(state);
    return scratch_remove(state);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_missing_display_is_told_with_what_was_looked_for),
        cmocka_unit_test(a_descriptor_that_is_none_of_guds_is_named),
        cmocka_unit_test(sizes_that_cannot_be_are_refused),
        cmocka_unit_test(lists_that_cannot_be_are_refused),
        cmocka_unit_test(a_huge_max_buffer_and_long_lists_do_no_harm),
        cmocka_unit_test(a_refused_request_is_told_with_its_status),
        cmocka_unit_test(a_request_without_answer_ends_after_its_time),
        cmocka_unit_test(a_halted_endpoint_is_cleared_and_the_picture_sent_again),
        cmocka_unit_test(an_endpoint_that_halts_again_and_again_ends_the_stream),
        cmocka_unit_test(a_display_that_takes_no_data_is_started_anew),
        cmocka_unit_test(a_display_that_never_takes_data_again_ends_the_stream),
        cmocka_unit_test(a_display_unplugged_within_a_frame_ends_the_stream),
        cmocka_unit_test(a_display_that_comes_back_is_waited_for_and_shows_the_whole_picture),
        cmocka_unit_test(a_display_reset_by_another_program_shows_the_whole_picture_again),
        cmocka_unit_test(another_programs_display_is_left_to_it),
        cmocka_unit_test(a_display_without_permission_is_told_apart_from_none),
        cmocka_unit_test(the_kernels_display_is_taken_only_by_detach_and_given_back),
        cmocka_unit_test(of_two_displays_one_is_to_be_named),
        cmocka_unit_test(an_interrupt_ends_waiting),
        cmocka_unit_test(an_interrupt_switches_the_display_off),
        cmocka_unit_test(an_interrupt_ends_requests_and_data_that_are_not_taken),
    };
    return cmocka_run_group_tests_name("usb faults", tests, scratch_make, clean);
}
