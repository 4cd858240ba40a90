/* SPDX-License-Identifier: MIT
 * The board on USB: a GUD display, and beside it an interface for light where RAM holds a map of the panel's size. */
#ifndef USB_H
#define USB_H

#include "light_device.h"

void usb_start(struct gud_device *gud, struct light_device *light);
void usb_poll(void);         /* handles what has arrived; call it often */
bool usb_is_suspended(void); /* by a host that had configured it, or unplugged from one */

#endif
