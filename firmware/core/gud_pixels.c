/* SPDX-License-Identifier: MIT */
#include "gud_pixels.h"

struct rgb {
    uint8_t r, g, b;
};

/* To the nearest of 0..255; `most` is 2^bits - 1. */
static uint8_t widened(unsigned value, unsigned most)
{
    return (uint8_t)((255 * value + most / 2) / most);
}

static struct rgb grey(unsigned value)
{
    return (struct rgb){(uint8_t)value, (uint8_t)value, (uint8_t)value};
}

static struct rgb fetch(const uint8_t *in, enum gud_format from, uint32_t x)
{
    switch (from) {
    case GUD_R1:
        return grey((in[x / 8] >> (7 - x % 8) & 1) * 255u);
    case GUD_R8:
        return grey(in[x]);
    case GUD_XRGB1111: {
        const unsigned v = (unsigned)in[x / 2] >> (x % 2 ? 0 : 4);
        return (struct rgb){widened(v >> 2 & 1, 1), widened(v >> 1 & 1, 1), widened(v & 1, 1)};
    }
    case GUD_RGB332:
        return (struct rgb){widened(in[x] >> 5u, 7), widened(in[x] >> 2u & 7, 7), widened(in[x] & 3u, 3)};
    case GUD_RGB565: {
        const unsigned v = in[2 * x] | (unsigned)in[2 * x + 1] << 8;
        return (struct rgb){widened(v >> 11, 31), widened(v >> 5 & 63, 63), widened(v & 31, 31)};
    }
    case GUD_RGB888:
        return (struct rgb){in[3 * x + 2], in[3 * x + 1], in[3 * x]};
    case GUD_XRGB8888:
    case GUD_ARGB8888:
        break;
    }
    return (struct rgb){in[4 * x + 2], in[4 * x + 1], in[4 * x]};
}

void gud_pixels_convert(uint8_t *out, enum glint_format to, const uint8_t *in, enum gud_format from, uint32_t width)
{
    const unsigned high = to == GLINT_RGB565_SWAPPED ? 0 : 1; /* where the high byte stands */
    if (from == GUD_RGB565 && to != GLINT_RGB888) {
        for (uint32_t i = 0; i < 2 * width; i += 2) {
            out[i + 1 - high] = in[i];
            out[i + high] = in[i + 1];
        }
        return;
    }
    for (uint32_t x = 0; x < width; x++) {
        const struct rgb p = fetch(in, from, x);
        if (to == GLINT_RGB888) {
            out[3 * x] = p.r;
            out[3 * x + 1] = p.g;
            out[3 * x + 2] = p.b;
        } else {
            out[2 * x + high] = (uint8_t)((p.r & 0xf8) | p.g >> 5);
            out[2 * x + 1 - high] = (uint8_t)((p.g & 0x1c) << 3 | p.b >> 3);
        }
    }
}
