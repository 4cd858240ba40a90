/* SPDX-License-Identifier: MIT
 * Bulk OUT with several transfers in flight. */
#ifndef GLINT_USB_BULK_H
#define GLINT_USB_BULK_H

#include "sinks/usb/port.h"

/* Each returns 0 or an enum gud_link_fault. `start` returns when the last chunk is under way; the data stay until `wait`,
 * which returns when all of them have arrived. */
int usb_bulk_prepare(struct usb_port *port);
int usb_bulk_start(struct usb_port *port, const uint8_t *data, size_t bytes);
int usb_bulk_wait(struct usb_port *port);
void usb_bulk_free(struct usb_port *port);

#endif
