/* SPDX-License-Identifier: MIT
 * Which USB devices are displays. */
#ifndef GLINT_USB_FIND_H
#define GLINT_USB_FIND_H

#include <libusb.h>
#include <stdbool.h>

#include "sinks/gud/link.h"
#include "sinks/usb/options.h"
#include "sinks/usb/port.h"

enum usb_state {
    USB_DISPLAY,     /* answers the descriptor request */
    USB_KERNEL,      /* a kernel driver has it; nothing was asked */
    USB_IN_USE,      /* another program has it */
    USB_DENIED,      /* may not be opened */
    USB_NOT_DISPLAY, /* or a broken one: see problem */
    USB_VANISHED
};

enum { USB_INTERFACES_MAX = 8, USB_FOUND_MAX = 64 };

struct usb_device {
    libusb_device *device;
    uint32_t id;
    char path[USB_PATH_ROOM], serial[128], product[128], driver[32];
    bool expected; /* to be a GUD display: by its ID, or because it was named */
    unsigned interface_count;
    struct {
        uint8_t number, bulk_out;
        bool says_gud;                /* by its name */
    } interfaces[USB_INTERFACES_MAX]; /* vendor class with a bulk OUT endpoint */
    uint8_t interface, bulk_out;      /* the display's */
    enum usb_state state;
    struct gud_problem problem;
};

struct usb_found {
    libusb_device **list;
    unsigned count;
    struct usb_device devices[USB_FOUND_MAX];
};

/* What the options allow, each device asked what it is: those that the options name, that have an ID of GUD's, or whose
 * interface has GUD in its name; no other is sent a request. `until`: seconds_now() when asking ends, and each request is
 * short; 0: no end. */
void usb_find(libusb_context *libusb, const struct usb_options *options, double until, struct usb_found *found);
/* What it means for a device that an interface of it was not opened. */
enum usb_state usb_state_unopened(enum usb_opened opened, const struct gud_problem *problem);
void usb_found_free(struct usb_found *found);
/* "1-3.1": the bus and the ports on the way, as the kernel names devices. False where there is no port, as for root hubs, or
 * no room. */
bool usb_path_text(uint8_t bus, const uint8_t *ports, int count, char *text, size_t size);
/* "usb 1-3 (1d50:614d)" */
const char *usb_name(const struct usb_device *device, char *text, size_t size);

#endif
