/* SPDX-License-Identifier: MIT
 *
 * A GUD display, portable: a board's USB stack hands it control requests and bulk bytes, it hands lines of pixels to the
 * board's panel. No heap, no I/O; whatever a host sends, it writes to no memory but its config's.
 *
 *   setup   -> gud_device_setup: how many bytes follow (to the host, from it), or GUD_STALL
 *   data    -> gud_device_set: for requests to the device, when their data is there (also where they have none)
 *   bulk    -> gud_device_bulk: pieces of any size; gud_device_expects tells how much is to come
 *   bus     -> gud_device_reset, _suspend, _resume
 *   clock   -> gud_device_time, where something else may want the panel
 *
 * One thread at a time. A rectangle that ends early (the host gave up, the bus was reset) leaves its other lines as they
 * were; the next GUD_SET_BUFFER starts a new one, of whole frames the next commit. Bytes that no rectangle expects are dropped, and whole frames
 * that begin while the board is busy. A wrong LZ4 block draws what came before the fault. These leave GUD_PROTOCOL, GUD_BUSY or GUD_ERROR
 * as the status until the next request. */
#ifndef GUD_DEVICE_H
#define GUD_DEVICE_H

#include "glint.h"
#include "gud_protocol.h"
#include "lz4_block.h"

/* What it needs of a board. For each rectangle: window, then its lines from the top, then end, also where it is cut short
 * (`whole` is then false). A line's memory stays as it is until the call of `line` after it returns: so a board may start
 * DMA and return, and wait for that DMA before it starts the next. */
struct gud_device_ops {
    void (*window)(void *context, uint16_t x, uint16_t y, uint16_t width, uint16_t height);
    void (*line)(void *context, const uint8_t *pixels, size_t bytes);
    void (*end)(void *context, bool whole);
    /* Brightness is 0..100 as the eye sees it, and 0 is not dark; the picture stays. NULL: nothing to switch. */
    void (*display)(void *context, bool on, uint8_t brightness);
    /* Rectangles are refused with GUD_BUSY while it returns true; whole frames that nothing announces are dropped. NULL: never. */
    bool (*busy)(void *context);
};

/* Memory for lines, static: the widest format that is offered and the output's, in bytes a pixel. */
#define GUD_DEVICE_LINE_BYTES(width, in_bytes, out_bytes) ((size_t)(width) * ((in_bytes) + 2 * (size_t)(out_bytes)))

struct gud_device_config {
    uint16_t width, height;
    uint16_t refresh_hz;    /* stated to the host */
    uint8_t interface;      /* wIndex of its requests; others are refused (a board looks first for those of its own) */
    uint8_t output;         /* enum glint_format that lines have: GLINT_RGB565, GLINT_RGB565_SWAPPED or GLINT_RGB888 */
    const uint8_t *formats; /* enum gud_format, the best first */
    uint8_t format_count;   /* 1..GUD_FORMATS_MAX */
    bool status_after_set;  /* for USB stacks that cannot refuse a request once its data is there */
    bool dimmable;          /* offers brightness */
    /* For panels that do not take windows of any size: hosts send nothing else, without LZ4, and without GUD_SET_BUFFER until a
     * frame has failed. */
    bool whole_frames;
    uint32_t max_buffer; /* stated to hosts: bytes of a rectangle before compression; at least a line */
    uint8_t *lines;      /* GUD_DEVICE_LINE_BYTES */
    size_t lines_bytes;
    uint8_t *window; /* for LZ4, of at least max_buffer bytes or LZ4_BLOCK_REACH; NULL: no LZ4 */
    uint32_t window_bytes;
    const struct gud_device_ops *ops;
    void *context; /* of the ops */
};

struct gud_device {
    const struct gud_device_config *config; /* outlives the device */
    /* State, ours. */
    uint8_t status; /* of the last request, enum gud_status */
    bool controller, display, suspended, shown;
    uint8_t brightness;
    struct gud_device_state {
        uint8_t format; /* 0: none */
        uint8_t brightness;
    } checked, committed;
    uint32_t bulk_left; /* bytes on the wire */
    bool open;          /* between ops->window and ops->end */
    bool compressed;
    uint8_t half;   /* of the output lines: the one to be written next */
    bool has_moved; /* bytes have come since gud_device_time was called */
    uint16_t columns, lines_left;
    uint32_t line_bytes, line_filled;
    uint32_t moved_us;
    struct lz4_block lz4;
};

struct gud_setup {
    uint8_t type, request; /* bmRequestType, bRequest */
    uint16_t value, index, length;
};

enum {
    GUD_STALL = -1,
    GUD_FORMATS_MAX = 8,
    GUD_REPLY_BYTES = 32,                                  /* the longest */
    GUD_DATA_BYTES = GUD_STATE_BYTES + GUD_PROPERTY_BYTES, /* the longest that the device takes */
    GUD_TYPE_IN = 0xc1,
    GUD_TYPE_OUT = 0x41
};

/* False: the config is invalid (a size of 0, too little memory, an unknown format). */
bool gud_device_init(struct gud_device *device, const struct gud_device_config *config);
/* To the host: fills `reply` and returns its length, at most setup->length. To the device: returns setup->length, at most
 * GUD_DATA_BYTES. Or GUD_STALL; the host then asks for the status. */
int gud_device_setup(struct gud_device *device, const struct gud_setup *setup, uint8_t reply[GUD_REPLY_BYTES]);
/* The data of a request that gud_device_setup took. False: STALL. */
bool gud_device_set(struct gud_device *device, const struct gud_setup *setup, const uint8_t *data);
/* Bytes that the host has still to send for the rectangle; 0: none is expected. */
uint32_t gud_device_expects(const struct gud_device *device);
void gud_device_bulk(struct gud_device *device, const uint8_t *bytes, size_t count);
/* The host has halted the bulk endpoint or ended a halt: what nothing announces begins anew. */
void gud_device_restart(struct gud_device *device);
/* Call it often while a rectangle is open, with a clock of microseconds modulo 2^32: one that was announced ends where nothing has come for it for
 * GUD_ABANDONED_MS: its host is gone. */
void gud_device_time(struct gud_device *device, uint32_t now_us);
/* Bus reset, disconnect, deconfigured: all that the host had set is gone, the display is off. */
void gud_device_reset(struct gud_device *device);
/* The display is off between the two. */
void gud_device_suspend(struct gud_device *device);
void gud_device_resume(struct gud_device *device);

#endif
