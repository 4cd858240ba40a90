/* SPDX-License-Identifier: MIT
 * Pictures into PNG, PPM and QOI files. */
#ifndef GLINT_IMAGE_WRITE_H
#define GLINT_IMAGE_WRITE_H

#include <stddef.h>

#include "image/picture.h"

enum image_kind { IMAGE_PNG, IMAGE_PPM, IMAGE_QOI, IMAGE_KINDS };
extern const char *const image_kind_names[]; /* "png" ..., by enum image_kind; ends with NULL */

/* By name ("png") or by a file name's ending, in either case; a name without an ending counts as PNG.
 * IMAGE_KINDS: neither. */
enum image_kind image_kind_by_name(const char *name);
enum image_kind image_kind_by_ending(const char *path);

struct output; /* base/output.h */
/* Writes the whole file; output_close then gives it its name. PPM stands for P6, P5 (grey) or P4 (mono), and has no
 * alpha: RGBA is not for it. QOI has RGB or RGBA. */
void pixels_write(const void *pixels, size_t len_bytes, struct output *output); /* the same, of bytes as they are */
void picture_write(const struct picture *picture, struct output *output, enum image_kind kind);
/* The same in parts of some lines, from the top: begun with the first, which is added as all others are. */
struct picture_file;
struct picture_file *picture_file_begin(struct output *output, enum image_kind kind, const struct picture *first,
                                        uint32_t height);
void picture_file_add(struct picture_file *file, const struct picture *lines);
void picture_file_end(struct picture_file *file);

#endif
