/* SPDX-License-Identifier: MIT
 * A class driver for TinyUSB: the board's vendor interfaces and their bulk OUT endpoints. */
#ifndef USB_CLASS_H
#define USB_CLASS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define OFFERS_LIGHT (PANEL_WIDTH * PANEL_HEIGHT <= 240 * 240)
enum usb_interface { USB_GUD, USB_LIGHT, USB_INTERFACES = 1 + OFFERS_LIGHT };
enum { USB_PACKET = 64 };

/* Where bulk bytes go. Packets are taken only if there is room; else the host waits. Restart: a halt, or its end, or the configuration set anew. */
struct usb_class_ops {
    bool (*has_room)(enum usb_interface interface, size_t count);
    void (*take)(enum usb_interface interface, const uint8_t *bytes, size_t count);
    void (*restart)(enum usb_interface interface);
};

void usb_class_start(const struct usb_class_ops *ops); /* before tusb_init */
void usb_class_poll(void);                             /* lets packets in for which there is room by now */
void usb_class_restart(uint8_t port);                  /* all halts end, and the next packets count as the first ones */

#endif
