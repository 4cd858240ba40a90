/* SPDX-License-Identifier: MIT
 * Which of the USB displays that were found, or why none. */
#ifndef GLINT_USB_CHOOSE_H
#define GLINT_USB_CHOOSE_H

#include <stddef.h>

#include "sinks/usb/find.h"

enum usb_attempt {
    USB_TRY_OPENED,
    USB_TRY_AGAIN, /* it may still be plugged in */
    USB_TRY_SOON,  /* udev takes a moment to let the user in; another program may only look what it is */
    USB_TRY_NO_GOOD
};
/* The one to use; else NULL, one line that says why, and whether it may work later. */
const struct usb_device *usb_choose(const struct usb_found *found, const struct usb_options *options, char *line,
                                    size_t size, enum usb_attempt *attempt);
/* Why a device that was found cannot be used, and whether it may work later. */
enum usb_attempt usb_unusable(const struct usb_device *device, char *line, size_t size);
/* Once it is opened, the one that is looked for from then on: if it is unplugged, --wait waits for this one. */
void usb_remember(const struct usb_device *device);
/* Whether another attempt may go better; `moments` counts those in a row that may soon, of which there are few. */
bool usb_may_pass(enum usb_attempt attempt, unsigned *moments);

#endif
