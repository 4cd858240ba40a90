/* SPDX-License-Identifier: MIT */
#include "sinks/usb/bulk.h"

#include "base/clock.h"
#include "base/stop.h"

/* As in the kernel's driver; counted from the last chunk that arrived. A signal leaves what is under way STOP_MS. */
enum { BULK_MS = 3000, STOP_MS = 500 };
/* Small enough for progress to be seen within BULK_MS, large enough to cost no time: each is a system call or two. */
enum { CHUNK_FULL_SPEED = 128 << 10, CHUNK_FASTER = 4 << 20 };

static void cancel(struct usb_port *port)
{
    for (unsigned i = 0; i < USB_FLIGHT; i++)
        libusb_cancel_transfer(port->transfers[i]); /* NOT_FOUND where it is not under way */
}

static void submit(struct usb_port *port, struct libusb_transfer *transfer)
{
    const size_t bytes = port->left < port->chunk ? port->left : port->chunk;
    transfer->buffer = (unsigned char *)port->next; /* libusb declares it without const but only reads it */
    transfer->length = (int)bytes;
    const int error = libusb_submit_transfer(transfer);
    if (error == LIBUSB_ERROR_NO_MEM && port->in_flight)
        return; /* the kernel's 16 MB for all of USB are taken: tried again when the one before has arrived */
    if (error) {
        port->fault = usb_fault(error);
        cancel(port); /* what follows would arrive with a hole before it */
        return;
    }
    port->in_flight++;
    port->next += bytes;
    port->left -= bytes;
}

static void chunk_done(struct libusb_transfer *transfer)
{
    struct usb_port *port = transfer->user_data;
    port->in_flight--;
    port->completions++;
    int fault = usb_transfer_fault(transfer);
    if (!fault && transfer->actual_length != transfer->length)
        fault = GUD_LINK_ERROR;
    if (fault && !port->fault) { /* as above */
        port->fault = fault;
        cancel(port);
    }
    if (!port->fault && port->left)
        submit(port, transfer);
}

int usb_bulk_prepare(struct usb_port *port)
{
    const bool full_speed = libusb_get_device_speed(libusb_get_device(port->handle)) <= LIBUSB_SPEED_FULL;
    port->chunk = full_speed ? CHUNK_FULL_SPEED : CHUNK_FASTER;
    for (unsigned i = 0; i < USB_FLIGHT; i++) {
        port->transfers[i] = libusb_alloc_transfer(0);
        if (!port->transfers[i])
            return GUD_LINK_ERROR;
        libusb_fill_bulk_transfer(port->transfers[i], port->handle, port->bulk_out, NULL, 0, chunk_done, port, 0);
    }
    return 0;
}

void usb_bulk_free(struct usb_port *port)
{
    for (unsigned i = 0; i < USB_FLIGHT; i++) {
        libusb_free_transfer(port->transfers[i]);
        port->transfers[i] = NULL;
    }
}

/* Until `left` is 0 and, if `all`, nothing is in flight; or a fault. Nothing is in flight after a fault. */
static int bulk_run(struct usb_port *port, bool all)
{
    double end = seconds_now() + 1e-3 * BULK_MS;
    unsigned seen = port->completions;
    bool stopping = false;
    while (port->in_flight && (all || port->left || port->fault)) {
        usb_port_tick(port);
        if (port->completions != seen && !stopping) {
            seen = port->completions;
            end = seconds_now() + 1e-3 * BULK_MS;
        }
        /* A signal leaves what is under way the time to arrive whole. */
        if (!stopping && port->stoppable && stream_stopped()) {
            stopping = true;
            end = seconds_now() + 1e-3 * STOP_MS;
        }
        if (!port->fault && port->in_flight && seconds_now() > end) {
            port->fault = stopping ? GUD_LINK_STOPPED : GUD_LINK_TIMEOUT;
            cancel(port);
        }
    }
    return port->fault;
}

int usb_bulk_wait(struct usb_port *port)
{
    return bulk_run(port, true);
}

int usb_bulk_start(struct usb_port *port, const uint8_t *data, size_t bytes)
{
    port->next = data;
    port->left = bytes;
    port->fault = 0;
    for (unsigned i = 0; i < USB_FLIGHT && port->left && !port->fault; i++)
        submit(port, port->transfers[i]);
    return bulk_run(port, false);
}
