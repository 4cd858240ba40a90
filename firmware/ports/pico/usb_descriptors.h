/* SPDX-License-Identifier: MIT
 * What the board says of itself on USB. TinyUSB asks by callbacks; this is for the board itself. */
#ifndef USB_DESCRIPTORS_H
#define USB_DESCRIPTORS_H

const char *usb_serial(void); /* the first call needs flash for itself */

#endif
