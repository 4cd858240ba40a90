/* SPDX-License-Identifier: MIT */
#include "compare/difference.h"

#include <math.h>
#include <stdbool.h>

double difference_psnr_db(const struct difference *d)
{
    return d->sum_of_squares > 0 ? 10 * log10(255. * 255. * (double)d->samples / d->sum_of_squares) : INFINITY;
}

double difference_mean(const struct difference *d)
{
    return d->samples ? d->sum / (double)d->samples : 0;
}

void difference_add(struct difference *d, double a, double b, uint32_t x, uint32_t y, unsigned channel)
{
    const double off = 255 * fabs(a - b);
    d->samples++;
    d->differing += off > 0;
    d->sum += off;
    d->sum_of_squares += off * off;
    if (off > d->largest) {
        d->largest = off;
        d->x = x;
        d->y = y;
        d->channel = channel;
    }
}

const char *difference_channel(const struct difference *d, unsigned channels)
{
    static const char *const names[] = {"red", "green", "blue"};
    return channels == 1 ? "grey" : names[d->channel];
}

void difference_merge(struct difference *into, const struct difference *from)
{
    const bool larger = from->largest > into->largest;
    const struct difference sum = {.samples = into->samples + from->samples,
                                   .differing = into->differing + from->differing,
                                   .sum = into->sum + from->sum,
                                   .sum_of_squares = into->sum_of_squares + from->sum_of_squares,
                                   .largest = larger ? from->largest : into->largest,
                                   .x = larger ? from->x : into->x,
                                   .y = larger ? from->y : into->y,
                                   .channel = larger ? from->channel : into->channel};
    *into = sum;
}
