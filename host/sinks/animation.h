/* SPDX-License-Identifier: MIT
 * What the sinks that write one animation share: when frames end, and a file that is written when all of them are there. */
#ifndef GLINT_SINKS_ANIMATION_H
#define GLINT_SINKS_ANIMATION_H

#include <stddef.h>
#include <stdint.h>

#include "base/output.h"
#include "sinks/sink.h"

struct animation {
    struct output *output; /* NULL once it is written */
    double fps;
    unsigned long frames; /* so far */
};

/* The sink of a size and a format as the user wished. */
struct sink animation_sink(const struct sink_wish *wish);
void animation_open(struct animation *animation, const struct sink_wish *wish);
/* When the frame with this number begins, in 1/unit of a second: rounded, so that errors do not add up. */
long animation_time(const struct animation *animation, unsigned long frame, unsigned unit);
/* The whole file; it gets its name. */
void animation_write(struct animation *animation, const struct sink *sink, const void *bytes, size_t count);
/* Where it was not written. */
void animation_discard(struct animation *animation);

#endif
