/* SPDX-License-Identifier: MIT
 *
 * Replies to a host's questions: descriptor, formats, the one connector, its mode and its brightness. */
#ifndef GUD_REPLY_H
#define GUD_REPLY_H

#include "gud_device.h"

/* Fills `reply` and returns its whole length; GUD_STALL for an unknown request. */
int gud_reply(const struct gud_device *device, uint8_t request, uint8_t reply[GUD_REPLY_BYTES]);

#endif
