/* SPDX-License-Identifier: MIT
 * USB displays by libusb: what the files of this sink share. */
#ifndef GLINT_SINK_USB_H
#define GLINT_SINK_USB_H

#include <libusb.h>

#include "sinks/gud/host.h"

/* Which display, as the user says; from the command line. */
struct usb_options {
    uint32_t id;        /* vendor << 16 | product; 0: any */
    const char *serial; /* NULL: any */
    const char *path;   /* "1-3.1"; NULL: any */
    bool detach, wait;
};

extern struct usb_options usb_options; /* (sink_usb.c) */

/* ---- devices that shade (sink_usb_light.c) ---- */

struct sink *usb_open_shader(const struct sink_wish *wish);
enum sink_result usb_send_scene(struct sink *sink, const struct glint_shader *shader, const uint32_t *normals);
enum sink_result usb_send_light(struct sink *sink, const int32_t to_light[3], size_t *bytes);

/* ---- finding (sink_usb_find.c) ---- */

enum usb_state {
    USB_DISPLAY,     /* answers the descriptor request */
    USB_KERNEL,      /* a kernel driver has it; nothing was asked */
    USB_IN_USE,      /* another program has it */
    USB_DENIED,      /* may not be opened */
    USB_NOT_DISPLAY, /* or no good one: see problem */
    USB_VANISHED
};

enum { USB_INTERFACES_MAX = 8, USB_FOUND_MAX = 64 };

struct usb_device {
    libusb_device *device;
    uint32_t id;
    char path[32], serial[128], product[128], driver[32];
    bool expected; /* to be a GUD display: by its ID, or because it was named */
    unsigned interface_count;
    struct {
        uint8_t number, bulk_out;
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

/* What the options allow, each device asked what it is. `libusb` NULL: no context. */
void usb_find(libusb_context *libusb, const struct usb_options *options, struct usb_found *found);
void usb_found_free(struct usb_found *found);
/* "usb 1-3 (1d50:614d)" */
const char *usb_name(const struct usb_device *device, char *text, size_t size);

/* ---- choosing (sink_usb_choose.c) ---- */

enum usb_attempt {
    USB_TRY_OPENED,
    USB_TRY_AGAIN,  /* it may be plugged in */
    USB_TRY_DENIED, /* udev takes a moment to let the user in */
    USB_TRY_NO_GOOD
};
/* The one to use; else NULL, one line that says why, and whether that may pass. */
const struct usb_device *usb_choose(const struct usb_found *found, const struct usb_options *options, char *line,
                                    size_t size, enum usb_attempt *attempt);

/* ---- listing (sink_usb_list.c) ---- */

json_t *usb_list(void);
void usb_list_print(const json_t *devices, FILE *stream);

/* ---- an open display (sink_usb_bulk.c) ---- */

/* Bytes on bulk OUT are cut to chunks, several of them in flight, so that the bus never waits for this program. */
enum { USB_FLIGHT = 3 };

struct usb_port {
    libusb_context *libusb;
    libusb_device_handle *handle;
    uint8_t interface, bulk_out;
    bool stoppable; /* waiting ends when stream_stopped() */
    bool brief;     /* requests have little time: it may not be a display at all */
    /* of the bulk under way */
    struct libusb_transfer *transfers[USB_FLIGHT];
    const uint8_t *next;
    size_t left, chunk;
    unsigned in_flight, completions;
    int fault; /* enum gud_link_fault, or 0 */
};

enum usb_opened { USB_OPENED, USB_OPEN_KERNEL, USB_OPEN_IN_USE, USB_OPEN_DENIED, USB_OPEN_FAILED };
/* Opens and claims one interface; `detached`, where not NULL, lets a kernel driver be detached and says if it was. */
enum usb_opened usb_port_open(struct usb_port *port, libusb_device *device, uint8_t interface, bool *detached,
                              struct gud_problem *problem);
/* And the endpoint's halt cleared. */
bool usb_port_claim_again(struct usb_port *port, bool *detached, struct gud_problem *problem);
void usb_port_close(struct usb_port *port, bool detached);
/* For struct gud_link; the context is a struct usb_port. */
int usb_control(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes);
/* 0, or an enum gud_link_fault. start returns when the last chunk is under way; data stays until wait. */
int usb_bulk_prepare(struct usb_port *port);
int usb_bulk_start(struct usb_port *port, const uint8_t *data, size_t bytes);
int usb_bulk_wait(struct usb_port *port);
void usb_bulk_free(struct usb_port *port);
enum gud_link_fault usb_fault(int libusb_error);

#endif
