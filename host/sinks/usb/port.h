/* SPDX-License-Identifier: MIT
 * An open interface of a USB device: claimed, asked by control requests, given back. All transfers are asynchronous
 * within, so that a signal or a device that does not answer ends a wait. */
#ifndef GLINT_USB_PORT_H
#define GLINT_USB_PORT_H

#include <libusb.h>
#include <stdbool.h>

#include "sinks/gud/link.h"

/* Bytes on bulk OUT are cut into chunks, several of them in flight, so that the bus never waits for this program. */
enum { USB_FLIGHT = 3 };

struct usb_port {
    libusb_context *libusb;
    libusb_device_handle *handle;
    uint8_t interface, bulk_out;
    bool stoppable; /* waiting ends when stream_stopped() */
    bool brief;     /* requests have little time: it may not be a display at all */
    double until;   /* seconds_now() when all requests end; 0: each has its own time */
    /* of the bulk under way (bulk.h) */
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
/* After a reset, which takes the interface away; clears the endpoint's halt, too. */
bool usb_port_claim_again(struct usb_port *port, bool *detached, struct gud_problem *problem);
void usb_port_close(struct usb_port *port, bool detached);
/* For struct gud_link; the context is a struct usb_port. */
int usb_control(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes);

void usb_pause_ms(long ms);

/* Handles what libusb has to report, for at most some 50 ms. */
void usb_port_tick(struct usb_port *port);
/* What a transfer or a call of libusb says, as an enum gud_link_fault; 0 where all of the transfer arrived. */
int usb_transfer_fault(const struct libusb_transfer *transfer);
enum gud_link_fault usb_fault(int libusb_error);

#endif
