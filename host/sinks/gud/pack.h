/* SPDX-License-Identifier: MIT
 * A display's pixels from the library's, and the names of its formats. */
#ifndef GLINT_GUD_PACK_H
#define GLINT_GUD_PACK_H

#include "gud_protocol.h"
#include "sinks/sink.h"

/* "rgb565" ...; NULL where unknown. */
const char *gud_format_name(uint8_t format);
size_t gud_box_bytes(enum gud_format format, const struct glint_box *box);
void gud_box_pack(enum gud_format format, const struct frame *frame, const struct glint_box *box, uint8_t *out);
/* The enum glint_format that a display's format is made from, or -1. */
int gud_glint_format(uint8_t format);

#endif
