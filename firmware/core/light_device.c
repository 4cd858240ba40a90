/* SPDX-License-Identifier: MIT */
#include "light_device.h"

static uint32_t map_bytes(const struct light_device *d)
{
    return 4 * (uint32_t)d->width * d->height;
}

/* ---- requests ---- */

static int refuse(struct light_device *d, enum gud_status status)
{
    d->status = (uint8_t)status;
    return GUD_STALL;
}

static int length_of(uint8_t request, bool in)
{
    switch (request) {
    case LIGHT_GET_STATUS:
        return in ? 1 : GUD_STALL;
    case LIGHT_GET_DESCRIPTOR:
        return in ? LIGHT_DESCRIPTOR_BYTES : GUD_STALL;
    case LIGHT_SET_ENABLE:
        return in ? GUD_STALL : 1;
    case LIGHT_SET_MATERIAL:
        return in ? GUD_STALL : LIGHT_MATERIAL_BYTES;
    case LIGHT_SET_MAP:
    case LIGHT_SET_MESH:
        return in ? GUD_STALL : 0;
    case LIGHT_SET_LIGHT:
        return in ? GUD_STALL : LIGHT_MESSAGE_BYTES;
    case LIGHT_GET_MESH:
        return in ? LIGHT_MESH_BYTES : GUD_STALL;
    case LIGHT_GET_LIGHT:
        return in ? LIGHT_MESSAGE_BYTES : GUD_STALL;
    default:
        return GUD_STALL;
    }
}

static void tell_light(const struct light_device *d, uint8_t reply[GUD_REPLY_BYTES])
{
    int32_t to_light[3] = {0, 0, 0};
    const enum light_sense sense = d->sense ? d->sense(to_light) : LIGHT_NO_SENSOR;
    light_message_pack(reply, sense, to_light);
}

int light_device_setup(struct light_device *d, const struct gud_setup *setup, uint8_t reply[GUD_REPLY_BYTES])
{
    const bool in = setup->type == GUD_TYPE_IN;
    const int length = in || setup->type == GUD_TYPE_OUT ? length_of(setup->request, in) : GUD_STALL;
    const bool of_mesh = setup->request == LIGHT_GET_MESH || setup->request == LIGHT_SET_MESH;
    if (length == GUD_STALL || (of_mesh && !d->mesh) || setup->index != d->interface)
        return refuse(d, GUD_UNSUPPORTED);
    if (in ? setup->length == 0 : setup->length != length)
        return refuse(d, GUD_PROTOCOL);
    if (setup->value != 0)
        return refuse(d, GUD_PARAMETER);
    if (setup->request == LIGHT_GET_STATUS) {
        reply[0] = d->status == GUD_OK && (d->count || d->is_drawing) ? GUD_BUSY : d->status;
    } else if (setup->request == LIGHT_GET_MESH) {
        light_mesh_pack(reply, d->mesh);
    } else if (setup->request == LIGHT_GET_LIGHT) {
        tell_light(d, reply);
    } else if (in) {
        const struct light_descriptor descriptor = {d->width, d->height};
        light_descriptor_pack(reply, &descriptor);
    }
    return length < setup->length ? length : setup->length;
}

static enum gud_status enable(struct light_device *d, uint8_t value)
{
    if (value > 1)
        return GUD_PARAMETER;
    if (value && !d->enabled && d->gud->open)
        return GUD_BUSY;
    light_device_reset(d);
    d->enabled = value;
    d->was_enabled |= value;
    return GUD_OK;
}

static enum gud_status set_material(struct light_device *d, const uint8_t *data)
{
    struct light_material material;
    const bool is_known = light_material_unpack(&material, data);
    const struct glint_material *m = &material.material;
    if (!d->enabled)
        return GUD_PROTOCOL;
    if (!is_known || m->model >= GLINT_MODEL_COUNT || m->model == GLINT_PHONG || m->n == 0 ||
        material.space > GLINT_LINEAR)
        return GUD_PARAMETER;
    d->material = material;
    d->has_material = d->is_new = true;
    return GUD_OK;
}

static enum gud_status begin_map(struct light_device *d)
{
    if (!d->map)
        return GUD_UNSUPPORTED;
    if (!d->enabled)
        return GUD_PROTOCOL;
    d->in_map = true;
    d->has_map = d->has_mesh = false;
    d->map_bytes = d->message_bytes = d->count = 0;
    return GUD_OK;
}

static enum gud_status use_mesh(struct light_device *d)
{
    if (!d->mesh)
        return GUD_UNSUPPORTED;
    if (!d->enabled)
        return GUD_PROTOCOL;
    d->in_map = d->has_map = false;
    d->has_mesh = d->is_new = true;
    d->message_bytes = d->count = 0;
    return GUD_OK;
}

static uint32_t size_of(int32_t v)
{
    return v < 0 ? 0 - (uint32_t)v : (uint32_t)v;
}

/* Straight from behind there is no half vector, nor where that is as good as so. */
static bool is_behind(const int32_t to_light[3])
{
    const uint32_t least = size_of(to_light[2]) >> 24;
    return to_light[2] <= 0 && size_of(to_light[0]) <= least && size_of(to_light[1]) <= least;
}

static enum gud_status give_light(struct light_device *d, const uint8_t *data)
{
    int32_t to_light[3];
    const uint32_t first = light_message_unpack(to_light, data);
    if (d->enabled)
        return GUD_PROTOCOL;
    if (first || is_behind(to_light)) /* 0, 0, 0, too */
        return GUD_PARAMETER;
    if (!d->is_given && d->gud->open)
        return GUD_BUSY;
    for (unsigned k = 0; k < 3; k++)
        d->given[k] = to_light[k];
    d->is_given = d->is_given_now = true;
    return GUD_OK;
}

bool light_device_set(struct light_device *d, const struct gud_setup *setup, const uint8_t *data)
{
    enum gud_status status = GUD_UNSUPPORTED;
    if (setup->request == LIGHT_SET_ENABLE)
        status = enable(d, data[0]);
    else if (setup->request == LIGHT_SET_MATERIAL)
        status = set_material(d, data);
    else if (setup->request == LIGHT_SET_MAP)
        status = begin_map(d);
    else if (setup->request == LIGHT_SET_MESH)
        status = use_mesh(d);
    else if (setup->request == LIGHT_SET_LIGHT)
        status = give_light(d, data);
    d->status = (uint8_t)status;
    return status == GUD_OK;
}

void light_device_reset(struct light_device *d)
{
    d->enabled = d->has_material = d->has_map = d->has_mesh = d->in_map = d->is_new = d->is_given = false;
    d->map_bytes = d->message_bytes = d->count = 0;
    d->status = GUD_OK;
}

/* ---- bulk ---- */

/* A map of normals is of about unit length; other data would be drawn in arbitrary colours, so it is refused. */
static bool is_normal(uint32_t word)
{
    const int32_t x = (int8_t)word, y = ((int32_t)(int16_t)word - x) / 256, z = (int32_t)word >> 16;
    const uint32_t square = (uint32_t)(x * x + y * y) * 65536 + (uint32_t)(z * z); /* < 2^32 */
    return z == 0 || square <= ((uint32_t)1 << 30) + ((uint32_t)1 << 25);
}

static void end_map(struct light_device *d)
{
    d->in_map = false;
    for (uint32_t i = 0; i < (uint32_t)d->width * d->height; i++)
        if (!is_normal(d->map[i])) {
            d->status = GUD_PARAMETER;
            return;
        }
    d->has_map = d->is_new = true;
}

static void enqueue(struct light_device *d)
{
    const unsigned place = (d->first + (unsigned)d->count) % LIGHT_QUEUE;
    d->message_bytes = 0;
    if (!light_device_has_scene(d) || d->count == LIGHT_QUEUE) {
        d->status = GUD_PROTOCOL;
        return;
    }
    if (!d->has_mesh) {
        (void)light_message_unpack(d->queue[place].to_light, d->message);
    } else if (!light_pose_unpack(&d->queue[place].pose, d->message)) {
        d->status = GUD_PARAMETER;
        return;
    }
    d->count++;
}

static unsigned message_bytes(const struct light_device *d)
{
    return d->has_mesh ? LIGHT_POSE_BYTES : LIGHT_MESSAGE_BYTES;
}

bool light_device_has_room(const struct light_device *d, size_t count)
{
    return d->in_map || (d->count + (d->message_bytes + count) / message_bytes(d)) <= LIGHT_QUEUE;
}

void light_device_bulk(struct light_device *d, const uint8_t *bytes, size_t count)
{
    for (; count && d->in_map; count--) {
        ((uint8_t *)d->map)[d->map_bytes++] = *bytes++; /* ports are little-endian, as the wire is */
        if (d->map_bytes == map_bytes(d))
            end_map(d);
    }
    for (; count; count--) {
        d->message[d->message_bytes++] = *bytes++;
        if (d->message_bytes == message_bytes(d))
            enqueue(d);
    }
}

/* ---- for the board ---- */

void light_device_time(struct light_device *d, uint32_t now_us)
{
    if (d->is_given_now)
        d->given_us = now_us;
    else if (d->is_given && now_us - d->given_us >= 1000 * (uint32_t)LIGHT_HELD_MS)
        d->is_given = false;
    d->is_given_now = false;
}

static void drop_first(struct light_device *d)
{
    d->first = (uint8_t)((d->first + 1) % LIGHT_QUEUE);
    d->count--;
}

bool light_device_next(struct light_device *d, int32_t to_light[3])
{
    if (!d->count || !d->has_material || !d->has_map)
        return false;
    for (unsigned k = 0; k < 3; k++)
        to_light[k] = d->queue[d->first].to_light[k];
    drop_first(d);
    return true;
}

bool light_device_next_pose(struct light_device *d, struct light_pose *pose)
{
    if (!d->count || !d->has_material || !d->has_mesh)
        return false;
    *pose = d->queue[d->first].pose;
    drop_first(d);
    return true;
}
