/* SPDX-License-Identifier: MIT
 * Which pixels of a frame changed. */
#ifndef GLINT_PLAN_CHANGES_H
#define GLINT_PLAN_CHANGES_H

#include "sinks/sink.h"

struct changes {
    uint16_t width, height;
    uint8_t *marks; /* a byte a pixel, not 0 where it changed; yours to free */
    size_t count;
    struct glint_box bounds; /* of all of them; w = 0: none */
};
void changes_init(struct changes *changes, uint16_t width, uint16_t height);
/* Between the pixels of the frame before (NULL: not known) and now. */
void changes_find(struct changes *changes, const uint8_t *last, const struct frame *now);

#endif
