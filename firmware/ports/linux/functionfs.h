/* SPDX-License-Identifier: MIT
 * Requests and bulk bytes by FunctionFS. */
#ifndef FUNCTIONFS_H
#define FUNCTIONFS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "gud_device.h"

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

#endif
