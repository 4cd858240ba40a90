/* SPDX-License-Identifier: MIT
 *
 * One rectangle of a GUD display: its request, its bulk bytes, its end. gud_device.c calls these. */
#ifndef GUD_RECTANGLE_H
#define GUD_RECTANGLE_H

#include "gud_device.h"

/* Bytes of a whole line as the panel takes it. */
uint32_t gud_output_line_bytes(const struct gud_device_config *config);
/* From the request's data. Any other status than GUD_OK has changed nothing. */
enum gud_status gud_rectangle_open(struct gud_device *device, const uint8_t *data);
/* The whole picture, which nothing announces: where the device takes no others, a host may draw and all bytes of the last one have come. While
 * the board is busy its bytes are dropped. */
void gud_rectangle_open_whole(struct gud_device *device);
/* Bulk bytes; those that no rectangle expects are dropped. GUD_PROTOCOL: there were such bytes. GUD_ERROR: the LZ4 block was
 * wrong. GUD_BUSY: they are of a picture that began while the board was busy. */
enum gud_status gud_rectangle_bulk(struct gud_device *device, const uint8_t *bytes, size_t count);
/* Ends an open rectangle, complete or not. Bytes of it that are still to come will be dropped. */
void gud_rectangle_close(struct gud_device *device);

#endif
