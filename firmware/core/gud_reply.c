/* SPDX-License-Identifier: MIT
 * What the device tells a host about itself. */
#include "gud_reply.h"

static int descriptor(const struct gud_device_config *c, uint8_t *reply)
{
    const struct gud_descriptor descriptor = {.flags = (c->status_after_set ? GUD_FLAG_STATUS : 0u) |
                                                       (c->whole_frames ? GUD_FLAG_FULL_UPDATE : 0u),
                                              .compression = c->window ? GUD_COMPRESSION_LZ4 : 0,
                                              .max_buffer = c->max_buffer,
                                              .min_width = c->width,
                                              .max_width = c->width,
                                              .min_height = c->height,
                                              .max_height = c->height};
    gud_descriptor_pack(reply, &descriptor);
    return GUD_DESCRIPTOR_BYTES;
}

static int mode(const struct gud_device_config *c, uint8_t *reply)
{
    /* No blanking: nothing scans these out. */
    const struct gud_mode mode = {
        .clock_khz = (uint32_t)c->width * c->height / 100 * c->refresh_hz / 10 + 1,
        .hdisplay = c->width,
        .hsync_start = c->width,
        .hsync_end = c->width,
        .htotal = c->width,
        .vdisplay = c->height,
        .vsync_start = c->height,
        .vsync_end = c->height,
        .vtotal = c->height,
        .flags = GUD_MODE_PREFERRED,
    };
    gud_mode_pack(reply, &mode);
    return GUD_MODE_BYTES;
}

static int zeros(uint8_t *reply, int count)
{
    for (int i = 0; i < count; i++)
        reply[i] = 0;
    return count;
}

static int brightness_property(const struct gud_device *d, uint8_t *reply)
{
    if (!d->config->dimmable)
        return 0;
    zeros(reply, GUD_PROPERTY_BYTES);
    reply[0] = GUD_BRIGHTNESS;
    reply[2] = d->brightness;
    return GUD_PROPERTY_BYTES;
}

static int formats(const struct gud_device_config *c, uint8_t *reply)
{
    for (unsigned i = 0; i < c->format_count; i++)
        reply[i] = c->formats[i];
    return c->format_count;
}

int gud_reply(const struct gud_device *d, uint8_t request, uint8_t reply[GUD_REPLY_BYTES])
{
    switch (request) {
    case GUD_GET_STATUS:
        reply[0] = d->status;
        return 1;
    case GUD_GET_DESCRIPTOR:
        return descriptor(d->config, reply);
    case GUD_GET_FORMATS:
        return formats(d->config, reply);
    case GUD_GET_PROPERTIES:
    case GUD_GET_CONNECTOR_EDID:
        return 0;
    case GUD_GET_CONNECTORS:
        return zeros(reply, GUD_CONNECTOR_BYTES); /* one, a panel, without flags */
    case GUD_GET_CONNECTOR_PROPERTIES:
        return brightness_property(d, reply);
    case GUD_GET_CONNECTOR_STATUS:
        reply[0] = GUD_CONNECTED;
        return 1;
    case GUD_GET_CONNECTOR_MODES:
        return mode(d->config, reply);
    default:
        return GUD_STALL;
    }
}
