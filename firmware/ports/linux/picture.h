/* SPDX-License-Identifier: MIT
 * The picture that the host has drawn. */
#ifndef PICTURE_H
#define PICTURE_H

#include <stdbool.h>
#include <stdint.h>

#include "framebuffer.h"
#include "gud_device.h"
#include "options.h"

struct picture {
    uint16_t width, height;
    uint8_t *pixels; /* r, g, b */
    const char *output;
    unsigned each, files; /* numbered files: at most, and written */
    struct framebuffer framebuffer;
    struct glint_box box; /* the rectangle being drawn, and its next line */
    uint16_t next;
    bool shown; /* else the framebuffer is black, or as it was before the display was first switched on */
};
/* Fails where the framebuffer cannot be used, or options.output not be written. */
void picture_open(struct picture *picture, const struct options *options);
/* To options.output, whole or not at all. False: it warned. */
bool picture_write(const struct picture *picture);
extern const struct gud_device_ops picture_ops; /* their context is the picture */

#endif
