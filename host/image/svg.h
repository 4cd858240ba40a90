/* SPDX-License-Identifier: MIT
 * SVG files into images, by librsvg where glint was built with it. */
#ifndef GLINT_IMAGE_SVG_H
#define GLINT_IMAGE_SVG_H

#include <stdbool.h>
#include <stdio.h>

#include "image/image.h"

/* Can a file with this beginning be an SVG? */
bool svg_begins(const uint8_t *head, size_t length);
/* The rest of the stream after `head`, drawn at width x height pixels, with its sides in proportion and centered; 0, 0: at
 * the size that it states. `name`: for messages. Every error ends the program through fail(); without librsvg that is how
 * to convert it. */
struct image *svg_read(FILE *stream, const char *name, const uint8_t *head, size_t length, uint32_t width,
                       uint32_t height);
const char *svg_library(void); /* "librsvg 2.54.7", of which the headers are; NULL: built without it */

#endif
