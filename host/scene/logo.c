/* SPDX-License-Identifier: MIT */
#include "scene/logo.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "scene/bevel.h"

/* The shape's first and last pixel, each way. */
struct box {
    uint32_t first[2], last[2];
};

static struct box box_of(const double *coverage, uint32_t width, uint32_t height)
{
    struct box box = {{width, height}, {0, 0}};
    for (uint32_t y = 0; y < height; y++)
        for (uint32_t x = 0; x < width; x++) {
            const uint32_t at[2] = {x, y};
            for (unsigned k = 0; coverage[(size_t)y * width + x] >= .5 && k < 2; k++) {
                box.first[k] = at[k] < box.first[k] ? at[k] : box.first[k];
                box.last[k] = at[k] > box.last[k] ? at[k] : box.last[k];
            }
        }
    return box;
}

/* A line of samples that are `apart` in memory. */
struct line {
    double *samples;
    size_t apart;
    uint32_t count;
};

/* Sample i of `to` is what lies around place `first` + i * `step` of `from`, weighted by a triangle: the two samples beside it, or, where
 * the line becomes shorter, all that it stands for. Beyond its ends a line is 0. */
static void scale_line(const struct line *from, const struct line *to, double first, double step)
{
    const double reach = fmax(1, step);
    for (uint32_t i = 0; i < to->count; i++) {
        const double place = first + i * step;
        double sum = 0, weights = 0;
        for (double at = ceil(place - reach); at <= place + reach; at++) {
            const double weight = 1 - fabs(at - place) / reach;
            weights += weight;
            if (at >= 0 && at < from->count)
                sum += weight * from->samples[(size_t)at * from->apart];
        }
        to->samples[i * to->apart] = sum / weights;
    }
}

/* The place of a picture's first pixel, from the middle of the shape. */
static double first_place(const struct box *box, unsigned k, uint32_t side, double step)
{
    return (box->first[k] + box->last[k]) / 2. - (side - 1) / 2. * step;
}

struct image *logo_fitted(const struct image *picture, uint32_t width, uint32_t height, double percent)
{
    double *coverage = bevel_coverage(picture);
    const struct box box = box_of(coverage, picture->width, picture->height);
    const double wide = box.last[0] - box.first[0] + 1., tall = box.last[1] - box.first[1] + 1.;
    const double step = fmax(wide / (width - 2), tall / (height - 2)) * 100 / percent;
    double *narrow = allocate((size_t)width * picture->height, sizeof *narrow);
    double *fitted = allocate((size_t)width * height, sizeof *fitted);
    for (uint32_t y = 0; y < picture->height; y++)
        scale_line(&(struct line){&coverage[(size_t)y * picture->width], 1, picture->width},
                   &(struct line){&narrow[(size_t)y * width], 1, width}, first_place(&box, 0, width, step), step);
    for (uint32_t x = 0; x < width; x++)
        scale_line(&(struct line){&narrow[x], width, picture->height}, &(struct line){&fitted[x], width, height},
                   first_place(&box, 1, height, step), step);
    struct image *image = allocate(1, sizeof *image);
    *image = (struct image){.name = strdup(picture->name), .width = width, .height = height, .channels = 1, .bits = 16};
    image->samples = allocate((size_t)width * height, sizeof *image->samples);
    if (!image->name)
        fail("out of memory");
    for (size_t i = 0; i < (size_t)width * height; i++)
        image->samples[i] = (uint16_t)lround(65535 * fmin(1, fitted[i]));
    free(coverage);
    free(narrow);
    free(fitted);
    return image;
}
