/* SPDX-License-Identifier: MIT */
#include "scene/curl.h"

#include <math.h>

/* Where a normal is steeper than this, its slope is mostly rounding. */
static const double least_z = .25;
/* How many times the squared curl must exceed that of the other way: noise gives 1, a surface hundreds. */
static const double factor = 4;
enum { PIXELS_LEAST = 64 };

/* The slopes of a surface, p across and q down, are those of one height at each pixel, so how p changes going down is how q
 * changes going across: dp/dy = dq/dx. With y the other way q has the other sign, and the two add up instead of
 * cancelling. */
void curl_add(struct curl *curl, const struct scene *scene, const uint8_t *mask)
{
    const size_t width = scene->width;
    for (size_t y = 1; y + 1 < scene->height; y++) {
        for (size_t x = 1; x + 1 < width; x++) {
            const size_t i = y * width + x;
            const size_t around[] = {i - width, i + width, i - 1, i + 1};
            bool counts = true;
            for (int k = 0; k < 4; k++)
                counts &= scene->normals[around[k]][2] > least_z && (!mask || mask[around[k]]);
            if (!counts)
                continue;
            const double *up = scene->normals[around[0]], *down = scene->normals[around[1]];
            const double *left = scene->normals[around[2]], *right = scene->normals[around[3]];
            const double dp = up[0] / up[2] - down[0] / down[2];       /* p = -x / z */
            const double dq = right[1] / right[2] - left[1] / left[2]; /* q = y / z: lines go down, y goes up */
            curl->as_it_is += (dp - dq) * (dp - dq);
            curl->flipped += (dp + dq) * (dp + dq);
            curl->count++;
        }
    }
}

bool curl_is_flipped(const struct curl *curl)
{
    return curl->count >= PIXELS_LEAST && curl->as_it_is > factor * curl->flipped;
}

bool curl_says_flipped(const struct scene *scene, const uint8_t *mask)
{
    struct curl curl = {0};
    curl_add(&curl, scene, mask);
    return curl_is_flipped(&curl);
}
