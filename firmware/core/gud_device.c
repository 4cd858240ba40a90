/* SPDX-License-Identifier: MIT
 * Requests, and the state that they lead to. */
#include "gud_device.h"

#include "gud_rectangle.h"
#include "gud_reply.h"

enum { NO_MODE_FORMAT = 0, BRIGHTNESS_MOST = 100 };

static uint32_t widest_line(const struct gud_device_config *c)
{
    size_t widest = 0;
    for (unsigned i = 0; i < c->format_count; i++) {
        const size_t bytes = gud_line_bytes((enum gud_format)c->formats[i], c->width);
        if (bytes == 0)
            return 0;
        widest = bytes > widest ? bytes : widest;
    }
    return (uint32_t)widest;
}

static bool window_suffices(const struct gud_device_config *c)
{
    return !c->window || c->window_bytes >= c->max_buffer || c->window_bytes >= LZ4_BLOCK_REACH;
}

bool gud_device_init(struct gud_device *d, const struct gud_device_config *c)
{
    *d = (struct gud_device){.config = c, .brightness = BRIGHTNESS_MOST};
    d->lz4.window = c->window;
    d->lz4.window_bytes = c->window_bytes;
    if (c->width == 0 || c->height == 0 || c->format_count == 0 || c->format_count > GUD_FORMATS_MAX)
        return false;
    if (c->output != GLINT_RGB565 && c->output != GLINT_RGB565_SWAPPED && c->output != GLINT_RGB888)
        return false;
    const uint32_t widest = widest_line(c);
    if (c->whole_frames && (c->window || c->max_buffer / c->height < widest))
        return false;
    return widest && c->max_buffer >= widest && c->max_buffer <= INT32_MAX && window_suffices(c) &&
           c->lines_bytes >= widest + 2 * (size_t)gud_output_line_bytes(c);
}

/* ---- requests ---- */

static bool is_of_connector(uint8_t request)
{
    return request > GUD_GET_CONNECTORS && request <= GUD_GET_CONNECTOR_EDID;
}

/* Bytes that come with a request to the device; GUD_STALL for an unknown one. */
static int data_bytes(const struct gud_device *d, const struct gud_setup *setup)
{
    switch (setup->request) {
    case GUD_SET_CONNECTOR_FORCE_DETECT:
    case GUD_SET_STATE_COMMIT:
        return 0;
    case GUD_SET_BUFFER:
        return GUD_RECTANGLE_BYTES;
    case GUD_SET_STATE_CHECK:
        return d->config->dimmable && setup->length > GUD_STATE_BYTES ? GUD_DATA_BYTES : GUD_STATE_BYTES;
    case GUD_SET_CONTROLLER_ENABLE:
    case GUD_SET_DISPLAY_ENABLE:
        return 1;
    default:
        return GUD_STALL;
    }
}

static int refuse(struct gud_device *d, enum gud_status status)
{
    d->status = (uint8_t)status;
    return GUD_STALL;
}

int gud_device_setup(struct gud_device *d, const struct gud_setup *setup, uint8_t reply[GUD_REPLY_BYTES])
{
    if (setup->index != d->config->interface)
        return GUD_STALL; /* not to this display: its status stays */
    const bool in = setup->type == GUD_TYPE_IN;
    if (!in && setup->type != GUD_TYPE_OUT)
        return refuse(d, GUD_UNSUPPORTED);
    if (!in && setup->request == GUD_SET_BUFFER)
        gud_rectangle_close(d); /* bytes that follow are not for the last one */
    const int length = in ? gud_reply(d, setup->request, reply) : data_bytes(d, setup);
    if (length == GUD_STALL)
        return refuse(d, GUD_UNSUPPORTED);
    if (in ? setup->length == 0 : setup->length != length)
        return refuse(d, GUD_PROTOCOL);
    if (is_of_connector(setup->request) && setup->value != 0)
        return refuse(d, GUD_PARAMETER);
    if (setup->request != GUD_GET_STATUS)
        d->status = GUD_OK;
    return length < setup->length ? length : setup->length;
}

/* ---- what the host sets ---- */

static void update_display(struct gud_device *d)
{
    const struct gud_device_config *c = d->config;
    const bool shown = d->controller && d->display && !d->suspended;
    const uint8_t brightness = d->committed.format ? d->committed.brightness : d->brightness;
    if (shown == d->shown && brightness == d->brightness)
        return;
    const bool tell = shown || d->shown;
    d->shown = shown;
    d->brightness = brightness;
    if (tell && c->ops->display)
        c->ops->display(c->context, shown, brightness);
}

static bool is_offered(const struct gud_device_config *c, uint8_t format)
{
    for (unsigned i = 0; i < c->format_count; i++)
        if (c->formats[i] == format)
            return true;
    return false;
}

static enum gud_status check_state(struct gud_device *d, const uint8_t *data, unsigned bytes)
{
    const struct gud_device_config *c = d->config;
    struct gud_mode mode;
    gud_mode_unpack(&mode, data);
    struct gud_device_state state = {data[GUD_MODE_BYTES], d->brightness};
    const uint8_t connector = data[GUD_MODE_BYTES + 1];
    d->checked.format = NO_MODE_FORMAT;
    if (mode.hdisplay != c->width || mode.vdisplay != c->height || connector != 0 || !is_offered(c, state.format))
        return GUD_PARAMETER;
    if (bytes > GUD_STATE_BYTES) {
        const uint8_t *property = data + GUD_STATE_BYTES;
        for (unsigned i = 3; i < GUD_PROPERTY_BYTES; i++)
            if (property[i])
                return GUD_PARAMETER;
        if (property[0] != GUD_BRIGHTNESS || property[1] || property[2] > BRIGHTNESS_MOST)
            return GUD_PARAMETER;
        state.brightness = property[2];
    }
    d->checked = state;
    return GUD_OK;
}

static enum gud_status commit(struct gud_device *d)
{
    if (!d->controller || !d->checked.format)
        return GUD_PROTOCOL;
    gud_rectangle_close(d);
    d->committed = d->checked;
    update_display(d);
    return GUD_OK;
}

static enum gud_status enable(struct gud_device *d, bool *what, uint8_t value)
{
    if (value > 1)
        return GUD_PARAMETER;
    if (what == &d->display && value && !d->controller)
        return GUD_PROTOCOL;
    *what = value;
    if (!d->controller) {
        gud_rectangle_close(d);
        d->display = false;
    }
    update_display(d);
    return GUD_OK;
}

bool gud_device_set(struct gud_device *d, const struct gud_setup *setup, const uint8_t *data)
{
    enum gud_status status = GUD_OK; /* the connector's detection has nothing to do */
    switch (setup->request) {
    case GUD_SET_BUFFER:
        status = gud_rectangle_open(d, data);
        break;
    case GUD_SET_STATE_CHECK:
        status = check_state(d, data, setup->length);
        break;
    case GUD_SET_STATE_COMMIT:
        status = commit(d);
        break;
    case GUD_SET_CONTROLLER_ENABLE:
        status = enable(d, &d->controller, data[0]);
        break;
    case GUD_SET_DISPLAY_ENABLE:
        status = enable(d, &d->display, data[0]);
        break;
    }
    d->status = (uint8_t)status;
    return status == GUD_OK;
}

/* ---- bulk ---- */

uint32_t gud_device_expects(const struct gud_device *d)
{
    return d->bulk_left;
}

void gud_device_bulk(struct gud_device *d, const uint8_t *bytes, size_t count)
{
    if (count)
        gud_rectangle_open_whole(d);
    const enum gud_status status = gud_rectangle_bulk(d, bytes, count);
    if (status != GUD_OK)
        d->status = (uint8_t)status;
}

void gud_device_restart(struct gud_device *d)
{
    if (d->config->whole_frames)
        gud_rectangle_close(d);
}

/* Frames that nothing announces have no other beginning than the end of the one before. */
void gud_device_time(struct gud_device *d, uint32_t now_us)
{
    if (d->has_moved)
        d->moved_us = now_us;
    else if (d->open && !d->config->whole_frames && now_us - d->moved_us >= 1000 * (uint32_t)GUD_ABANDONED_MS)
        gud_rectangle_close(d);
    d->has_moved = false;
}

/* ---- the bus ---- */

void gud_device_reset(struct gud_device *d)
{
    gud_rectangle_close(d);
    d->status = GUD_OK;
    d->controller = d->display = d->suspended = false;
    update_display(d);
    d->checked.format = d->committed.format = NO_MODE_FORMAT;
    d->brightness = BRIGHTNESS_MOST;
}

void gud_device_suspend(struct gud_device *d)
{
    d->suspended = true;
    update_display(d);
}

void gud_device_resume(struct gud_device *d)
{
    d->suspended = false;
    update_display(d);
}
