/* SPDX-License-Identifier: MIT
 *
 * Between gud_device.c, which has the requests and the state, and gud_rectangle.c, which has rectangles and bulk. */
#ifndef GUD_RECTANGLE_H
#define GUD_RECTANGLE_H

#include "gud_device.h"

/* Bytes of a whole line as the panel takes it. */
uint32_t gud_output_line_bytes(const struct gud_device_config *config);
/* The request's data; what is not GUD_OK has changed nothing. */
enum gud_status gud_rectangle_open(struct gud_device *device, const uint8_t *data);
/* Where one is open; bytes that are still to come for it will be dropped. */
void gud_rectangle_close(struct gud_device *device);

#endif
