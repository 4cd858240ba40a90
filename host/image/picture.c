/* SPDX-License-Identifier: MIT */
#include "image/picture.h"

#include <stdlib.h>

#include "base/memory.h"

void picture_free(struct picture *picture)
{
    if (!picture)
        return;
    free(picture->samples);
    free(picture);
}

uint8_t *picture_rgb(const struct picture *picture)
{
    const size_t pixels = (size_t)picture->width * picture->height;
    uint8_t *rgb = allocate(pixels, 3);
    for (size_t i = 0; i < pixels; i++)
        for (unsigned k = 0; k < 3; k++)
            rgb[3 * i + k] = picture->samples[picture->channels * i + (picture->channels > 1 ? k : 0)];
    return rgb;
}
