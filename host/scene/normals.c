/* SPDX-License-Identifier: MIT
 * Scenes from height and normal maps, and normals as the library takes them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "image/image.h"
#include "scene/scene.h"

static const struct finish plain_finish = {60, {.2, .2, .2}, {.9, .9, .9}, {.5, .5, .5}};

struct scene *scene_new(uint32_t width, uint32_t height)
{
    struct scene *scene = allocate(1, sizeof *scene);
    scene->width = width;
    scene->height = height;
    scene->normals = allocate((size_t)width * height, sizeof *scene->normals);
    scene->finish = plain_finish;
    for (size_t i = 0; i < (size_t)width * height; i++)
        scene->normals[i][2] = 1;
    return scene;
}

void scene_free(struct scene *scene)
{
    if (!scene)
        return;
    free(scene->normals);
    free(scene->albedo);
    free(scene->gloss);
    free(scene->mask);
    free(scene);
}

/* The map, repeated to width x height, in place of the one given; NULL stays. */
static void *repeated(void *map, const struct scene *scene, uint32_t width, uint32_t height, size_t size)
{
    if (!map)
        return NULL;
    uint8_t *to = allocate((size_t)width * height, size);
    for (size_t y = 0; y < height; y++) {
        const uint8_t *line = (const uint8_t *)map + y % scene->height * scene->width * size;
        for (size_t x = 0; x < width; x++)
            memcpy(&to[(y * width + x) * size], &line[x % scene->width * size], size);
    }
    free(map);
    return to;
}

void scene_repeat(struct scene *scene, uint32_t width, uint32_t height)
{
    scene->normals = repeated(scene->normals, scene, width, height, sizeof *scene->normals);
    scene->albedo = repeated(scene->albedo, scene, width, height, 3);
    scene->gloss = repeated(scene->gloss, scene, width, height, 1);
    scene->mask = repeated(scene->mask, scene, width, height, 1);
    scene->width = width;
    scene->height = height;
}

static int16_t to_q15(double value)
{
    return (int16_t)fmax(-32768, fmin(32767, round(value * 32768)));
}

struct glint_vec *scene_normals_q15(const struct scene *scene)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    struct glint_vec *out = allocate(pixels, sizeof *out);
    for (size_t i = 0; i < pixels; i++) {
        const double *n = scene->normals[i];
        out[i] = (struct glint_vec){to_q15(n[0]), to_q15(n[1]), to_q15(n[2])};
    }
    return out;
}

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

struct scene *scene_from_heights(const struct image *map, double scale, bool wraps)
{
    struct scene *scene = scene_new(map->width, map->height);
    double *heights = image_grey(map);
    const size_t width = map->width;
    for (size_t y = 0; y < map->height; y++) {
        for (size_t x = 0; x < width; x++) {
            double *n = scene->normals[y * width + x];
            n[0] = -scale * slope(&heights[y * width], width, 1, x, wraps);
            n[1] = scale * slope(&heights[x], map->height, width, y, wraps); /* lines go down, y goes up */
            normalize(n, 0);
        }
    }
    free(heights);
    return scene;
}

/* ---- normal maps ---- */

/* Shorter than what half grey in 8 bits leaves (127.5 is not there to be had): it points nowhere. */
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

struct scene *scene_from_normals(const struct image *map, bool flip_y, const uint8_t *mask)
{
    check_normal_map(map);
    const bool is_xy = map->channels == 2 || blue_is_nowhere(map);
    struct scene *scene = scene_new(map->width, map->height);
    for (size_t i = 0; i < (size_t)map->width * map->height; i++) {
        const uint16_t *sample = &map->samples[i * map->channels];
        const double x = component(sample[0]);
        const double y = flip_y ? -component(sample[1]) : component(sample[1]);
        double n[3] = {x, y, is_xy ? sqrt(fmax(0, 1 - x * x - y * y)) : component(sample[2])};
        if (normalize(n, shortest))
            memcpy(scene->normals[i], n, sizeof n);
        else if (!mask || mask[i])
            fail("%s: the vector at %zu,%zu has length 0 (half grey); mend it, or leave such pixels out with --mask",
                 map->name, i % map->width, i / map->width);
    }
    return scene;
}
