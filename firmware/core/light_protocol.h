/* SPDX-License-Identifier: MIT
 *
 * Light instead of pixels: a vendor interface beside the GUD display's, for devices that shade by themselves. A host sends
 * a normal map and a material once, then 16 bytes a frame. Little-endian, packed.
 *
 *   LIGHT_SET_ENABLE 1   the panel is the host's; GUD hosts that draw meanwhile are refused as busy
 *   LIGHT_SET_MATERIAL   the device fills its tables (a tenth of a second on an RP2040)
 *   LIGHT_SET_MAP        then the map's words on bulk OUT: width x height normals, GLINT_NORMALS_INT8, lines from the top
 *   LIGHT_SET_MESH       instead of a map: the mesh that lies in the device, if it holds one (LIGHT_GET_MESH)
 *   bulk OUT             light messages; poses, where it is the mesh. Those that the device has no room for wait on the bus: it sets the pace
 *   LIGHT_GET_LIGHT      at any time: where the room's light is, as the board's accelerometer has it
 *   LIGHT_SET_LIGHT      while the panel is not a host's: the light of what the board shows by itself
 *   LIGHT_SET_ENABLE 0   or a bus reset: the panel is given back
 *
 * The interface has class ff and one bulk OUT endpoint, and answers to GUD's descriptor request with a STALL, so that no GUD
 * driver takes it for a display. */
#ifndef LIGHT_PROTOCOL_H
#define LIGHT_PROTOCOL_H

#include "glint_mesh.h"

/* Control requests: bmRequestType c1 (in) or 41 (out), wValue 0, wIndex = the interface. The first number is GUD's, too, and
 * means the same; the others are none of GUD's. */
enum light_request {
    /* 1 byte, enum gud_status: of the last request or bulk data; GUD_BUSY while a light waits or is drawn */
    LIGHT_GET_STATUS = 0x00,
    LIGHT_GET_DESCRIPTOR = 0xa0, /* struct light_descriptor */
    LIGHT_SET_ENABLE = 0xa1,     /* 1 byte: 0 or 1 */
    LIGHT_SET_MATERIAL = 0xa2,   /* struct light_material */
    LIGHT_SET_MAP = 0xa3,        /* empty */
    /* Devices that hold no mesh, and older ones, refuse these two; so the version stays 1. */
    LIGHT_GET_MESH = 0xa4, /* struct light_mesh */
    LIGHT_SET_MESH = 0xa5, /* empty */
    /* Older devices refuse it, too. A light message whose first number is an enum light_sense. It changes nothing. */
    LIGHT_GET_LIGHT = 0xa6,
    /* Older devices refuse this, too. A light message whose first number is 0. The board shows its own scene, or mesh, under this light,
     * also where a GUD host draws, until none has come for LIGHT_HELD_MS. GUD_PARAMETER: a direction of zeros, or straight from behind;
     * GUD_PROTOCOL: the panel is the host's; GUD_BUSY: a GUD host draws a rectangle just now. */
    LIGHT_SET_LIGHT = 0xa7
};
/* What a board knows of the room's light; the direction is 0, 0, 0 unless it is SENSED. */
enum light_sense { LIGHT_NO_SENSOR, LIGHT_SENSOR_SILENT, LIGHT_SENSED };
#define LIGHT_MAGIC ((uint32_t)0x746e6c67) /* "glnt" */
enum {
    LIGHT_VERSION = 1,
    LIGHT_DESCRIPTOR_BYTES = 12,
    LIGHT_MATERIAL_BYTES = 48,
    LIGHT_MESSAGE_BYTES = 16, /* u32 of the host's own, then towards the light: 3 x i32 of any length */
    LIGHT_MESH_BYTES = 12,
    LIGHT_POSE_BYTES = 28, /* u32 of the host's own, then struct light_pose, and i16 0 */
    LIGHT_HELD_MS = 2500,  /* a page that is not seen sends once a second */
    LIGHT_CLAMP_PEAK = 1   /* in the material's flags */
};

struct light_descriptor {
    uint16_t width, height;
};

/* Which mesh it is: a host compares it with its own. */
struct light_mesh {
    uint32_t cksum; /* mesh_cksum.h */
    uint16_t vertices, faces;
    uint8_t split; /* degrees: `glint bake --split` */
};

/* A mesh's picture: parallel projection, a directional light, the distant viewer. */
struct light_pose {
    struct glint_pose pose;
    int16_t to_light[3]; /* of any length */
};

/* A material over the wire: the pixels are RGB565, undithered. */
struct light_material {
    struct glint_material material; /* n_across does not go over the wire: it is 0 */
    uint8_t space;
    uint16_t background; /* the pixel where the map has no surface */
};

void light_descriptor_pack(uint8_t out[LIGHT_DESCRIPTOR_BYTES], const struct light_descriptor *descriptor);
/* False where magic or version are wrong. */
bool light_descriptor_unpack(struct light_descriptor *descriptor, const uint8_t in[LIGHT_DESCRIPTOR_BYTES]);
/* What goes over the wire of a material and an output; the background is 0. */
void light_material_of(struct light_material *material, const struct glint_material *from,
                       const struct glint_output *output);
/* What the material is drawn to. */
void light_material_output(struct glint_output *output, const struct light_material *material);
void light_material_pack(uint8_t out[LIGHT_MATERIAL_BYTES], const struct light_material *material);
/* False where a flag is set that there is not. */
bool light_material_unpack(struct light_material *material, const uint8_t in[LIGHT_MATERIAL_BYTES]);
void light_message_pack(uint8_t out[LIGHT_MESSAGE_BYTES], uint32_t tag, const int32_t to_light[3]);
/* Returns the host's own number. */
uint32_t light_message_unpack(int32_t to_light[3], const uint8_t in[LIGHT_MESSAGE_BYTES]);

void light_mesh_pack(uint8_t out[LIGHT_MESH_BYTES], const struct light_mesh *mesh);
void light_mesh_unpack(struct light_mesh *mesh, const uint8_t in[LIGHT_MESH_BYTES]);
void light_pose_pack(uint8_t out[LIGHT_POSE_BYTES], uint32_t tag, const struct light_pose *pose);
/* False where the last number is not 0. */
bool light_pose_unpack(struct light_pose *pose, const uint8_t in[LIGHT_POSE_BYTES]);

#endif
