/* SPDX-License-Identifier: MIT */
#include "scene/bevel.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"

/* ---- distances ---- */

static const int64_t no_site = INT64_C(1) << 40; /* farther than any site; its square plus a site's fits 64 bits */

/* The line of the nearest site (coverage under 1/2) in each pixel's column: one sweep down, one up. */
static void nearest_in_columns(const double *coverage, uint32_t width, uint32_t height, int64_t *lines)
{
    for (size_t x = 0; x < width; x++) {
        int64_t last = -no_site;
        for (size_t y = 0; y < height; y++) {
            if (coverage[y * width + x] < .5)
                last = (int64_t)y;
            lines[y * width + x] = last;
        }
        last = no_site;
        for (size_t y = height; y-- > 0;) {
            int64_t *line = &lines[y * width + x];
            if (*line == (int64_t)y)
                last = *line;
            if (last - (int64_t)y < (int64_t)y - *line)
                *line = last;
        }
    }
}

/* A column's parabola over a line of pixels: at x its height is the squared distance to the column's site. */
struct parabola {
    int64_t column, site_line, height; /* height: at its own column; x is the first pixel where it is the lowest */
    int64_t first;
};

/* The first whole x where parabola b, right of a, lies lower than a. */
static int64_t crossing(const struct parabola *a, const struct parabola *b)
{
    const int64_t over = b->height - a->height + b->column * b->column - a->column * a->column;
    const int64_t step = 2 * (b->column - a->column);
    return over < 0 ? 0 : over / step + 1;
}

/* How far the edge lies inside the pixel of a site, towards the shape: half a pixel where coverage is 0 or 1; other coverages
 * of the site and its most covered neighbour move it. */
static double edge_beyond(const double *coverage, uint32_t width, uint32_t height, size_t x, size_t y)
{
    const double *at = &coverage[y * width + x];
    double most = 0;
    if (x > 0)
        most = fmax(most, at[-1]);
    if (x + 1 < width)
        most = fmax(most, at[1]);
    if (y > 0)
        most = fmax(most, *(at - width));
    if (y + 1 < height)
        most = fmax(most, at[width]);
    return .5 - *at + (most < .5 ? 0 : 1 - most);
}

/* Exact distances to the nearest site, in two passes (Felzenszwalb and Huttenlocher 2012): in columns first, then each line
 * is the lower envelope of its columns' parabolas. All in whole numbers, so ties and long distances are exact. */
double *bevel_distances(const double *coverage, uint32_t width, uint32_t height)
{
    int64_t *lines = allocate((size_t)width * height, sizeof *lines);
    double *distances = allocate((size_t)width * height, sizeof *distances);
    struct parabola *lowest = allocate(width, sizeof *lowest);
    nearest_in_columns(coverage, width, height, lines);
    for (size_t y = 0; y < height; y++) {
        size_t count = 0;
        for (size_t x = 0; x < width; x++) {
            const int64_t site = lines[y * width + x], down = site - (int64_t)y;
            if (llabs(site) == no_site)
                continue;
            struct parabola next = {(int64_t)x, site, down * down, 0};
            while (count && (next.first = crossing(&lowest[count - 1], &next)) <= lowest[count - 1].first)
                count--;
            if (!count)
                next.first = 0;
            if (next.first < (int64_t)width)
                lowest[count++] = next;
        }
        for (size_t x = 0, at = 0; x < width; x++) {
            while (at + 1 < count && lowest[at + 1].first <= (int64_t)x)
                at++;
            const struct parabola *p = &lowest[at];
            const int64_t across = (int64_t)x - p->column;
            const double far = sqrt((double)(across * across + p->height));
            const double beyond = edge_beyond(coverage, width, height, (size_t)p->column, (size_t)p->site_line);
            distances[y * width + x] = coverage[y * width + x] < .5 ? 0 : fmax(0, far - beyond);
        }
    }
    free(lines);
    free(lowest);
    return distances;
}

/* ---- the shape ---- */

/* 0..1 of the alpha, or NULL where it has no edge. */
static double *alpha_of(const struct image *picture)
{
    if (picture->channels % 2)
        return NULL;
    const size_t pixels = (size_t)picture->width * picture->height;
    double *alpha = allocate(pixels, sizeof *alpha), least = 1, most = 0;
    for (size_t i = 0; i < pixels; i++) {
        alpha[i] = picture->samples[(i + 1) * picture->channels - 1] / 65535.;
        least = fmin(least, alpha[i]);
        most = fmax(most, alpha[i]);
    }
    if (least < .5 && most >= .5)
        return alpha;
    free(alpha);
    return NULL;
}

static bool rim_is_bright(const double *coverage, uint32_t width, uint32_t height)
{
    const size_t last = ((size_t)height - 1) * width;
    double bright = 0;
    for (size_t x = 0; x < width; x++)
        bright += coverage[x] + coverage[last + x];
    for (size_t y = 0; y < height; y++)
        bright += coverage[y * width] + coverage[y * width + width - 1];
    return bright > (double)width + height;
}

/* The brightness, stretched from the picture's darkest to its brightest; inverted where the rim is bright. */
static double *brightness_of(const struct image *picture)
{
    const size_t pixels = (size_t)picture->width * picture->height;
    double *grey = image_grey(picture), least = 1, most = 0;
    for (size_t i = 0; i < pixels; i++) {
        least = fmin(least, grey[i]);
        most = fmax(most, grey[i]);
    }
    if (most - least < 1. / 255)
        fail("%s: --bevel: the picture has no shape: neither its alpha nor its brightness has an edge; give one whose "
             "background is transparent or of another brightness",
             picture->name);
    for (size_t i = 0; i < pixels; i++)
        grey[i] = (grey[i] - least) / (most - least);
    if (rim_is_bright(grey, picture->width, picture->height))
        for (size_t i = 0; i < pixels; i++)
            grey[i] = 1 - grey[i];
    return grey;
}

/* A line of heights, `step` apart, smoothed by weights 1 4 6 4 1; beyond its ends it stays level. */
static void smooth_line(double *heights, size_t count, size_t step, double *line)
{
    for (size_t i = 0; i < count; i++)
        line[i] = heights[i * step];
    for (size_t i = 0; i < count; i++) {
        const double *left = &line[i > 0 ? i - 1 : 0], *right = &line[i + 1 < count ? i + 1 : i];
        const double *far_left = &line[i > 1 ? i - 2 : 0], *far_right = &line[i + 2 < count ? i + 2 : count - 1];
        heights[i * step] = (*far_left + 4 * *left + 6 * line[i] + 4 * *right + *far_right) / 16;
    }
}

/* The steps of an edge drawn in pixels would show as furrows across the bevel. */
static void smooth(double *heights, uint32_t width, uint32_t height)
{
    double *line = allocate(width > height ? width : height, sizeof *line);
    for (size_t y = 0; y < height; y++)
        smooth_line(&heights[y * width], width, 1, line);
    for (size_t x = 0; x < width; x++)
        smooth_line(&heights[x], height, width, line);
    free(line);
}

double *bevel_coverage(const struct image *picture)
{
    double *alpha = picture->is_coverage ? image_grey(picture) : alpha_of(picture);
    return alpha ? alpha : brightness_of(picture);
}

double *bevel_heights(const struct image *picture, double width)
{
    double *coverage = bevel_coverage(picture);
    double *heights = bevel_distances(coverage, picture->width, picture->height);
    for (size_t i = 0; i < (size_t)picture->width * picture->height; i++) {
        const double left = 1 - fmin(1, heights[i] / width);
        heights[i] = sqrt(1 - left * left);
    }
    smooth(heights, picture->width, picture->height);
    free(coverage);
    return heights;
}
