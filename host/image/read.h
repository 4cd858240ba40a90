/* SPDX-License-Identifier: MIT
 * PNG files into images. */
#ifndef GLINT_IMAGE_READ_H
#define GLINT_IMAGE_READ_H

#include "image/image.h"

/* "-" is standard input. Every error ends the program through fail(). */
struct image *image_read(const char *path);

#endif
