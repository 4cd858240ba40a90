/* SPDX-License-Identifier: MIT
 * What is sent of a frame: the pixels that changed, cut into rectangles, compressed or not, in the form that takes the
 * least time by the sink's own cost. */
#ifndef GLINT_PLAN_H
#define GLINT_PLAN_H

#include "sinks/sink.h"

struct plan_result {
    const struct piece *pieces; /* with their data, until the plan after the next */
    size_t count;               /* 0: nothing changed */
    size_t changed;             /* pixels */
    size_t whole_bytes;         /* of the frame in the sink's form */
    size_t bytes;               /* of the pieces */
};

struct plan;
struct plan *plan_new(const struct sink *sink);
void plan_free(struct plan *plan);
/* What turns the frame `last` (NULL: what is there is not known) into `now`. */
struct plan_result plan_frame(struct plan *plan, const uint8_t *last, const struct frame *now);

/* ---- candidates: boxes added to a list, and their price in bytes ---- */

struct boxes {
    struct glint_box *list;
    size_t count, room;
};
void boxes_add(struct boxes *boxes, struct glint_box box);

/* A frame's changes: a byte a pixel, not 0 where it changed. */
struct changes {
    uint16_t width, height;
    uint8_t *marks;
    size_t count;
    struct glint_box bounds; /* of all of them */
};
/* How a box's time is told, in bytes of the sink: those before its first, and its own. */
struct box_price {
    double rectangle_bytes;
    double (*bytes)(const void *context, const struct glint_box *box);
    const void *context;
};

struct glint_box box_join(const struct glint_box *a, const struct glint_box *b); /* the smallest around both */

/* The spans that changed, grown together where that is cheaper (plan_boxes.c). */
double boxes_of_spans(const struct changes *changes, const struct box_price *price, struct boxes *boxes);
/* The cheapest cuts along a grid (plan_tiles.c). */
double boxes_of_tiles(const struct changes *changes, const struct box_price *price, unsigned align_x,
                      struct boxes *boxes);

/* ---- what parts would take as LZ4 (plan_density.c) ---- */

struct density;
struct density *density_new(unsigned width, unsigned height);
void density_free(struct density *density);
void density_measure(struct density *density, const struct piece *pieces, size_t count); /* of a whole frame */
double density_bytes(const struct density *density, const struct glint_box *box);

#endif
