/* SPDX-License-Identifier: MIT */
#include "scene/logo.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
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

/* Sample i of a scaled line is what lies around place `first` + i * `step`, weighted by a triangle: the two samples beside it, or, where the
 * line becomes shorter, all that it stands for. */
struct scaling {
    double first, step, reach;
    double *weights; /* of each sample, together */
};

static double weight_of(const struct scaling *scaling, double place, int64_t at)
{
    return 1 - fabs((double)at - place) / scaling->reach;
}

/* Weights of the samples that stand for any of `of`; the others are 0. */
static struct scaling scaling_of(double first, double step, uint32_t count, uint32_t of)
{
    struct scaling scaling = {first, step, fmax(1, step), allocate(count, sizeof *scaling.weights)};
    for (uint32_t i = 0; i < count; i++) {
        const double place = first + i * step;
        const int64_t begin = (int64_t)ceil(place - scaling.reach), end = (int64_t)floor(place + scaling.reach);
        for (int64_t at = begin; begin < of && end >= 0 && at <= end; at++)
            scaling.weights[i] += weight_of(&scaling, place, at);
    }
    return scaling;
}

/* Beyond its ends a line is 0. */
static void scale_line(const struct line *from, const struct line *to, const struct scaling *scaling)
{
    for (uint32_t i = 0; i < to->count; i++) {
        const double place = scaling->first + i * scaling->step;
        const int64_t begin = (int64_t)ceil(place - scaling->reach), end = (int64_t)floor(place + scaling->reach);
        const int64_t last = end < from->count ? end : (int64_t)from->count - 1;
        double sum = 0;
        for (int64_t at = begin > 0 ? begin : 0; at <= last; at++)
            sum += weight_of(scaling, place, at) * from->samples[(size_t)at * from->apart];
        to->samples[i * to->apart] = begin < from->count && end >= 0 ? sum / scaling->weights[i] : 0;
    }
}

/* The place of a picture's first pixel, from the middle of the shape. */
static double first_place(const struct box *box, unsigned k, uint32_t side, double step)
{
    return (box->first[k] + box->last[k]) / 2. - (side - 1) / 2. * step;
}

/* Samples of a picture, line by line. */
struct plane {
    double *samples;
    uint32_t width, height;
};

/* All lines of one direction: 0 across, 1 down. It frees what it is given. */
static struct plane scaled(struct plane from, unsigned down, uint32_t count, double first, double step)
{
    struct plane to = {NULL, down ? from.width : count, down ? count : from.height};
    const struct scaling scaling = scaling_of(first, step, count, down ? from.height : from.width);
    to.samples = allocate((size_t)to.width * to.height, sizeof *to.samples);
    for (size_t i = 0; i < (down ? from.width : from.height); i++)
        scale_line(&(struct line){from.samples + (down ? i : i * from.width), down ? from.width : 1,
                                  down ? from.height : from.width},
                   &(struct line){to.samples + (down ? i : i * to.width), down ? to.width : 1, count}, &scaling);
    free(scaling.weights);
    free(from.samples);
    return to;
}

struct image *logo_fitted(const struct image *picture, uint32_t width, uint32_t height, double percent)
{
    struct plane plane = {bevel_coverage(picture), picture->width, picture->height};
    const struct box box = box_of(plane.samples, picture->width, picture->height);
    const double wide = box.last[0] - box.first[0] + 1., tall = box.last[1] - box.first[1] + 1.;
    const double step = fmax(wide / (width - 2), tall / (height - 2)) * 100 / percent;
    const uint32_t counts[2] = {width, height};
    /* First the way after which there is less. */
    const unsigned first = (uint64_t)width * picture->height > (uint64_t)picture->width * height;
    for (unsigned k = 0; k < 2; k++) {
        const unsigned down = k ^ first;
        plane = scaled(plane, down, counts[down], first_place(&box, down, counts[down], step), step);
    }
    struct image *image = allocate(1, sizeof *image);
    *image = (struct image){.name = copied(picture->name),
                            .width = width,
                            .height = height,
                            .channels = 1,
                            .bits = 16,
                            .is_coverage = true};
    image->samples = allocate((size_t)width * height, sizeof *image->samples);
    for (size_t i = 0; i < (size_t)width * height; i++)
        image->samples[i] = (uint16_t)lround(65535 * fmin(1, plane.samples[i]));
    free(plane.samples);
    return image;
}
