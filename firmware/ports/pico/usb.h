/* SPDX-License-Identifier: MIT
 * The board on USB: a GUD display, and where RAM holds a map of the panel's size an interface for light beside it. */
#ifndef USB_H
#define USB_H

#include "light_device.h"

#define OFFERS_LIGHT (PANEL_WIDTH * PANEL_HEIGHT <= 240 * 240)
enum usb_interface { USB_GUD, USB_LIGHT, USB_INTERFACES = 1 + OFFERS_LIGHT };
enum { USB_PACKET = 64 };

void usb_start(struct gud_device *gud, struct light_device *light);
const char *usb_serial(void); /* its first call must have flash for itself */
void usb_poll(void);          /* what arrived meanwhile; often */
bool usb_is_suspended(void);  /* by a host that had configured it, or unplugged from one */

/* For usb_class.c: is there room for so many bytes that come by bulk, and here they are. */
bool usb_has_room(enum usb_interface interface, size_t count);
void usb_take(enum usb_interface interface, const uint8_t *bytes, size_t count);
/* And from it: packets that waited for room may come. */
void usb_class_poll(void);

#endif
