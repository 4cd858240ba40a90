/* SPDX-License-Identifier: MIT
 * A display's pixels from the library's. */
#include "sinks/gud/pack.h"

#include <string.h>

#include "sinks/gud/host.h"

int gud_glint_format(uint8_t format)
{
    switch (format) {
    case GUD_R1:
        return GLINT_MONO;
    case GUD_R8:
        return GLINT_GREY8;
    case GUD_RGB565:
        return GLINT_RGB565;
    case GUD_RGB888:
    case GUD_XRGB8888:
    case GUD_ARGB8888:
        return GLINT_RGB888;
    default:
        return -1;
    }
}

const char *gud_format_name(uint8_t format)
{
    switch (format) {
    case GUD_R1:
        return "mono";
    case GUD_R8:
        return "grey8";
    case GUD_XRGB1111:
        return "xrgb1111";
    case GUD_RGB332:
        return "rgb332";
    case GUD_RGB565:
        return "rgb565";
    case GUD_RGB888:
        return "rgb888";
    case GUD_XRGB8888:
        return "xrgb8888";
    case GUD_ARGB8888:
        return "argb8888";
    default:
        return NULL;
    }
}

size_t gud_box_bytes(enum gud_format format, const struct glint_box *box)
{
    return gud_line_bytes(format, box->w) * box->h;
}

/* Bytes b, g, r of each pixel and, where there are four, an opaque alpha, which XRGB ignores. */
static void pack_colours(const uint8_t *rgb, size_t pixels, size_t bytes_a_pixel, uint8_t *out)
{
    for (size_t i = 0; i < pixels; i++, rgb += 3, out += bytes_a_pixel) {
        out[0] = rgb[2];
        out[1] = rgb[1];
        out[2] = rgb[0];
        if (bytes_a_pixel == 4)
            out[3] = 0xff;
    }
}

void gud_box_pack(enum gud_format format, const struct frame *frame, const struct glint_box *box, uint8_t *out)
{
    const size_t line = gud_line_bytes(format, box->w);
    const enum gud_format from = gud_glint_format((uint8_t)format) == GLINT_RGB888 ? GUD_RGB888 : format;
    const uint8_t *row = frame->pixels + box->y * frame->line_bytes + gud_line_bytes(from, box->x);
    for (uint16_t y = 0; y < box->h; y++, row += frame->line_bytes, out += line) {
        if (from == GUD_RGB888)
            pack_colours(row, box->w, gud_line_bytes(format, 1), out);
        else
            memcpy(out, row, line);
    }
}
