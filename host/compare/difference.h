/* SPDX-License-Identifier: MIT
 * How far two pictures are apart. */
#ifndef GLINT_COMPARE_DIFFERENCE_H
#define GLINT_COMPARE_DIFFERENCE_H

#include <stdint.h>

/* Between two pictures, over all samples that are drawn; in levels of 255, whatever the format. */
struct difference {
    uint64_t samples, differing;
    double sum, sum_of_squares, largest;
    uint32_t x, y; /* of the largest */
    unsigned channel;
};
/* A sample, 0..1 in both. */
void difference_add(struct difference *d, double a, double b, uint32_t x, uint32_t y, unsigned channel);
/* As if all samples had been added to one. */
void difference_merge(struct difference *into, const struct difference *from);
double difference_psnr_db(const struct difference *difference); /* infinite where nothing differs */
double difference_mean(const struct difference *difference);
/* The name of the channel of the largest. */
const char *difference_channel(const struct difference *difference, unsigned channels);

#endif
