/* SPDX-License-Identifier: MIT
 * The host's side of GUD, whatever carries it: what a display says of itself, read and checked; its state.
 * Nothing here trusts the device: counts and sizes have limits. */
#ifndef GLINT_GUD_HOST_H
#define GLINT_GUD_HOST_H

#include "gud_protocol.h"
#include "sinks/gud/link.h"
#include "sinks/sink.h"

struct gud_choice; /* choose.h */

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

/* All of these return false with a problem. */

/* Descriptor only: is this a display at all? */
bool gud_descriptor_read(struct gud_link *link, struct gud_descriptor *descriptor, struct gud_problem *problem);
/* The descriptor, formats, the connector that has a panel, its modes. `detect`: the device looks for panels again. */
bool gud_display_read(struct gud_link *link, struct gud_display *display, bool detect, struct gud_problem *problem);
/* The mode set and the display on, in the order of the kernel's driver. */
bool gud_start(struct gud_link *link, const struct gud_display *display, const struct gud_choice *choice,
               struct gud_problem *problem);
/* The display off. */
bool gud_stop(struct gud_link *link, struct gud_problem *problem);
/* The next bytes on bulk OUT are this box: `bytes` of them, compressed or (as many as `length`) not. */
bool gud_rectangle_announce(struct gud_link *link, const struct piece *piece, struct gud_problem *problem);

#endif
