/* SPDX-License-Identifier: MIT
 * Data and devices that go astray: the picture is whole again, or the user reads why not. */
#include "light_protocol.h"
#include "usb_run.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/stat.h>

/* ---- data that fails ---- */

/* The last frame of such a stream is on the display, bit by bit. */
static void assert_last_frame_of(const char *options)
{
    static uint8_t frame[120 * 80 * 2];
    char command[200];
    snprintf(command, sizeof command, "$GLINT stream watchface --to raw --size 120x80 %s | tail -c %zu >frame.raw",
             options, sizeof frame);
    assert_ends(command, 0, "");
    FILE *file = fopen("frame.raw", "r");
    assert_non_null(file);
    assert_int_equal(fread(frame, 1, sizeof frame, file), sizeof frame);
    fclose(file);
    assert_soon(!display.seen->display);
    assert_memory_equal(display.seen->picture, frame, sizeof frame);
}

static void assert_last_frame(unsigned frames)
{
    char options[40];
    snprintf(options, sizeof options, "--frames %u --fps 10", frames);
    assert_last_frame_of(options);
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

static void a_halted_endpoint_is_cleared_and_the_picture_sent_again(void **state)
{
    (void)state;
    trouble(BULK_STALL, false);
    assert_recovers("", "the picture's data: it refuses (STALL); reinitialising it");
}

static void a_display_of_whole_frames_gets_no_rectangle_after_a_fault_either(void **state)
{
    (void)state;
    trouble(BULK_STALL, false);
    struct gud_descriptor d = descriptor();
    d.flags = GUD_FLAG_FULL_UPDATE;
    set_descriptor(d);
    usb_display_be(&display, &config);
    assert_recovers("", "the picture's data: it refuses (STALL); reinitialising it");
    for (size_t i = 0; i < display.seen->request_count; i++)
        assert_int_not_equal(display.seen->requests[i], GUD_SET_BUFFER);
    assert_int_equal(display.seen->protocol_errors, 0);
}

/* In parts that are more than half of what 16 bits count. */
static void a_tall_picture_is_sent_again_to_its_end(void **state)
{
    (void)state;
    usb_display_defaults(&config, 1, 16384); /* the longest side */
    struct gud_descriptor d = descriptor();
    d.compression = 0;
    d.max_buffer = 2 * 10000;
    set_descriptor(d);
    config.trouble = BULK_STALL;
    usb_display_be(&display, &config);
    assert_ends("timeout 30 " STREAM OURS "--frames 1", 0, "reinitialising it");
    assert_int_equal(display.seen->rectangles, 2);
}

static void the_only_picture_of_a_stream_is_sent_again_too(void **state)
{
    (void)state;
    trouble(BULK_STALL, false);
    config.trouble_at = 0;
    usb_display_be(&display, &config);
    assert_one_line(assert_ends("timeout 60 " STREAM OURS "--frames 1 --fps 10", 0, "reinitialising it")->err);
    assert_last_frame(1);
}

static void a_display_unplugged_within_the_last_picture_is_a_failure(void **state)
{
    (void)state;
    trouble(UNPLUG, false);
    config.trouble_at = 0;
    usb_display_be(&display, &config);
    assert_one_line(assert_ends("timeout 60 " STREAM OURS "--frames 1 --fps 10", 1, "unplugged")->err);
    usb_display_unplug(&display);
}

static void be_busy(void)
{
    honest();
    config.trouble = CONTROL_STALL;
    config.trouble_lasts = true;
    config.trouble_request = GUD_SET_BUFFER;
    config.trouble_status = GUD_BUSY;
    usb_display_be(&display, &config);
}

/* As long as a board holds the light of another program that has just ended. */
static void a_display_that_is_busy_for_some_seconds_is_waited_for(void **state)
{
    (void)state;
    be_busy();
    const pid_t stream = start("exec " STREAM OURS "--frames 4 --fps 10");
    assert_soon(memchr(display.seen->requests, GUD_SET_BUFFER, display.seen->request_count));
    usleep(LIGHT_HELD_MS * 1000);
    display.seen->config.trouble = NO_TROUBLE;
    assert_exits(stream, 0);
    char text[1000];
    read_text("stream.err", text, sizeof text);
    assert_one_line(text);
    assert_contains(text, "it refuses (STALL; status 1: busy); reinitialising it");
    assert_last_frame(4);
}

static void a_display_that_stays_busy_ends_the_stream(void **state)
{
    (void)state;
    be_busy();
    assert_ends("timeout 60 " STREAM OURS "--frames 1", 1, "end the program that gives it light");
}

static void an_endpoint_that_halts_again_and_again_ends_the_stream(void **state)
{
    (void)state;
    trouble(BULK_STALL, true);
    assert_one_line(
        strchr(assert_ends("timeout 60 " STREAM OURS, 1,
                           "it refuses (STALL), and again after 3 attempts to reinitialise it; plug it in again")
                   ->err,
               '\n') +
        1);
    assert_soon(!display.seen->display);
    usb_display_unplug(&display);
}

static void a_display_that_takes_no_data_is_reinitialised(void **state)
{
    (void)state;
    trouble(BULK_NAK, false);
    assert_recovers("", "the picture's data: it does not answer; reinitialising it");
}

static void a_display_that_never_takes_data_again_ends_the_stream(void **state)
{
    (void)state;
    trouble(BULK_NAK, true);
    assert_ends("timeout 60 " STREAM OURS, 1,
                "it does not answer, and again after 3 attempts to reinitialise it; plug it in again");
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

static void reset(void)
{
    const char *node = run("ls /dev/bus/usb/001/* | tail -1 | tr -d '\\n'")->out;
    const int file = open(node, O_RDWR);
    assert_true(file >= 0);
    assert_int_equal(ioctl(file, USBDEVFS_RESET, NULL), 0);
    close(file);
}

static void a_display_reset_by_another_program_shows_the_whole_picture_again(void **state)
{
    (void)state;
    honest();
    usb_display_be(&display, &config);
    const pid_t stream = start("exec " STREAM OURS "--frames 30 --fps 10");
    assert_soon(display.seen->rectangles > 1);
    reset();
    assert_soon(display.seen->starts > 0 && display.seen->display);
    assert_exits(stream, 0);
    char text[1000];
    read_text("stream.err", text, sizeof text);
    assert_one_line(text);
    assert_contains(text, "reinitialising it");
    assert_last_frame(30);
}

static pid_t start_still(const char *options)
{
    char command[200];
    honest();
    usb_display_be(&display, &config);
    snprintf(command, sizeof command, "exec " STREAM OURS "--period 0 --fps 5 %s", options);
    const pid_t stream = start(command);
    assert_soon(display.seen->rectangles > 0);
    return stream;
}

static void a_picture_that_stands_still_returns_with_its_display(void **state)
{
    (void)state;
    const pid_t stream = start_still("--wait");
    for (unsigned i = 0; i < 2; i++) {
        usb_display_unplug(&display);
        usb_display_be(&display, &config);
        assert_soon(display.seen->display && display.seen->bulk_bytes > 0);
    }
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    assert_last_frame_of("--period 0 --frames 1");
}

static void a_picture_that_stands_still_is_whole_again_after_a_reset(void **state)
{
    (void)state;
    const pid_t stream = start_still("");
    reset();
    assert_soon(display.seen->starts > 0 && display.seen->display);
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    char text[1000];
    read_text("stream.err", text, sizeof text);
    assert_one_line(text);
    assert_contains(text, "reinitialising it");
    assert_last_frame_of("--period 0 --frames 1");
}

static void assert_ends_unplugged(pid_t stream)
{
    char text[1000];
    usb_display_unplug(&display);
    assert_exits(stream, 1);
    read_text("stream.err", text, sizeof text);
    assert_one_line(text);
    assert_contains(text, "unplugged; start again when it is back, or use --wait");
}

static void a_picture_that_stands_still_ends_with_a_display_that_is_unplugged(void **state)
{
    (void)state;
    assert_ends_unplugged(start_still(""));
}

/* Its lights come by a pipe, and no more of them. */
static void a_display_that_is_unplugged_while_no_light_comes_is_noticed(void **state)
{
    (void)state;
    honest();
    usb_display_be(&display, &config);
    assert_true(mkfifo("lights", 0600) == 0 || errno == EEXIST);
    const int lights = open("lights", O_RDWR | O_CLOEXEC);
    assert_true(lights >= 0);
    assert_int_equal(write(lights, "0 0 1\n", 6), 6);
    pid_t stream = start("exec " STREAM OURS "--lights lights --wait");
    assert_soon(display.seen->rectangles > 0);
    usb_display_unplug(&display);
    usb_display_be(&display, &config);
    assert_soon(display.seen->display && display.seen->bulk_bytes > 0);
    assert_int_equal(write(lights, "0 0 1\n", 6), 6); /* the stream goes on, with the picture as it was */
    kill(stream, SIGINT);
    assert_exits(stream, 130);
    assert_last_frame_of("--period 0 --light 0,0,1 --frames 1");
    honest();
    usb_display_be(&display, &config);
    assert_int_equal(write(lights, "0 0 1\n", 6), 6);
    stream = start("exec " STREAM OURS "--lights lights");
    assert_soon(display.seen->rectangles > 0);
    assert_ends_unplugged(stream);
    close(lights);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_halted_endpoint_is_cleared_and_the_picture_sent_again),
        cmocka_unit_test(a_display_of_whole_frames_gets_no_rectangle_after_a_fault_either),
        cmocka_unit_test(a_tall_picture_is_sent_again_to_its_end),
        cmocka_unit_test(the_only_picture_of_a_stream_is_sent_again_too),
        cmocka_unit_test(a_display_unplugged_within_the_last_picture_is_a_failure),
        cmocka_unit_test(a_display_that_is_busy_for_some_seconds_is_waited_for),
        cmocka_unit_test(a_display_that_stays_busy_ends_the_stream),
        cmocka_unit_test(an_endpoint_that_halts_again_and_again_ends_the_stream),
        cmocka_unit_test(a_display_that_takes_no_data_is_reinitialised),
        cmocka_unit_test(a_display_that_never_takes_data_again_ends_the_stream),
        cmocka_unit_test(a_display_unplugged_within_a_frame_ends_the_stream),
        cmocka_unit_test(a_display_that_comes_back_is_waited_for_and_shows_the_whole_picture),
        cmocka_unit_test(a_display_reset_by_another_program_shows_the_whole_picture_again),
        cmocka_unit_test(a_picture_that_stands_still_returns_with_its_display),
        cmocka_unit_test(a_picture_that_stands_still_is_whole_again_after_a_reset),
        cmocka_unit_test(a_picture_that_stands_still_ends_with_a_display_that_is_unplugged),
        cmocka_unit_test(a_display_that_is_unplugged_while_no_light_comes_is_noticed),
    };
    return cmocka_run_group_tests_name("usb faults", tests, scratch_make, clean);
}
