/* SPDX-License-Identifier: MIT */
#include "gud_protocol.h"

static uint8_t *put(uint8_t *at, uint32_t value, unsigned bytes)
{
    while (bytes--) {
        *at++ = (uint8_t)value;
        value >>= 8;
    }
    return at;
}

static uint32_t take(const uint8_t **at, unsigned bytes)
{
    uint32_t value = 0;
    for (unsigned i = 0; i < bytes; i++)
        value |= (uint32_t) * (*at)++ << 8 * i;
    return value;
}

void gud_descriptor_pack(uint8_t out[GUD_DESCRIPTOR_BYTES], const struct gud_descriptor *d)
{
    out = put(out, GUD_MAGIC, 4);
    out = put(out, GUD_VERSION, 1);
    out = put(out, d->flags, 4);
    out = put(out, d->compression, 1);
    out = put(out, d->max_buffer, 4);
    out = put(out, d->min_width, 4);
    out = put(out, d->max_width, 4);
    out = put(out, d->min_height, 4);
    put(out, d->max_height, 4);
}

bool gud_descriptor_unpack(struct gud_descriptor *d, const uint8_t in[GUD_DESCRIPTOR_BYTES])
{
    const bool known = take(&in, 4) == GUD_MAGIC;
    const bool good = take(&in, 1) == GUD_VERSION && known;
    d->flags = take(&in, 4);
    d->compression = (uint8_t)take(&in, 1);
    d->max_buffer = take(&in, 4);
    d->min_width = take(&in, 4);
    d->max_width = take(&in, 4);
    d->min_height = take(&in, 4);
    d->max_height = take(&in, 4);
    return good;
}

void gud_mode_pack(uint8_t out[GUD_MODE_BYTES], const struct gud_mode *m)
{
    const uint16_t times[] = {m->hdisplay, m->hsync_start, m->hsync_end, m->htotal,
                              m->vdisplay, m->vsync_start, m->vsync_end, m->vtotal};
    out = put(out, m->clock_khz, 4);
    for (unsigned i = 0; i < 8; i++)
        out = put(out, times[i], 2);
    put(out, m->flags, 4);
}

void gud_mode_unpack(struct gud_mode *m, const uint8_t in[GUD_MODE_BYTES])
{
    uint16_t *const times[] = {&m->hdisplay, &m->hsync_start, &m->hsync_end, &m->htotal,
                               &m->vdisplay, &m->vsync_start, &m->vsync_end, &m->vtotal};
    m->clock_khz = take(&in, 4);
    for (unsigned i = 0; i < 8; i++)
        *times[i] = (uint16_t)take(&in, 2);
    m->flags = take(&in, 4);
}

void gud_rectangle_pack(uint8_t out[GUD_RECTANGLE_BYTES], const struct gud_rectangle *r)
{
    out = put(out, r->x, 4);
    out = put(out, r->y, 4);
    out = put(out, r->width, 4);
    out = put(out, r->height, 4);
    out = put(out, r->length, 4);
    out = put(out, r->compression, 1);
    put(out, r->compressed_length, 4);
}

void gud_rectangle_unpack(struct gud_rectangle *r, const uint8_t in[GUD_RECTANGLE_BYTES])
{
    r->x = take(&in, 4);
    r->y = take(&in, 4);
    r->width = take(&in, 4);
    r->height = take(&in, 4);
    r->length = take(&in, 4);
    r->compression = (uint8_t)take(&in, 1);
    r->compressed_length = take(&in, 4);
}

size_t gud_line_bytes(enum gud_format format, uint32_t width)
{
    switch (format) {
    case GUD_R1:
        return ((size_t)width + 7) / 8;
    case GUD_R8:
    case GUD_RGB332:
        return width;
    case GUD_XRGB1111:
        return ((size_t)width + 1) / 2;
    case GUD_RGB565:
        return 2 * (size_t)width;
    case GUD_RGB888:
        return 3 * (size_t)width;
    case GUD_XRGB8888:
    case GUD_ARGB8888:
        return 4 * (size_t)width;
    }
    return 0;
}
