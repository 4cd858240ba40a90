/* SPDX-License-Identifier: MIT
 * An open interface: control requests, and bulk OUT with several transfers in flight. Everything is asynchronous within,
 * so that a signal or a device that takes nothing ends a wait. */
#include <stdlib.h>
#include <time.h>

#include "base/stop.h"
#include "sinks/usb/usb.h"

/* As in the kernel's driver; the bulk time counts from the last chunk that arrived. */
enum {
    CONTROL_MS = 5000,
    BRIEF_MS = 500,
    BULK_MS = 3000,
    STOP_MS = 500,
    TICK_MS = 50,
    SETUP_BYTES = LIBUSB_CONTROL_SETUP_SIZE
};
/* Small enough for progress to be seen within BULK_MS, large enough to cost no time: each is a system call or two. */
enum { CHUNK_FULL_SPEED = 128 << 10, CHUNK_FASTER = 4 << 20 };

enum gud_link_fault usb_fault(int libusb_error)
{
    switch (libusb_error) {
    case LIBUSB_ERROR_PIPE:
        return GUD_LINK_STALL;
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
        return GUD_LINK_GONE;
    case LIBUSB_ERROR_TIMEOUT:
        return GUD_LINK_TIMEOUT;
    default:
        return GUD_LINK_ERROR;
    }
}

/* 0 where all of it arrived. */
static int transfer_fault(const struct libusb_transfer *transfer)
{
    switch (transfer->status) {
    case LIBUSB_TRANSFER_COMPLETED:
        return 0;
    case LIBUSB_TRANSFER_STALL:
        return GUD_LINK_STALL;
    case LIBUSB_TRANSFER_NO_DEVICE:
        return GUD_LINK_GONE;
    case LIBUSB_TRANSFER_TIMED_OUT:
    case LIBUSB_TRANSFER_CANCELLED:
        return GUD_LINK_TIMEOUT;
    default:
        return GUD_LINK_ERROR;
    }
}

static int64_t now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

static void tick(struct usb_port *port)
{
    struct timeval time = {0, TICK_MS * 1000};
    libusb_handle_events_timeout_completed(port->libusb, &time, NULL);
}

/* ---- control ---- */

static void control_done(struct libusb_transfer *transfer)
{
    *(bool *)transfer->user_data = true;
}

/* Waits; gives up at a signal or when the time is over. Returns what cut it short, or 0. */
static int control_wait(struct usb_port *port, struct libusb_transfer *transfer, const bool *done)
{
    int cut = 0;
    const int64_t end = now_ms() + (port->brief ? BRIEF_MS : CONTROL_MS);
    while (!*done) {
        tick(port);
        if (cut || *done)
            continue;
        cut = port->stoppable && stream_stopped() ? GUD_LINK_STOPPED : now_ms() > end ? GUD_LINK_TIMEOUT : 0;
        if (cut)
            libusb_cancel_transfer(transfer);
    }
    return cut;
}

int usb_control(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes)
{
    struct usb_port *port = context;
    const uint8_t type =
        LIBUSB_REQUEST_TYPE_VENDOR | LIBUSB_RECIPIENT_INTERFACE | (in ? LIBUSB_ENDPOINT_IN : LIBUSB_ENDPOINT_OUT);
    struct libusb_transfer *transfer = libusb_alloc_transfer(0);
    uint8_t *buffer = calloc(1, SETUP_BYTES + (size_t)bytes);
    int result = GUD_LINK_ERROR;
    bool done = false;
    if (transfer && buffer) {
        libusb_fill_control_setup(buffer, type, request, value, port->interface, bytes);
        for (unsigned i = 0; !in && i < bytes; i++)
            buffer[SETUP_BYTES + i] = data[i];
        libusb_fill_control_transfer(transfer, port->handle, buffer, control_done, &done, 0);
        const int error = libusb_submit_transfer(transfer);
        if (error) {
            result = usb_fault(error);
        } else {
            const int cut = control_wait(port, transfer, &done), fault = transfer_fault(transfer);
            result = !fault ? transfer->actual_length : cut ? cut : fault;
            for (int i = 0; in && i < result; i++)
                data[i] = buffer[SETUP_BYTES + i];
        }
    }
    free(buffer);
    libusb_free_transfer(transfer);
    return result;
}

/* ---- bulk ---- */

static void submit(struct usb_port *port, struct libusb_transfer *transfer)
{
    const size_t bytes = port->left < port->chunk ? port->left : port->chunk;
    transfer->buffer = (unsigned char *)port->next; /* libusb takes what it only reads as not const */
    transfer->length = (int)bytes;
    const int error = libusb_submit_transfer(transfer);
    if (error == LIBUSB_ERROR_NO_MEM && port->in_flight)
        return; /* the kernel's 16 MB for all of USB are taken: again when the one before has arrived */
    if (error) {
        port->fault = usb_fault(error);
        return;
    }
    port->in_flight++;
    port->next += bytes;
    port->left -= bytes;
}

static void cancel(struct usb_port *port)
{
    for (unsigned i = 0; i < USB_FLIGHT; i++)
        libusb_cancel_transfer(port->transfers[i]); /* NOT_FOUND where it is not under way */
}

static void chunk_done(struct libusb_transfer *transfer)
{
    struct usb_port *port = transfer->user_data;
    port->in_flight--;
    port->completions++;
    int fault = transfer_fault(transfer);
    if (!fault && transfer->actual_length != transfer->length)
        fault = GUD_LINK_ERROR;
    if (fault && !port->fault) { /* those after it would arrive with a hole before them */
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
    int64_t end = now_ms() + BULK_MS;
    unsigned seen = port->completions;
    bool stopping = false;
    while (port->in_flight && (all || port->left || port->fault)) {
        tick(port);
        if (port->completions != seen && !stopping) {
            seen = port->completions;
            end = now_ms() + BULK_MS;
        }
        /* A signal leaves what is under way the time to arrive whole. */
        if (!stopping && port->stoppable && stream_stopped()) {
            stopping = true;
            end = now_ms() + STOP_MS;
        }
        if (!port->fault && port->in_flight && now_ms() > end) {
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

/* ---- open and close ---- */

static enum usb_opened open_error(int error, struct gud_problem *problem)
{
    gud_problem_is(problem, usb_fault(error), "it cannot be opened: %s", libusb_strerror(error));
    return error == LIBUSB_ERROR_ACCESS ? USB_OPEN_DENIED
           : error == LIBUSB_ERROR_BUSY ? USB_OPEN_IN_USE
                                        : USB_OPEN_FAILED;
}

/* Claims; a kernel driver is detached where `detached` is not NULL. */
static enum usb_opened claim(struct usb_port *port, bool *detached, struct gud_problem *problem)
{
    if (libusb_kernel_driver_active(port->handle, port->interface) == 1) {
        if (!detached)
            return USB_OPEN_KERNEL;
        const int error = libusb_detach_kernel_driver(port->handle, port->interface);
        if (error)
            return open_error(error, problem);
        *detached = true;
    }
    const int error = libusb_claim_interface(port->handle, port->interface);
    return error ? open_error(error, problem) : USB_OPENED;
}

enum usb_opened usb_port_open(struct usb_port *port, libusb_device *device, uint8_t interface, bool *detached,
                              struct gud_problem *problem)
{
    port->interface = interface;
    const int error = libusb_open(device, &port->handle);
    if (error) {
        port->handle = NULL;
        return open_error(error, problem);
    }
    const enum usb_opened opened = claim(port, detached, problem);
    if (opened != USB_OPENED)
        usb_port_close(port, detached && *detached);
    return opened;
}

/* A reset by whom it may be takes the interface away. */
bool usb_port_claim_again(struct usb_port *port, bool *detached, struct gud_problem *problem)
{
    libusb_release_interface(port->handle, port->interface);
    const enum usb_opened opened = claim(port, detached, problem);
    if (opened == USB_OPEN_KERNEL)
        gud_problem_is(problem, GUD_LINK_ERROR, "the kernel's driver has taken it after a reset");
    if (opened != USB_OPENED)
        return false;
    const int error = libusb_clear_halt(port->handle, port->bulk_out);
    return error != LIBUSB_ERROR_NO_DEVICE || gud_problem_is(problem, GUD_LINK_GONE, "gone");
}

void usb_port_close(struct usb_port *port, bool detached)
{
    if (!port->handle)
        return;
    libusb_release_interface(port->handle, port->interface);
    if (detached)
        libusb_attach_kernel_driver(port->handle, port->interface);
    libusb_close(port->handle);
    port->handle = NULL;
}
