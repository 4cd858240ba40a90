/* SPDX-License-Identifier: MIT
 * A USB device that shades by itself: an interface beside the display's, which no kernel driver takes. */
#ifndef GLINT_USB_LIGHT_H
#define GLINT_USB_LIGHT_H

#include "sinks/sink.h"

extern const struct sink_shader usb_shader;

#endif
