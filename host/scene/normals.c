/* SPDX-License-Identifier: MIT
 * Normals from height maps and normal maps. */
#include "scene/normals.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/message.h"

/* Scales to length 1; false where the length is under `least`. */
static bool normalize(double n[3], double least)
{
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length < least)
        return false;
    for (unsigned k = 0; k < 3; k++)
        n[k] /= length;
    return true;
}

/* ---- heights ---- */

/* The slope at `at` along a line of `count` heights that lie `step` apart. */
static double slope(const double *heights, size_t count, size_t step, size_t at, bool wraps)
{
    if (count == 1)
        return 0;
    size_t before = at ? at - 1 : at, after = at + 1 < count ? at + 1 : at;
    double run = (double)(after - before);
    if (wraps) {
        before = (at + count - 1) % count;
        after = (at + 1) % count;
        run = 2;
    }
    return (heights[after * step] - heights[before * step]) / run;
}

/* The lines `top` to `top + lines` of a relief of `height` lines. */
static struct scene *from_relief(const double *heights, uint32_t width, uint32_t height, double scale, bool wraps_x,
                                 bool wraps_y, uint32_t top, uint32_t lines)
{
    struct scene *scene = scene_new(width, lines);
    for (size_t y = 0; y < lines; y++) {
        for (size_t x = 0; x < width; x++) {
            double *n = scene->normals[y * width + x];
            n[0] = -scale * slope(&heights[(top + y) * width], width, 1, x, wraps_x);
            n[1] = scale * slope(&heights[x], height, width, top + y, wraps_y); /* lines go down, y goes up */
            normalize(n, 0);
        }
    }
    return scene;
}

struct scene *scene_from_relief(const double *heights, uint32_t width, uint32_t height, double scale, bool wraps)
{
    return from_relief(heights, width, height, scale, wraps, wraps, 0, height);
}

/* The lines above and below are read, too, where there are any. */
struct scene *scene_from_heights_lines(const struct image *map, double scale, bool wraps, uint32_t top, uint32_t lines)
{
    const uint32_t above = wraps || top > 0, below = wraps || top + lines < map->height;
    struct image *part = image_lines(map, (int64_t)top - (int64_t)above, above + lines + below);
    double *heights = image_grey(part);
    struct scene *scene = from_relief(heights, map->width, part->height, scale, wraps, false, above, lines);
    free(heights);
    image_free(part);
    return scene;
}

struct scene *scene_from_heights(const struct image *map, double scale, bool wraps)
{
    return scene_from_heights_lines(map, scale, wraps, 0, map->height);
}

/* ---- normal maps ---- */

/* Half grey in 8 bits is not exactly 0 (there is no 127.5). A vector that short has no direction. */
static const double shortest = 1.0 / 64;

static bool blue_is_nowhere(const struct image *map)
{
    const size_t samples = (size_t)map->width * map->height * map->channels;
    for (size_t i = 2; i < samples; i += map->channels)
        if (map->samples[i])
            return false;
    return true;
}

static void check_normal_map(const struct image *map)
{
    if (map->palette)
        fail("%s: has a palette; a normal map must hold its vectors as RGB or two channels", map->name);
    if (map->bits < 8)
        fail("%s: has %u bit%s a sample; a normal map needs 8 or 16", map->name, map->bits, map->bits == 1 ? "" : "s");
    if (map->channels == 1)
        fail("%s: has one channel; a normal map has RGB or two (for heights use --height)", map->name);
    if (map->channels >= 3 && image_is_grey(map))
        fail("%s: is grey throughout, so it holds no normals; for heights use --height", map->name);
}

static double component(uint16_t sample)
{
    return 2 * sample / 65535.0 - 1;
}

bool normal_map_is_xy(const struct image *map)
{
    check_normal_map(map);
    return map->channels == 2 || blue_is_nowhere(map);
}

struct scene *scene_from_normals_lines(const struct image *map, bool is_xy, bool flip_y, const uint8_t *mask,
                                       uint32_t top, uint32_t lines)
{
    struct scene *scene = scene_new(map->width, lines);
    for (size_t i = 0; i < (size_t)map->width * lines; i++) {
        const size_t line = (top + i / map->width) % map->height;
        const uint16_t *sample = &map->samples[(line * map->width + i % map->width) * map->channels];
        const double x = component(sample[0]);
        const double y = flip_y ? -component(sample[1]) : component(sample[1]);
        double n[3] = {x, y, is_xy ? sqrt(fmax(0, 1 - x * x - y * y)) : component(sample[2])};
        if (normalize(n, shortest))
            memcpy(scene->normals[i], n, sizeof n);
        else if (!mask || mask[i])
            fail("%s: the vector at %zu,%zu has length 0 (half grey); correct it, or leave such pixels out with --mask",
                 map->name, i % map->width, line);
    }
    return scene;
}

struct scene *scene_from_normals(const struct image *map, bool flip_y, const uint8_t *mask)
{
    return scene_from_normals_lines(map, normal_map_is_xy(map), flip_y, mask, 0, map->height);
}
