/* SPDX-License-Identifier: MIT
 * The board on USB: a GUD display. */
#ifndef USB_H
#define USB_H

#include "gud_device.h"

enum usb_interface { USB_GUD_INTERFACE, USB_INTERFACES };

void usb_start(struct gud_device *gud);
void usb_poll(void);         /* what arrived meanwhile; often */
bool usb_is_suspended(void); /* by a host that had configured it, or unplugged from one */

/* usb_class.c hands on what came by bulk. */
void usb_take(enum usb_interface interface, const uint8_t *bytes, size_t count);

#endif
