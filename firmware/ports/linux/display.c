/* SPDX-License-Identifier: MIT
 * The portable GUD device with this board's memory and picture. */
#include <stdio.h>
#include <stdlib.h>

#include "configfs.h"
#include "display.h"
#include "message.h"

enum { REFRESH_HZ = 60, OUTPUT_BYTES = 3, WIDEST_BYTES = 4 };

static uint8_t *memory(size_t bytes)
{
    uint8_t *block = calloc(1, bytes);
    if (!block)
        fail("no memory for %zu bytes", bytes);
    return block;
}

void display_open(struct display *display, const struct options *options)
{
    display->verbose = options->verbose;
    picture_open(&display->picture, options);
    struct gud_device_config *c = &display->config;
    *c = (struct gud_device_config){.width = options->width,
                                    .height = options->height,
                                    .refresh_hz = REFRESH_HZ,
                                    .output = GLINT_RGB888,
                                    .formats = options->formats,
                                    .format_count = options->format_count,
                                    .status_after_set =
                                        true, /* FunctionFS has acknowledged when it hands over the data */
                                    .max_buffer = options->max_buffer,
                                    .lines_bytes = GUD_DEVICE_LINE_BYTES(options->width, WIDEST_BYTES, OUTPUT_BYTES),
                                    .ops = &picture_ops,
                                    .context = &display->picture};
    c->lines = memory(c->lines_bytes);
    if (options->lz4) {
        c->window_bytes = LZ4_BLOCK_REACH;
        c->window = memory(c->window_bytes);
    }
    if (!gud_device_init(&display->device, c))
        fail("%ux%u with a buffer of %u bytes is not possible", c->width, c->height, c->max_buffer);
}

static int setup(void *context, const struct gud_setup *setup, uint8_t *reply)
{
    return gud_device_setup(&((struct display *)context)->device, setup, reply);
}

static bool set(void *context, const struct gud_setup *setup, const uint8_t *data)
{
    struct display *display = context;
    const bool good = gud_device_set(&display->device, setup, data);
    if (display->verbose && setup->request == GUD_SET_BUFFER) {
        struct gud_rectangle r;
        gud_rectangle_unpack(&r, data);
        fprintf(stderr, "rectangle %u,%u %ux%u, %s%u bytes: %s\n", r.x, r.y, r.width, r.height,
                r.compression ? "LZ4 " : "raw ", r.compression ? r.compressed_length : r.length,
                good ? "good" : "refused");
    }
    return good;
}

static uint32_t expects(void *context)
{
    return gud_device_expects(&((struct display *)context)->device);
}

static void bulk(void *context, const uint8_t *bytes, size_t count)
{
    struct display *display = context;
    display->bytes += count;
    gud_device_bulk(&display->device, bytes, count);
    if (gud_device_expects(&display->device))
        return;
    if (display->device.status == GUD_OK)
        display->rectangles++;
    else
        display->faults++;
}

static void event(void *context, enum usb_event event)
{
    struct gud_device *device = &((struct display *)context)->device;
    if (event == USB_RESET)
        gud_device_reset(device);
    else if (event == USB_SUSPEND)
        gud_device_suspend(device);
    else
        gud_device_resume(device);
}

static void dump(void *context)
{
    (void)picture_write(&((struct display *)context)->picture);
}

struct usb_function display_function(struct display *display)
{
    return (struct usb_function){setup, set, expects, bulk, event, display};
}

static struct display *shown;
static void dump_shown(void *context)
{
    (void)context; /* may be another's, around the display */
    dump(shown);
}

/* However the program ends: the framebuffer is black. */
static void darken(void)
{
    gud_device_reset(&shown->device);
}

bool display_run(struct display *display, const struct options *options, const struct usb_function *function)
{
    shown = display;
    atexit(darken);
    functionfs_hold_signals();
    functionfs_run(configfs_create(options), function, options->verbose, dump_shown);
    configfs_remove();
    darken();
    const bool good = picture_write(&display->picture);
    if (options->verbose)
        fprintf(stderr, "%lu rectangles, %lu with faults, %llu bytes\n", display->rectangles, display->faults,
                display->bytes);
    return good;
}
