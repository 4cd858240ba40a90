/* SPDX-License-Identifier: MIT
 *
 * A line of pixels as GUD sends them into what a panel takes. */
#ifndef GUD_PIXELS_H
#define GUD_PIXELS_H

#include "glint.h"
#include "gud_protocol.h"

/* Any GUD format into GLINT_RGB565, GLINT_RGB565_SWAPPED or GLINT_RGB888. Narrow channels are widened to the nearest level, wide
 * ones cut (which gives narrow ones back). `in` holds gud_line_bytes(from, width) bytes. */
void gud_pixels_convert(uint8_t *out, enum glint_format to, const uint8_t *in, enum gud_format from, uint32_t width);

#endif
