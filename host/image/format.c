/* SPDX-License-Identifier: MIT */
#include "image/format.h"

#define FORMAT_NAME(number, name, bits, channels, red, green, blue) name,
const char *const format_names[] = {GLINT_FORMATS(FORMAT_NAME) NULL};
const char *const space_names[] = {"gamma", "linear", NULL};

#define FORMAT_TRAITS(number, name, bits, channels, red, green, blue) {bits, channels, {red, green, blue}},
static const struct {
    uint8_t bits, channels, max[3];
} format_traits[] = {GLINT_FORMATS(FORMAT_TRAITS)};

const char *format_meaning(enum glint_format format)
{
    switch (format) {
    case GLINT_RGB565:
        return "The usual small panel: 32, 64 and 32 levels";
    case GLINT_RGB565_SWAPPED:
        return "The same as RGB565, high byte first, as SPI panels take it";
    case GLINT_RGB888:
        return "256 levels a channel";
    case GLINT_GREY8:
        return "256 greys";
    case GLINT_MONO:
        return "Black and white, 8 pixels a byte: try dither";
    case GLINT_BGR888:
        return "256 levels a channel, blue first: LVGL's RGB888";
    case GLINT_XRGB8888:
        return "Blue first, and a byte of 255: LVGL's XRGB8888";
    case GLINT_ARGB8888:
        return "Blue first, and the mask as alpha: LVGL's ARGB8888";
    case GLINT_GREY4:
        return "16 greys, 2 pixels a byte: e-paper and OLED";
    case GLINT_GREY2:
        return "4 greys, 4 pixels a byte: try dither";
    }
    return "";
}

unsigned format_channels(enum glint_format format)
{
    return format_traits[format].channels;
}

unsigned format_max(enum glint_format format, unsigned channel)
{
    return format_traits[format].max[channel];
}

size_t format_line_bytes(enum glint_format format, size_t width)
{
    return (format_traits[format].bits * width + 7) / 8;
}

size_t format_byte_pixels(enum glint_format format)
{
    return format_traits[format].bits < 8 ? (size_t)(8 / format_traits[format].bits) : 1;
}

void format_unpack(const uint8_t *line, enum glint_format format, size_t x, uint8_t *values)
{
    unsigned word;
    switch (format) {
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED:
        word = line[2 * x + (format == GLINT_RGB565)];
        word = word << 8 | line[2 * x + (format == GLINT_RGB565_SWAPPED)];
        values[0] = (uint8_t)(word >> 11);
        values[1] = (uint8_t)(word >> 5 & 63);
        values[2] = (uint8_t)(word & 31);
        break;
    case GLINT_RGB888:
        for (unsigned k = 0; k < 3; k++)
            values[k] = line[3 * x + k];
        break;
    case GLINT_BGR888:
    case GLINT_XRGB8888:
    case GLINT_ARGB8888:
        for (unsigned k = 0; k < 3; k++)
            values[k] = line[format_traits[format].bits / 8 * x + 2 - k];
        break;
    case GLINT_GREY8:
        values[0] = line[x];
        break;
    case GLINT_MONO:
    case GLINT_GREY4:
    case GLINT_GREY2: {
        const unsigned bits = format_traits[format].bits;
        values[0] = (uint8_t)(line[x * bits / 8] >> (8 - bits - x * bits % 8) & format_traits[format].max[0]);
        break;
    }
    }
}
