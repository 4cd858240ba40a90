/* SPDX-License-Identifier: MIT
 * Bytes a second of the usb sink, beside a bare loop of libusb calls that wait, to the same display. A figure, no test: how
 * fast is the simulated controller's affair, so only the quotient says something. */
#include "unit.h"

#include <libusb.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "sinks/sinks.h"
#include "sinks/usb/options.h"
#include "usb_display.h"

#include "gud_protocol.h"

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static uint8_t pixels[USB_PICTURE_MAX];

static double sink_rate(uint16_t width, uint16_t height, unsigned frames)
{
    char *argv[] = {(char *)"rate", (char *)"--vid-pid", (char *)"1209:0001", NULL};
    argp_parse(&usb_options_argp, 3, argv, 0, NULL, NULL);
    struct sink *sink = sink_usb.pixels.open(&(struct sink_wish){.format = GLINT_RGB565});
    const struct frame frame = {width, height, GLINT_RGB565, 2 * (size_t)width, pixels};
    const size_t bytes = 2 * (size_t)width * height;
    const struct piece piece = {{0, 0, width, height}, false, bytes, bytes, pixels};
    sink_usb.pixels.send(sink, &frame, &piece, 1);
    const double start = now();
    for (unsigned i = 0; i < frames; i++)
        assert_int_equal(sink_usb.pixels.send(sink, &frame, &piece, 1), SINK_SENT);
    const double end = now(); /* the last is still under way, as the one before was at the start */
    sink_usb.pixels.close(sink);
    return frames * (double)bytes / (end - start);
}

/* And of its bulk calls alone. */
static double bare_rate(uint16_t width, uint16_t height, unsigned frames, double *bulk)
{
    libusb_context *context;
    assert_int_equal(libusb_init(&context), 0);
    libusb_device_handle *handle = libusb_open_device_with_vid_pid(context, 0x1209, 1);
    assert_non_null(handle);
    assert_int_equal(libusb_claim_interface(handle, 0), 0);
    struct libusb_config_descriptor *configuration;
    assert_int_equal(libusb_get_active_config_descriptor(libusb_get_device(handle), &configuration), 0);
    const uint8_t endpoint = configuration->interface[0].altsetting[0].endpoint[0].bEndpointAddress;
    libusb_free_config_descriptor(configuration);
    uint8_t set[GUD_RECTANGLE_BYTES], on = 1;
    const size_t bytes = 2 * (size_t)width * height;
    gud_rectangle_pack(set, &(struct gud_rectangle){0, 0, width, height, (uint32_t)bytes, 0, 0});
    libusb_control_transfer(handle, 0x41, GUD_SET_CONTROLLER_ENABLE, 0, 0, &on, 1, 5000);
    double within = 0;
    const double start = now();
    for (unsigned i = 0; i < frames; i++) {
        int moved;
        assert_int_equal(libusb_control_transfer(handle, 0x41, GUD_SET_BUFFER, 0, 0, set, sizeof set, 5000),
                         sizeof set);
        const double before = now();
        assert_int_equal(libusb_bulk_transfer(handle, endpoint, pixels, (int)bytes, &moved, 3000), 0);
        within += now() - before;
    }
    const double end = now();
    libusb_release_interface(handle, 0);
    libusb_close(handle);
    libusb_exit(context);
    *bulk = frames * (double)bytes / within;
    return frames * (double)bytes / (end - start);
}

enum { TURNS = 15 };

static int compare(const void *a, const void *b)
{
    return (*(const double *)a > *(const double *)b) - (*(const double *)a < *(const double *)b);
}

/* Sorts. */
static double median(double values[TURNS])
{
    qsort(values, TURNS, sizeof *values, compare);
    return values[TURNS / 2];
}

/* By turns, and each quotient of two that follow one another: the machine does other things, too. */
static void measure(uint16_t width, uint16_t height, bool full_speed, unsigned frames)
{
    static struct usb_display display;
    struct usb_display_config config;
    usb_display_defaults(&config, width, height);
    config.ids.full_speed = full_speed;
    usb_display_be(&display, &config);
    double sink[TURNS], bare[TURNS], bulk[TURNS], share[TURNS];
    for (unsigned i = 0; i < TURNS; i++) {
        if (i % 2)
            sink[i] = sink_rate(width, height, frames);
        bare[i] = bare_rate(width, height, frames, &bulk[i]);
        if (i % 2 == 0)
            sink[i] = sink_rate(width, height, frames);
        share[i] = 100 * sink[i] / bare[i];
    }
    printf("%ux%u, %s speed: sink %.0f KB/s; waiting calls %.0f KB/s, their bulk alone %.0f KB/s; ", width, height,
           full_speed ? "full" : "high", median(sink) / 1e3, median(bare) / 1e3, median(bulk) / 1e3);
    const double middle = median(share);
    printf("sink/waiting calls %.0f %% (%.0f to %.0f %%)\n", middle, share[0], share[TURNS - 1]);
    usb_display_unplug(&display);
}

static void rates(void **state)
{
    (void)state;
    measure(320, 240, true, 10);
    measure(320, 240, false, 40);
    measure(1920, 1080, false, 5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(rates)};
    return cmocka_run_group_tests_name("usb rate", tests, NULL, usb_displays_unplug);
}
