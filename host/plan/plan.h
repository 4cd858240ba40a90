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
/* The least that the sink takes of a frame that is there. */
struct plan_result plan_little(struct plan *plan, const struct frame *now);

#endif
