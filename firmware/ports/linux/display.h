/* SPDX-License-Identifier: MIT
 * A GUD display on a Linux board with a USB device controller: configfs makes the gadget, FunctionFS brings requests and
 * bulk bytes to this program, firmware/core/gud_device.c answers. */
#ifndef DISPLAY_H
#define DISPLAY_H

#include <stdbool.h>

#include "functionfs.h"
#include "gud_device.h"
#include "options.h"
#include "picture.h"

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
