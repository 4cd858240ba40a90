/* SPDX-License-Identifier: MIT
 * A USB display for tests, as a gadget through FunctionFS: what it says of itself and how it fails are the test's to
 * choose. A process of its own; what it saw stands in memory shared with the test. Independent of the firmware's. */
#ifndef LAB_USB_DISPLAY_H
#define LAB_USB_DISPLAY_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/types.h>

#include "soon.h"
#include "usb_function.h"

enum usb_trouble {
    NO_TROUBLE,
    BULK_NAK,      /* after trouble_at bytes it takes no more */
    BULK_STALL,    /* after trouble_at bytes it halts the endpoint */
    UNPLUG,        /* after trouble_at bytes it is gone, and comes back after trouble_ms where that is not 0 */
    CONTROL_STALL, /* the request trouble_request is refused with trouble_status */
    CONTROL_SILENT /* the request trouble_request waits for trouble_ms */
};

/* Config: what it sends, byte by byte. usb_display_defaults fills it: an honest display. */
struct usb_display_config {
    struct usb_function_ids ids;
    unsigned controller; /* dummy_udc.N */
    uint8_t descriptor[64], formats[64], connectors[64], status, modes[4096];
    uint16_t descriptor_bytes, formats_bytes, connectors_bytes, status_bytes, modes_bytes;
    enum usb_trouble trouble;
    size_t trouble_at;
    unsigned trouble_ms; /* how long it is gone, or silent */
    uint8_t trouble_request, trouble_status;
    bool trouble_lasts; /* else it happens once */
};

enum { USB_REQUESTS_MAX = 4096, USB_PICTURE_MAX = 8 << 20 };

struct usb_display {
    pid_t process; /* 0: not plugged in */
    char name[32]; /* of the gadget */
    struct {
        struct usb_display_config config;
        volatile unsigned changes;
        /* What it saw. */
        volatile bool ready, controller, display, silent;
        volatile uint8_t format; /* of the last state */
        volatile uint16_t width, height;
        volatile size_t request_count, bulk_bytes, rectangles, compressed, protocol_errors;
        volatile unsigned starts; /* configured by the host */
        uint8_t requests[USB_REQUESTS_MAX];
        uint8_t picture[USB_PICTURE_MAX]; /* in the state's format, lines packed */
    } * seen;
};

void usb_display_defaults(struct usb_display_config *config, uint16_t width, uint16_t height);
/* Plugs it in, or changes what it says and does while it is: but not its IDs and controller. What it saw
 * is forgotten. */
void usb_display_be(struct usb_display *display, const struct usb_display_config *config);
void usb_display_unplug(struct usb_display *display);
/* Those that a failed test left; a tear-down. Displays are static where tests may fail. */
int usb_displays_unplug(void **state);
#endif
