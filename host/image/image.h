/* SPDX-License-Identifier: MIT
 * Pictures in files: PNG read, PNG, PPM and QOI written. */
#ifndef GLINT_IMAGE_H
#define GLINT_IMAGE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What a side, and a picture of 8K UHD, needs; more is taken for a mistake or for an attack. */
enum { SIDE_MAX = 16384, PIXELS_MAX = 1 << 25 };

/* Grey of a colour, of 256: the weights of step 6 in glint.h. */
enum { GREY_RED = 54, GREY_GREEN = 183, GREY_BLUE = 19 };

/* A picture as read: 65535 = 1.0 whatever the file's depth (8-bit samples times 257), lines from the top. */
struct image {
    char *name; /* as the user named the file */
    uint32_t width, height;
    unsigned channels; /* 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA */
    unsigned bits;     /* of a sample in the file: 1, 2, 4, 8 or 16 */
    bool palette;
    uint16_t *samples;
};

/* Reads a PNG; "-" is standard input. Every error ends the program through fail(). */
struct image *image_read(const char *path);
void image_free(struct image *image);

/* Alpha is dropped, 16 bits are rounded to 8; malloc'd. */
uint8_t *image_rgb8(const struct image *image);
uint8_t *image_grey8(const struct image *image);
double *image_grey(const struct image *image); /* 0..1, at the file's full precision */
bool image_is_grey(const struct image *image); /* red, green and blue are equal throughout */

/* A picture to write: grey or RGB, 8 bits a sample. */
struct picture {
    uint32_t width, height;
    unsigned channels; /* 1 or 3 */
    bool mono;         /* 1 channel of 0 and 255 only: one bit a pixel where the file format has that */
    uint8_t *samples;
};

uint8_t *picture_rgb(const struct picture *picture); /* grey tripled; malloc'd */

enum image_kind { IMAGE_PNG, IMAGE_PPM, IMAGE_QOI, IMAGE_KINDS };

/* By name ("png") or by a file name's ending, whatever its case; a name without an ending counts as PNG.
 * IMAGE_KINDS: neither. */
enum image_kind image_kind_by_name(const char *name);
enum image_kind image_kind_by_ending(const char *path);

struct output; /* host.h */
/* As far as the file itself: only its name remains for output_close to give. PPM stands for P6, P5 (grey) or P4 (mono);
 * QOI has only RGB. */
void picture_write(const struct picture *picture, struct output *output, enum image_kind kind);

/* malloc that ends the program where there is no memory; count * size must not overflow (PIXELS_MAX sees to that). */
void *allocate(size_t count, size_t size);

#endif
