/* SPDX-License-Identifier: MIT
 * A GUD display on a Linux board with a USB device controller: configfs makes the gadget, FunctionFS brings requests and
 * bulk bytes to this program, firmware/core/gud_device.c answers. */
#ifndef GADGET_H
#define GADGET_H

#include <argp.h>
#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "framebuffer.h"
#include "gud_device.h"

/* One line on standard error, "glint-gadget: ...", and exit 1, after taking down what was set up. */
_Noreturn void fail(const char *format, ...) __attribute__((format(printf, 1, 2)));
void warn(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* ---- options (options.c) ---- */

struct options {
    uint16_t width, height;
    uint8_t formats[GUD_FORMATS_MAX], format_count;
    uint32_t max_buffer; /* 0: a whole frame */
    bool lz4, verbose;
    unsigned each; /* files, one after each rectangle, at most; 0: none */
    uint32_t vid_pid;
    const char *serial, *udc, *name, *speed, *output, *framebuffer;
};
extern const struct argp gadget_argp; /* its input is struct options, filled by options_default first */
void options_default(struct options *options);

/* ---- the picture (picture.c) ---- */

struct picture {
    uint16_t width, height;
    uint8_t *pixels; /* r, g, b */
    const char *output;
    unsigned each, files; /* numbered files: at most, and written */
    struct framebuffer framebuffer;
    struct glint_box box; /* the rectangle being drawn, and its next line */
    uint16_t next;
    bool shown;
};
/* Fails where the framebuffer cannot be used, or options.output not be written. */
void picture_open(struct picture *picture, const struct options *options);
/* To options.output, whole or not at all. False: it warned. */
bool picture_write(const struct picture *picture);
extern const struct gud_device_ops picture_ops; /* their context is the picture */

/* ---- configfs (configfs.c) ---- */

/* Creates the gadget and mounts its FunctionFS; returns the mount point. Fails with what is missing. */
const char *configfs_create(const struct options *options);
void configfs_remove(void);
/* On the bus and off; false where the controller is not there. */
bool configfs_plug(void);
bool configfs_unplug(void);
bool configfs_is_lost(void); /* plugged by this program, unbound by another or with its controller */
const char *configfs_udc(void);

/* ---- FunctionFS (functionfs.c) ---- */

enum usb_event { USB_RESET, USB_SUSPEND, USB_RESUME };
/* What runs behind the endpoints; the calls are serialised. */
struct usb_function {
    int (*setup)(void *context, const struct gud_setup *setup, uint8_t reply[GUD_REPLY_BYTES]);
    bool (*set)(void *context, const struct gud_setup *setup, const uint8_t *data);
    uint32_t (*expects)(void *context);
    void (*bulk)(void *context, const uint8_t *bytes, size_t count);
    void (*event)(void *context, enum usb_event event);
    void *context;
};
/* From here on signals wait for functionfs_run: before there is anything to take down. */
void functionfs_hold_signals(void);
/* Descriptors, then the gadget on the bus, then requests until SIGINT, SIGTERM, SIGHUP or SIGQUIT; SIGUSR1 calls `dump`. */
void functionfs_run(const char *folder, const struct usb_function *function, bool verbose, void (*dump)(void *context));
/* The endpoint stalls until the host clears it. Only from within usb_function.bulk. */
void functionfs_halt(void);

/* ---- the display (display.c) ---- */

struct display {
    struct gud_device device;
    struct gud_device_config config;
    struct picture picture;
    bool verbose;
    unsigned long rectangles, faults; /* drawn whole; cut short */
    unsigned long long bytes;         /* of bulk */
};
void display_open(struct display *display, const struct options *options);
struct usb_function display_function(struct display *display);
/* Everything: until a signal ends it. `function` as display_function gave it, or around it. False: the last picture could not
 * be written. */
bool display_run(struct display *display, const struct options *options, const struct usb_function *function);

#endif
