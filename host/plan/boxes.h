/* SPDX-License-Identifier: MIT
 * Rectangles around what changed, and their price in bytes. */
#ifndef GLINT_PLAN_BOXES_H
#define GLINT_PLAN_BOXES_H

#include "plan/changes.h"

struct boxes {
    struct glint_box *list;
    size_t count, room;
};
void boxes_add(struct boxes *boxes, struct glint_box box);

/* The time that a box takes, counted in bytes that the sink could send meanwhile: before its first, and its own. */
struct box_price {
    double rectangle_bytes;
    double (*bytes)(const void *context, const struct glint_box *box);
    const void *context;
};

struct glint_box box_join(const struct glint_box *a, const struct glint_box *b); /* the smallest around both */

/* The spans that changed, from the top line down, grown together where that is cheaper; INFINITY where they were given up at `limit` bytes, and are not
 * all. */
double boxes_of_spans(const struct changes *changes, const struct box_price *price, double limit, struct boxes *boxes);

#endif
