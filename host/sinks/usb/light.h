/* SPDX-License-Identifier: MIT
 * A USB device that shades by itself: an interface beside the display's, which no kernel driver takes. */
#ifndef GLINT_USB_LIGHT_H
#define GLINT_USB_LIGHT_H

#include "light_protocol.h"
#include "sinks/sink.h"

extern const struct sink_shader usb_shader;

/* Can glint shade for such a device, as the user wishes? Where not, `line` says why. */
bool usb_light_fits(const struct light_descriptor *device, const struct sink_wish *wish, const char *name, char *line,
                    size_t size);

/* Why a device's answer to LIGHT_GET_LIGHT, `got` bytes or an enum gud_link_fault, gives no light; NULL: it does. */
const char *usb_light_refusal(int32_t to_light[3], int got, const uint8_t bytes[LIGHT_MESSAGE_BYTES]);

/* Why a device refused LIGHT_SET_LIGHT, by its status; NULL: it is busy for a moment. */
const char *usb_demo_refusal(uint8_t status);

#endif
