/* SPDX-License-Identifier: MIT */
#include "image/format.h"

const char *const format_names[] = {"rgb565", "rgb565-swapped", "rgb888", "grey8", "mono", NULL};
const char *const space_names[] = {"gamma", "linear", NULL};

unsigned format_channels(enum glint_format format)
{
    return format == GLINT_GREY8 || format == GLINT_MONO ? 1 : 3;
}

unsigned format_max(enum glint_format format, unsigned channel)
{
    if (format == GLINT_RGB565 || format == GLINT_RGB565_SWAPPED)
        return channel == 1 ? 63 : 31;
    return format == GLINT_MONO ? 1 : 255;
}

size_t format_line_bytes(enum glint_format format, size_t width)
{
    switch (format) {
    case GLINT_RGB565:
    case GLINT_RGB565_SWAPPED:
        return 2 * width;
    case GLINT_RGB888:
        return 3 * width;
    case GLINT_GREY8:
        return width;
    case GLINT_MONO:
        return (width + 7) / 8;
    }
    return 0;
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
    case GLINT_GREY8:
        values[0] = line[x];
        break;
    case GLINT_MONO:
        values[0] = line[x / 8] >> (7 - x % 8) & 1;
        break;
    }
}
