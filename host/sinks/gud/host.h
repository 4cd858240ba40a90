/* SPDX-License-Identifier: MIT
 * The host's side of GUD, whatever carries it: what a display says of itself, read and checked; the format and mode
 * chosen; its state; pixels in its form. Nothing here trusts the device: counts and sizes have limits. */
#ifndef GLINT_GUD_HOST_H
#define GLINT_GUD_HOST_H

#include "sinks/sink.h"

#include "gud_protocol.h"

/* What carries control requests to one interface. */
struct gud_link {
    void *context;
    /* Returns the bytes moved or an enum gud_link_fault. */
    int (*control)(void *context, bool in, uint8_t request, uint16_t value, uint8_t *data, uint16_t bytes);
    bool status_wanted; /* set by gud_display_read: the device asks for it after each SET */
};

enum gud_link_fault {
    GUD_LINK_STALL = -1,
    GUD_LINK_GONE = -2,
    GUD_LINK_STOPPED = -3, /* by a signal */
    GUD_LINK_TIMEOUT = -4,
    GUD_LINK_ERROR = -5
};

/* Why something could not be: for one line, after the device's name. */
struct gud_problem {
    enum gud_link_fault fault; /* GUD_LINK_ERROR where it is the answer that is wrong */
    char text[200];
};

/* Always false, for `return`. */
bool gud_problem_is(struct gud_problem *problem, enum gud_link_fault fault, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The kernel driver's limits. */
enum {
    GUD_HOST_FORMATS_MAX = 32,
    GUD_HOST_CONNECTORS_MAX = 32,
    GUD_HOST_MODES_MAX = 128,
    GUD_HOST_FRAME_MAX = 64 << 20
};

struct gud_display {
    struct gud_descriptor descriptor;
    uint8_t formats[GUD_HOST_FORMATS_MAX]; /* enum gud_format, or what this does not know */
    size_t format_count;
    uint8_t connector, connector_count;
    struct gud_mode modes[GUD_HOST_MODES_MAX]; /* only those that the descriptor allows */
    size_t mode_count;
};

struct gud_choice {
    enum gud_format format;
    enum glint_format pixels; /* what the library is to write for it */
    struct gud_mode mode;
    size_t max_bytes; /* of a rectangle */
    bool lz4;
};

/* All of these return false with a problem. */

/* Descriptor only: is this a display at all? */
bool gud_descriptor_read(struct gud_link *link, struct gud_descriptor *descriptor, struct gud_problem *problem);
/* The descriptor, formats, the connector that has a panel, its modes. `detect`: the device is to look afresh. */
bool gud_display_read(struct gud_link *link, struct gud_display *display, bool detect, struct gud_problem *problem);
bool gud_choose(const struct gud_display *display, const struct sink_wish *wish, struct gud_choice *choice,
                struct gud_problem *problem);
/* The mode set and the display on, in the order of the kernel's driver. */
bool gud_start(struct gud_link *link, const struct gud_display *display, const struct gud_choice *choice,
               struct gud_problem *problem);
/* The display off. */
bool gud_stop(struct gud_link *link, struct gud_problem *problem);
/* The next bytes on bulk OUT are this box: `bytes` of them, compressed or (as many as `length`) not. */
bool gud_rectangle_announce(struct gud_link *link, const struct piece *piece, struct gud_problem *problem);

/* "rgb565" ...; NULL where unknown. */
const char *gud_format_name(uint8_t format);
const char *gud_fault_words(enum gud_link_fault fault);

/* ---- pixels (gud_pack.c) ---- */

size_t gud_box_bytes(enum gud_format format, const struct glint_box *box);
void gud_box_pack(enum gud_format format, const struct frame *frame, const struct glint_box *box, uint8_t *out);
/* The enum glint_format that a display's format is made from, or -1. */
int gud_glint_format(uint8_t format);

#endif
