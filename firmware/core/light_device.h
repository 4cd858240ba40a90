/* SPDX-License-Identifier: MIT
 *
 * The device's side of light_protocol.h, portable. The USB stack hands it requests and bulk bytes, as to gud_device.h; the
 * board takes material, map and lights from it. No heap, no I/O; whatever a host sends, it writes to the map's memory only. */
#ifndef LIGHT_DEVICE_H
#define LIGHT_DEVICE_H

#include "gud_device.h"
#include "light_protocol.h"

enum { LIGHT_QUEUE = 8 }; /* lights that wait for their frames */

struct light_device {
    /* Config, set by you. */
    uint16_t width, height;
    uint8_t interface;
    uint32_t *map;                                  /* width x height words; NULL: maps are refused */
    const struct light_mesh *mesh;                  /* that the board holds; NULL: none */
    enum light_sense (*sense)(int32_t to_light[3]); /* the room's light, where it is SENSED; NULL: no sensor */
    const struct gud_device
        *gud; /* whose memory the map may share: no rectangle of it is open while the map is the host's */

    /* State: read it. */
    bool enabled;      /* the host wants the panel */
    bool was_enabled;  /* some host wanted it since you last set this to false: the map's memory may be written */
    bool has_material; /* and the material below */
    bool has_map;      /* all of it, and all its words are normals */
    bool has_mesh;     /* the mesh is what is drawn, by poses; no map */
    bool is_drawing;   /* yours to set: the last light's frame is not complete on the panel */
    bool is_new;       /* material or map have changed since you last set this to false */
    struct light_material material;
    bool is_given;    /* a host has set the light of what the board shows by itself, and it has not expired */
    int32_t given[3]; /* that light */

    /* State, ours. */
    uint8_t status;
    bool is_given_now; /* since light_device_time was called */
    uint32_t given_us;
    bool in_map;        /* bulk bytes belong to the map */
    uint32_t map_bytes; /* that are there */
    uint8_t message[LIGHT_POSE_BYTES], message_bytes;
    uint8_t first, count; /* of the queue */
    union {
        int32_t to_light[3];
        struct light_pose pose; /* has_mesh */
    } queue[LIGHT_QUEUE];
};

/* As gud_device_setup and gud_device_set. */
int light_device_setup(struct light_device *device, const struct gud_setup *setup, uint8_t reply[GUD_REPLY_BYTES]);
bool light_device_set(struct light_device *device, const struct gud_setup *setup, const uint8_t *data);
/* Takes bulk bytes. Ask first whether there is room for them; if not, let them wait on the bus. */
bool light_device_has_room(const struct light_device *device, size_t count);
void light_device_bulk(struct light_device *device, const uint8_t *bytes, size_t count);
/* Bus reset, disconnect. */
void light_device_reset(struct light_device *device);

/* Call it often, with a clock of microseconds modulo 2^32: the light that is given expires. */
void light_device_time(struct light_device *device, uint32_t now_us);
/* The next frame's light; false: no light waits, or material or map are missing. */
bool light_device_next(struct light_device *device, int32_t to_light[3]);
/* The next frame's pose; false: none waits, or the material is missing, or the mesh has not been asked for. */
bool light_device_next_pose(struct light_device *device, struct light_pose *pose);
/* A map or the mesh. */
static inline bool light_device_has_scene(const struct light_device *device)
{
    return device->has_map || device->has_mesh;
}

#endif
