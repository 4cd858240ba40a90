/* SPDX-License-Identifier: MIT */
#include "image/levels.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "image/format.h"

struct levels *levels_of_pixels(uint32_t width, uint32_t height, enum glint_format format, const uint8_t *pixels)
{
    const size_t bytes = format_line_bytes(format, width);
    struct levels *levels = allocate(1, sizeof *levels);
    *levels = (struct levels){width, height, format_channels(format), {0}, NULL};
    for (unsigned k = 0; k < levels->channels; k++)
        levels->max[k] = format_max(format, k);
    levels->values = allocate((size_t)width * height, levels->channels);
    for (size_t i = 0; i < (size_t)width * height; i++)
        format_unpack(&pixels[i / width * bytes], format, i % width, &levels->values[i * levels->channels]);
    return levels;
}

void levels_free(struct levels *levels)
{
    if (!levels)
        return;
    free(levels->values);
    free(levels);
}

/* The level's bits, again and again until there are 8 of them; `max` is 2^bits - 1. */
static unsigned replicate(unsigned level, unsigned max)
{
    unsigned sample = level, filled = max;
    while (filled < 255) {
        sample = sample * (max + 1) + level;
        filled = filled * (max + 1) + max;
    }
    while (filled > 255) {
        sample >>= 1;
        filled >>= 1;
    }
    return sample;
}

struct picture *levels_picture(const struct levels *levels, enum widen widen)
{
    const size_t samples = (size_t)levels->width * levels->height * levels->channels;
    struct picture *picture = allocate(1, sizeof *picture);
    *picture = (struct picture){levels->width, levels->height, levels->channels, levels->max[0] == 1, NULL};
    picture->samples = allocate(samples, 1);
    for (size_t i = 0; i < samples; i++) {
        const unsigned max = levels->max[i % levels->channels], level = levels->values[i];
        picture->samples[i] =
            (uint8_t)(widen == WIDEN_REPLICATE ? replicate(level, max) : (255 * level + max / 2) / max);
    }
    return picture;
}

void picture_add_alpha(struct picture *picture, enum glint_format format, const uint8_t *pixels)
{
    if (!format_has_alpha(format))
        return;
    const size_t count = (size_t)picture->width * picture->height;
    uint8_t *samples = allocate(count, 4);
    for (size_t i = 0; i < count; i++) {
        memcpy(&samples[4 * i], &picture->samples[3 * i], 3);
        samples[4 * i + 3] = pixels[4 * i + 3];
    }
    free(picture->samples);
    picture->samples = samples;
    picture->channels = 4;
}
