/* SPDX-License-Identifier: MIT */
#include "image/image.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "image/format.h"

void image_free(struct image *image)
{
    if (!image)
        return;
    free(image->name);
    free(image->samples);
    free(image);
}

struct image *image_lines(const struct image *image, int64_t first, uint32_t count)
{
    const size_t line = (size_t)image->width * image->channels;
    const int64_t height = image->height;
    struct image *out = allocate(1, sizeof *out);
    *out = *image;
    out->name = copied(image->name);
    out->height = count;
    out->samples = allocate(count * line, sizeof *out->samples);
    for (uint32_t y = 0; y < count; y++) {
        const int64_t from = (first + (int64_t)y) % height;
        memcpy(out->samples + y * line, image->samples + (size_t)(from < 0 ? from + height : from) * line,
               line * sizeof *out->samples);
    }
    return out;
}

static uint8_t to_8_bits(uint32_t sample)
{
    return (uint8_t)((sample + 128) / 257);
}

/* The pixel's colour as 0..65535: grey is repeated. */
static void color_at(const struct image *image, size_t pixel, uint16_t rgb[3])
{
    const uint16_t *sample = &image->samples[pixel * image->channels];
    for (unsigned k = 0; k < 3; k++)
        rgb[k] = sample[image->channels < 3 ? 0 : k];
}

static uint32_t weighted_at(const struct image *image, size_t pixel) /* 0..65535 * 256 */
{
    uint16_t rgb[3];
    color_at(image, pixel, rgb);
    return (uint32_t)GREY_RED * rgb[0] + (uint32_t)GREY_GREEN * rgb[1] + (uint32_t)GREY_BLUE * rgb[2];
}

uint8_t *image_rgb8(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    uint8_t *out = allocate(pixels, 3);
    for (size_t i = 0; i < pixels; i++) {
        uint16_t rgb[3];
        color_at(image, i, rgb);
        for (unsigned k = 0; k < 3; k++)
            out[3 * i + k] = to_8_bits(rgb[k]);
    }
    return out;
}

uint8_t *image_grey8(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    uint8_t *out = allocate(pixels, 1);
    for (size_t i = 0; i < pixels; i++)
        out[i] = to_8_bits((weighted_at(image, i) + 128) / 256);
    return out;
}

bool image_cuts_out(const struct image *image)
{
    const size_t samples = (size_t)image->width * image->height * image->channels;
    for (size_t i = image->channels - 1; image->channels % 2 == 0 && i < samples; i += image->channels)
        if (to_8_bits(image->samples[i]) == 0)
            return true;
    return false;
}

uint8_t *image_alpha8(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    uint8_t *out = allocate(pixels, 1);
    for (size_t i = 0; i < pixels; i++)
        out[i] = to_8_bits(image->samples[(i + 1) * image->channels - 1]);
    return out;
}

double *image_grey(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    double *out = allocate(pixels, sizeof *out);
    for (size_t i = 0; i < pixels; i++)
        out[i] = weighted_at(image, i) / (65535.0 * 256);
    return out;
}

bool image_is_grey(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    for (size_t i = 0; i < pixels; i++) {
        uint16_t rgb[3];
        color_at(image, i, rgb);
        if (rgb[0] != rgb[1] || rgb[1] != rgb[2])
            return false;
    }
    return true;
}

bool image_is_constant(const struct image *image)
{
    const size_t pixels = (size_t)image->width * image->height;
    for (size_t i = 1; i < pixels; i++)
        if (weighted_at(image, i) != weighted_at(image, 0))
            return false;
    return true;
}
