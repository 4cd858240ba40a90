/* SPDX-License-Identifier: MIT
 *
 * GUD, the Generic USB Display protocol (Linux: include/drm/gud.h), as far as glint speaks it: numbers and messages, for
 * the device and for the host. On the wire everything is little-endian and packed; bulk data is w x h packed rows. */
#ifndef GUD_PROTOCOL_H
#define GUD_PROTOCOL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Control requests: bmRequestType c1 (in) or 41 (out), wIndex = the interface, wValue = the connector where there is one. */
enum gud_request {
    GUD_GET_STATUS = 0x00,     /* 1 byte, enum gud_status: read after a STALL, or after each SET if GUD_FLAG_STATUS */
    GUD_GET_DESCRIPTOR = 0x01, /* struct gud_descriptor */
    GUD_GET_FORMATS = 0x40,    /* a byte each, enum gud_format */
    GUD_GET_PROPERTIES = 0x41, /* 10 bytes each; may be empty */
    GUD_GET_CONNECTORS = 0x50, /* 5 bytes each: u8 type, u32 flags; at least 1 */
    GUD_GET_CONNECTOR_PROPERTIES = 0x51,
    GUD_SET_CONNECTOR_FORCE_DETECT = 0x53, /* empty */
    GUD_GET_CONNECTOR_STATUS = 0x54,       /* 1 byte: GUD_CONNECTOR_* */
    GUD_GET_CONNECTOR_MODES = 0x55,        /* struct gud_mode each */
    GUD_GET_CONNECTOR_EDID = 0x56,         /* may be empty */
    GUD_SET_BUFFER = 0x60,                 /* struct gud_rectangle, then its bytes on bulk OUT */
    GUD_SET_STATE_CHECK = 0x61,            /* struct gud_mode, u8 format, u8 connector, then properties */
    GUD_SET_STATE_COMMIT = 0x62,           /* empty */
    GUD_SET_CONTROLLER_ENABLE = 0x63,      /* 1 byte: 0 or 1 */
    GUD_SET_DISPLAY_ENABLE = 0x64          /* 1 byte: 0 or 1 */
};

enum gud_status {
    GUD_OK,
    GUD_BUSY,
    GUD_UNSUPPORTED, /* unknown request */
    GUD_PROTOCOL,    /* a wrong length */
    GUD_PARAMETER,   /* an invalid value */
    GUD_ERROR
};

enum gud_format {
    GUD_R1 = 0x01, /* most significant bit first, lines padded to bytes; x is a multiple of 8 */
    GUD_R8 = 0x08, /* grey */
    GUD_XRGB1111 = 0x20,
    GUD_RGB332 = 0x30,
    GUD_RGB565 = 0x40,
    GUD_RGB888 = 0x50, /* bytes b, g, r */
    GUD_XRGB8888 = 0x80,
    GUD_ARGB8888 = 0x81
};

enum {
    GUD_FLAG_STATUS = 1 << 0,      /* the host is to read the status after each SET */
    GUD_FLAG_FULL_UPDATE = 1 << 1, /* whole frames only; GUD_SET_BUFFER after one that failed; no LZ4 */
    GUD_COMPRESSION_LZ4 = 1,       /* a raw LZ4 block */
    GUD_VERSION = 1,
    GUD_INTERFACE_CLASS = 0xff,
    GUD_STATUS_MASK = 3, /* of a connector's status byte */
    GUD_DISCONNECTED = 0,
    GUD_CONNECTED = 1,
    GUD_CONNECTION_UNKNOWN = 2,
    GUD_STATUS_CHANGED = 1 << 7
};
enum { GUD_ABANDONED_MS = 4000 }; /* of a rectangle: hosts (Linux, glint) give one up after 3 s without progress */
/* Of a connector: u16 property, u64 value each. */
enum { GUD_BRIGHTNESS = 12 /* of the backlight, 0..100 */ };
#define GUD_MAGIC ((uint32_t)0x1d50614d)
#define GUD_MODE_PREFERRED ((uint32_t)1 << 10)

/* USB IDs that the kernel's driver takes, vendor << 16 | product. */
#define GUD_ID_OPENMOKO ((uint32_t)0x1d50614d)
#define GUD_ID_MCS ((uint32_t)0x16d010a9)
#define GUD_ID_PIDCODES ((uint32_t)0x12094fb3)

enum {
    GUD_DESCRIPTOR_BYTES = 30,
    GUD_MODE_BYTES = 24,
    GUD_RECTANGLE_BYTES = 25,
    GUD_STATE_BYTES = 26,
    GUD_PROPERTY_BYTES = 10,
    GUD_CONNECTOR_BYTES = 5
};

struct gud_descriptor {
    uint32_t flags;      /* GUD_FLAG_* */
    uint8_t compression; /* 0 or GUD_COMPRESSION_LZ4 */
    uint32_t max_buffer; /* bytes of a rectangle before compression; 0: no limit of its own. At least a line */
    uint32_t min_width, max_width, min_height, max_height;
};

struct gud_mode {
    uint32_t clock_khz;
    uint16_t hdisplay, hsync_start, hsync_end, htotal, vdisplay, vsync_start, vsync_end, vtotal;
    uint32_t flags; /* GUD_MODE_PREFERRED or 0 */
};

struct gud_rectangle {
    uint32_t x, y, width, height;
    uint32_t length;            /* bytes uncompressed */
    uint8_t compression;        /* 0 or GUD_COMPRESSION_LZ4 */
    uint32_t compressed_length; /* bytes on the wire where compressed, else 0 */
};

void gud_descriptor_pack(uint8_t out[GUD_DESCRIPTOR_BYTES], const struct gud_descriptor *descriptor);
/* False: wrong magic or version. Values are as sent; the caller checks them. */
bool gud_descriptor_unpack(struct gud_descriptor *descriptor, const uint8_t in[GUD_DESCRIPTOR_BYTES]);
void gud_mode_pack(uint8_t out[GUD_MODE_BYTES], const struct gud_mode *mode);
void gud_mode_unpack(struct gud_mode *mode, const uint8_t in[GUD_MODE_BYTES]);
void gud_rectangle_pack(uint8_t out[GUD_RECTANGLE_BYTES], const struct gud_rectangle *rectangle);
void gud_rectangle_unpack(struct gud_rectangle *rectangle, const uint8_t in[GUD_RECTANGLE_BYTES]);

/* Bytes of one line of `width` pixels; 0 for an unknown format. */
size_t gud_line_bytes(enum gud_format format, uint32_t width);

#endif
