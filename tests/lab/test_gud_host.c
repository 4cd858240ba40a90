/* SPDX-License-Identifier: MIT
 * glint-gadget and a host that gives up in the middle: request by request, past the kernel's driver. In the environment:
 * GADGET, the program. */
#include "unit.h"

#include "lab.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/usbdevice_fs.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

enum { WIDTH = 61, HEIGHT = 47, FRAME = 2 * WIDTH * HEIGHT, TIMEOUT_MS = 2000 };
#define PICTURE "/run/picture"

static struct process gadget;
static int usb = -1;
static unsigned endpoint; /* where the controller has one: not always the first */

static int control(uint8_t type, uint8_t request, void *data, uint16_t length)
{
    struct usbdevfs_ctrltransfer transfer = {type, request, 0, 0, length, TIMEOUT_MS, data};
    return ioctl(usb, USBDEVFS_CONTROL, &transfer);
}

static unsigned status(void)
{
    uint8_t byte;
    assert_int_equal(control(0xc1, 0x00, &byte, 1), 1);
    return byte;
}

/* Which the gadget acknowledges before it has seen the data: the status tells. */
static unsigned status_of(uint8_t request, const void *data, uint16_t length)
{
    uint8_t bytes[64];
    memcpy(bytes, data, length);
    assert_int_equal(control(0x41, request, bytes, length), length);
    return status();
}

static void set(uint8_t request, const void *data, uint16_t length)
{
    assert_int_equal(status_of(request, data, length), 0);
}

static int bulk(const uint8_t *bytes, unsigned count)
{
    struct usbdevfs_bulktransfer transfer = {endpoint, count, TIMEOUT_MS, (void *)(uintptr_t)bytes};
    return ioctl(usb, USBDEVFS_BULK, &transfer);
}

static unsigned status_of_buffer(unsigned x, unsigned y, unsigned width, unsigned height)
{
    uint8_t data[25] = {0};
    const unsigned values[] = {x, y, width, height, 2 * width * height};
    for (unsigned i = 0; i < 5; i++)
        for (unsigned b = 0; b < 4; b++)
            data[4 * i + b] = (uint8_t)(values[i] >> 8 * b);
    return status_of(0x60, data, sizeof data);
}

static void set_buffer(unsigned x, unsigned y, unsigned width, unsigned height)
{
    assert_int_equal(status_of_buffer(x, y, width, height), 0);
}

static void begin(void)
{
    uint8_t state[26] = {0};
    assert_int_equal(ioctl(usb, USBDEVFS_CLAIMINTERFACE, &(unsigned){0}), 0);
    assert_int_equal(control(0xc1, 0x55, state, 24), 24);
    state[24] = 0x40;
    set(0x63, "\1", 1);
    set(0x61, state, sizeof state);
    set(0x62, "", 0);
    set(0x64, "\1", 1);
}

/* IDs that the kernel's driver does not take. */
static void plug_in(void)
{
    char number[16] = "", path[64];
    unlink(PICTURE);
    process_start(&gadget, "$GADGET --size %dx%d --formats rgb565 --vid-pid 1209:0001 -o " PICTURE, WIDTH, HEIGHT);
    wait_for_file("/sys/bus/usb/devices/1-1:1.0");
    const int device = open("/sys/bus/usb/devices/1-1/devnum", O_RDONLY);
    assert_true(device >= 0 && read(device, number, sizeof number - 1) > 0);
    close(device);
    size_t size;
    char *name = run_for_output(&size, "cd /sys/bus/usb/devices/1-1:1.0 && echo ep_*");
    assert_int_equal(sscanf(name, "ep_%x", &endpoint), 1);
    free(name);
    snprintf(path, sizeof path, "/dev/bus/usb/001/%03d", atoi(number));
    usb = open(path, O_RDWR);
    assert_true(usb >= 0);
    begin();
}

static int clean(void **state)
{
    if (usb >= 0)
        close(usb);
    usb = -1;
    return lab_clean(state);
}

/* The rectangle as the gadget has it when it ends: grey, of this level in each byte. */
static void assert_grey(unsigned x, unsigned y, unsigned width, unsigned height, uint8_t level)
{
    static uint8_t found[HEIGHT][WIDTH][3];
    close(usb);
    usb = -1;
    assert_int_equal(process_end(&gadget, SIGTERM), 0);
    FILE *file = fopen(PICTURE, "r");
    assert_true(file && fread(found, sizeof found, 1, file) == 1);
    fclose(file);
    for (unsigned i = 0; i < width * height; i++)
        for (unsigned c = 0; c < 3; c++)
            assert_int_equal(found[y + i / width][x + i % width][c], level);
}

/* Whole packets, so that its read does not end: the next rectangle must not be taken for the rest of it. */
static void a_rectangle_that_was_given_up_leaves_nothing_to_the_next(void **state)
{
    (void)state;
    static uint8_t white[FRAME], black[FRAME];
    memset(white, 0xff, sizeof white);
    plug_in();
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(white, 1024), 1024);
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(black, FRAME), FRAME);
    assert_int_equal(status(), 0);
    assert_grey(0, 0, WIDTH, HEIGHT, 0);
}

/* After the request and nothing else, several times. */
static void a_host_that_only_announces_does_not_block_the_next_rectangle(void **state)
{
    (void)state;
    static uint8_t white[FRAME];
    memset(white, 0xff, sizeof white);
    plug_in();
    for (unsigned i = 0; i < 5; i++)
        set_buffer(0, i, WIDTH, HEIGHT - i);
    set_buffer(3, 2, 4, 5);
    assert_int_equal(bulk(white, 40), 40);
    assert_int_equal(status(), 0);
    assert_grey(3, 2, 4, 5, 255);
}

/* What comes without a rectangle waits on the bus until the host minds, and the next rectangle is drawn. */
static void bytes_that_were_not_announced_are_not_drawn(void **state)
{
    (void)state;
    static uint8_t white[FRAME], black[FRAME];
    memset(white, 0xff, sizeof white);
    plug_in();
    assert_int_equal(bulk(white, 512), -1);
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(black, FRAME), FRAME);
    assert_grey(0, 0, WIDTH, HEIGHT, 0);
}

/* A controller that is disabled within a rectangle and enabled again. */
static void disabled_amid_a_rectangle_it_draws_the_one_after(void **state)
{
    (void)state;
    static uint8_t white[FRAME], black[FRAME];
    memset(white, 0xff, sizeof white);
    plug_in();
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(white, 512), 512);
    set(0x63, "\0", 1);
    set(0x63, "\1", 1);
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(black, FRAME), FRAME);
    assert_int_equal(status(), 0);
    assert_grey(0, 0, WIDTH, HEIGHT, 0);
}

static void a_bus_reset_forgets_what_the_host_had_set(void **state)
{
    (void)state;
    static uint8_t white[FRAME], black[FRAME];
    memset(white, 0xff, sizeof white);
    plug_in();
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(white, 512), 512);
    assert_int_equal(ioctl(usb, USBDEVFS_RESET, 0), 0);
    assert_int_equal(status_of_buffer(0, 0, WIDTH, HEIGHT), 3); /* GUD_STATUS_PROTOCOL_ERROR: nothing is enabled */
    begin();
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(black, FRAME), FRAME);
    assert_int_equal(status(), 0);
    assert_grey(0, 0, WIDTH, HEIGHT, 0);
}

/* With a STALL, in either direction, and the status says why; what follows is as before. */
static void wrong_requests_are_refused(void **state)
{
    (void)state;
    static const struct {
        uint8_t type, request, length;
        unsigned status;
    } wrong[] = {{0xc1, 0x7f, 8, 2}, {0x41, 0x7f, 0, 2}, {0x41, 0x7f, 8, 2}, {0x41, 0x60, 24, 3}, {0xc1, 0x60, 25, 2}};
    static uint8_t white[FRAME];
    uint8_t data[64] = {0};
    memset(white, 0xff, sizeof white);
    plug_in();
    for (unsigned i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        errno = 0;
        if (control(wrong[i].type, wrong[i].request, data, wrong[i].length) != -1 || errno != EPIPE)
            fail_msg("request %02x %02x is not refused: %s", wrong[i].type, wrong[i].request, strerror(errno));
        assert_int_equal(status(), wrong[i].status);
    }
    set_buffer(0, 0, WIDTH, HEIGHT);
    assert_int_equal(bulk(white, FRAME), FRAME);
    assert_int_equal(status(), 0);
    assert_grey(0, 0, WIDTH, HEIGHT, 255);
}

static void a_moment(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 100000000}, NULL);
}

/* It is stopped (Ctrl-Z) while the host asks, until nobody waits for the answer any more. */
static void give_up_on(bool in)
{
    uint8_t data[30] = {1};
    plug_in();
    kill(gadget.pid, SIGSTOP);
    assert_int_equal(in ? control(0xc1, 0x01, data, sizeof data) : control(0x41, 0x63, data, 1), -1);
}

/* Also where the signal is there before it goes on. */
static void a_host_that_gave_up_on_a_request_does_not_keep_it_from_ending(void **state)
{
    for (unsigned i = 0; i < 4; i++) {
        give_up_on(i % 2);
        if (i / 2)
            kill(gadget.pid, SIGTERM);
        kill(gadget.pid, SIGCONT);
        a_moment();
        assert_int_equal(process_end(&gadget, i / 2 ? 0 : SIGTERM), 0);
        clean(state);
    }
}

static void stopped_and_continued_within_a_request_it_answers_the_next(void **state)
{
    for (unsigned in = 0; in < 2; in++) {
        give_up_on(in);
        for (unsigned i = 0; i < 2; i++) {
            kill(gadget.pid, SIGCONT);
            a_moment();
            kill(gadget.pid, SIGSTOP);
            a_moment();
        }
        kill(gadget.pid, SIGCONT);
        assert_int_equal(status(), 0);
        assert_int_equal(process_end(&gadget, SIGTERM), 0);
        clean(state);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(a_rectangle_that_was_given_up_leaves_nothing_to_the_next, clean),
        cmocka_unit_test_teardown(a_host_that_only_announces_does_not_block_the_next_rectangle, clean),
        cmocka_unit_test_teardown(bytes_that_were_not_announced_are_not_drawn, clean),
        cmocka_unit_test_teardown(disabled_amid_a_rectangle_it_draws_the_one_after, clean),
        cmocka_unit_test_teardown(wrong_requests_are_refused, clean),
        cmocka_unit_test_teardown(a_bus_reset_forgets_what_the_host_had_set, clean),
        cmocka_unit_test_teardown(a_host_that_gave_up_on_a_request_does_not_keep_it_from_ending, clean),
        cmocka_unit_test_teardown(stopped_and_continued_within_a_request_it_answers_the_next, clean),
    };
    return cmocka_run_group_tests_name("gud host", tests, NULL, NULL);
}
