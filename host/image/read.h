/* SPDX-License-Identifier: MIT
 * PNG and SVG files into images. */
#ifndef GLINT_IMAGE_READ_H
#define GLINT_IMAGE_READ_H

#include "image/image.h"

/* "-" is standard input. Every error ends the program through fail(). */
struct image *image_read(const char *path);
/* An SVG at this size, 0, 0: its own; a PNG at its own in any case. */
struct image *image_read_sized(const char *path, uint32_t width, uint32_t height);

#endif
