/* SPDX-License-Identifier: MIT
 * Median cut: the box of colours with the largest sum of squares is cut where its mean lies, until there are enough; then some rounds of
 * k-means. */
#include "mesh/texture_palette.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

enum { ALL = 1 << 16, ROUNDS = 6 };

/* A colour that there is, in levels of 255. */
struct color {
    double rgb[3], count;
    uint16_t number;
};

struct box {
    size_t first, end; /* of the colours */
    double squares;    /* of the distances from its mean, on its longest axis */
    double mean;       /* there */
    int axis;
};

static void measure(const struct color *colors, struct box *box)
{
    box->squares = -1;
    for (int k = 0; k < 3; k++) {
        double count = 0, sum = 0, squares = 0;
        for (size_t i = box->first; i < box->end; i++) {
            count += colors[i].count;
            sum += colors[i].count * colors[i].rgb[k];
            squares += colors[i].count * colors[i].rgb[k] * colors[i].rgb[k];
        }
        squares -= sum * sum / count;
        if (squares > box->squares) {
            box->squares = squares;
            box->mean = sum / count;
            box->axis = k;
        }
    }
    if (box->end - box->first < 2)
        box->squares = 0;
}

/* Those at most the mean come first; returns the first of the others. */
static size_t cut(struct color *colors, const struct box *box)
{
    size_t low = box->first;
    for (size_t i = box->first; i < box->end; i++)
        if (colors[i].rgb[box->axis] <= box->mean) {
            const struct color held = colors[low];
            colors[low++] = colors[i];
            colors[i] = held;
        }
    return low;
}

static void mean_of(const struct color *colors, const struct box *box, double rgb[3])
{
    double count = 0;
    memset(rgb, 0, 3 * sizeof *rgb);
    for (size_t i = box->first; i < box->end; i++) {
        count += colors[i].count;
        for (int k = 0; k < 3; k++)
            rgb[k] += colors[i].count * colors[i].rgb[k];
    }
    for (int k = 0; k < 3; k++)
        rgb[k] /= count;
}

static unsigned median_cut(struct color *colors, size_t count, double (*centers)[3])
{
    struct box boxes[TEXTURE_COLORS] = {{0, count, 0, 0, 0}};
    unsigned made = 1;
    measure(colors, &boxes[0]);
    while (made < TEXTURE_COLORS) {
        struct box *largest = boxes;
        for (unsigned i = 1; i < made; i++)
            if (boxes[i].squares > largest->squares)
                largest = &boxes[i];
        if (!(largest->squares > 0))
            break;
        const size_t at = cut(colors, largest);
        if (at == largest->end) { /* by rounding */
            largest->squares = 0;
            continue;
        }
        boxes[made] = (struct box){at, largest->end, 0, 0, 0};
        largest->end = at;
        measure(colors, largest);
        measure(colors, &boxes[made++]);
    }
    for (unsigned i = 0; i < made; i++)
        mean_of(colors, &boxes[i], centers[i]);
    return made;
}

static unsigned nearest(const double rgb[3], double (*centers)[3], unsigned count)
{
    unsigned best = 0;
    double least = INFINITY;
    for (unsigned i = 0; i < count; i++) {
        double sum = 0;
        for (int k = 0; k < 3; k++)
            sum += (rgb[k] - centers[i][k]) * (rgb[k] - centers[i][k]);
        if (sum < least) {
            least = sum;
            best = i;
        }
    }
    return best;
}

static void improve(const struct color *colors, size_t count, double (*centers)[3], unsigned made)
{
    double sums[TEXTURE_COLORS][4] = {{0}};
    for (size_t i = 0; i < count; i++) {
        double *sum = sums[nearest(colors[i].rgb, centers, made)];
        for (int k = 0; k < 3; k++)
            sum[k] += colors[i].count * colors[i].rgb[k];
        sum[3] += colors[i].count;
    }
    for (unsigned i = 0; i < made; i++)
        for (int k = 0; k < 3 && sums[i][3] > 0; k++)
            centers[i][k] = sums[i][k] / sums[i][3];
}

static struct color *colors_in(const uint16_t *pixels, size_t pixel_count, size_t *count)
{
    double *counts = allocate(ALL, sizeof *counts);
    struct color *colors = allocate(ALL, sizeof *colors);
    *count = 0;
    for (size_t i = 0; i < pixel_count; i++)
        counts[pixels[i]]++;
    for (unsigned i = 0; i < ALL; i++)
        if (counts[i] > 0)
            colors[(*count)++] = (struct color){
                {(i >> 11) * (255. / 31), (i >> 5 & 63) * (255. / 63), (i & 31) * (255. / 31)}, counts[i], (uint16_t)i};
    free(counts);
    return colors;
}

unsigned texture_palette(const uint16_t *pixels, size_t count, uint16_t *palette, uint8_t *indices)
{
    static const double max[3] = {31, 63, 31};
    double centers[TEXTURE_COLORS][3];
    size_t different;
    struct color *colors = colors_in(pixels, count, &different);
    uint8_t *index_of = allocate(ALL, 1);
    const unsigned made = median_cut(colors, different, centers);
    for (int round = 0; round < ROUNDS && different > made; round++)
        improve(colors, different, centers, made);
    for (unsigned i = 0; i < made; i++) {
        unsigned level[3];
        for (int k = 0; k < 3; k++) {
            level[k] = (unsigned)lround(centers[i][k] / 255 * max[k]);
            centers[i][k] = level[k] * 255 / max[k];
        }
        palette[i] = (uint16_t)(level[0] << 11 | level[1] << 5 | level[2]);
    }
    for (size_t i = 0; i < different; i++)
        index_of[colors[i].number] = (uint8_t)nearest(colors[i].rgb, centers, made);
    for (size_t i = 0; i < count; i++)
        indices[i] = index_of[pixels[i]];
    free(index_of);
    free(colors);
    return made;
}
