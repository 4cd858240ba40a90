/* SPDX-License-Identifier: MIT */
#include "sinks/usb/port.h"

#include <stdlib.h>
#include <time.h>

#include "base/clock.h"
#include "base/stop.h"

/* As in the kernel's driver; a device that may not be a display at all gets BRIEF_MS. */
enum { CONTROL_MS = 5000, BRIEF_MS = 500, TICK_MS = 50, SETUP_BYTES = LIBUSB_CONTROL_SETUP_SIZE };

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

int usb_transfer_fault(const struct libusb_transfer *transfer)
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

void usb_port_tick(struct usb_port *port)
{
    struct timeval time = {0, TICK_MS * 1000L};
    libusb_handle_events_timeout_completed(port->libusb, &time, NULL);
}

void usb_pause_ms(long ms)
{
    nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000}, NULL);
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
    double end = seconds_now() + 1e-3 * (port->brief ? BRIEF_MS : CONTROL_MS);
    if (port->until > 0 && port->until < end)
        end = port->until;
    while (!*done) {
        usb_port_tick(port);
        if (cut || *done)
            continue;
        cut = port->stoppable && stream_stopped() ? GUD_LINK_STOPPED : seconds_now() > end ? GUD_LINK_TIMEOUT : 0;
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
            const int cut = control_wait(port, transfer, &done), fault = usb_transfer_fault(transfer);
            result = !fault ? transfer->actual_length : cut ? cut : fault;
            for (int i = 0; in && i < result; i++)
                data[i] = buffer[SETUP_BYTES + i];
        }
    }
    free(buffer);
    libusb_free_transfer(transfer);
    return result;
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
