/* SPDX-License-Identifier: MIT
 * The library's pixel formats and colour spaces: names, channels, levels, bytes. */
#ifndef GLINT_IMAGE_FORMAT_H
#define GLINT_IMAGE_FORMAT_H

#include <stdbool.h>
#include <stddef.h>

#include "glint.h"

/* Grey of a colour, of 256: the weights of step 6 in lib/sequence.md. */
enum { GREY_RED = 54, GREY_GREEN = 183, GREY_BLUE = 19 };

extern const char *const format_names[]; /* "rgb565" ..., by enum glint_format; ends with NULL */
extern const char *const space_names[];  /* "gamma", "linear", by enum glint_space; ends with NULL */
/* Two bytes of 5, 6 and 5 bits, in either order. */
static inline bool format_is_565(enum glint_format format)
{
    return format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED;
}
/* The last byte of each of its pixels is alpha, which the colours are not multiplied by. */
static inline bool format_has_alpha(enum glint_format format)
{
    return format == GLINT_ARGB8888;
}
/* The nearest RGB565 of 8 bits a channel. */
static inline uint16_t format_nearest_565(const uint8_t rgb[3])
{
    return (uint16_t)((rgb[0] * 31 + 127) / 255 << 11 | (rgb[1] * 63 + 127) / 255 << 5 | (rgb[2] * 31 + 127) / 255);
}
/* "rgb565, rgb565-swapped, ..., ", for help; and what one means: half a sentence. */
#define FORMAT_WORD(number, name, bits, channels, red, green, blue) name ", "
#define FORMAT_WORDS GLINT_FORMATS(FORMAT_WORD)
const char *format_meaning(enum glint_format format);
unsigned format_channels(enum glint_format format);
unsigned format_max(enum glint_format format, unsigned channel); /* the highest level */
size_t format_line_bytes(enum glint_format format, size_t width);
size_t format_byte_pixels(enum glint_format format); /* how many pixels share a byte: 8, 4, 2, else 1 */
/* The levels of pixel x of a line as the library wrote it, one a channel. */
void format_unpack(const uint8_t *line, enum glint_format format, size_t x, uint8_t *values);

#endif
