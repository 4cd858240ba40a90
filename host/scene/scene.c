/* SPDX-License-Identifier: MIT */
#include "scene/scene.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/stop.h"
#include "image/format.h"

const struct finish plain_finish = {60, 0, {.2, .2, .2}, {.9, .9, .9}, {.5, .5, .5}};

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
    free(scene->grain_map);
    free(scene->backdrop);
    free(scene->lengths);
    free(scene->shininess);
    free(scene->parts);
    free(scene->places);
    free(scene);
}

/* Each map, and the bytes of a pixel in it. */
#define SCENE_MAPS(X)                                                                                                  \
    X(normals, sizeof(double[3]))                                                                                      \
    X(albedo, 3)                                                                                                       \
    X(gloss, 1)                                                                                                        \
    X(mask, 1)                                                                                                         \
    X(grain_map, 1)                                                                                                    \
    X(lengths, sizeof(double))                                                                                         \
    X(shininess, 1)

/* The map repeated to width x height. NULL stays NULL. */
static void *repeated(const void *map, const struct scene *scene, uint32_t width, uint32_t height, size_t size)
{
    if (!map)
        return NULL;
    uint8_t *to = allocate((size_t)width * height, size);
    for (size_t y = 0; y < height; y++) {
        const uint8_t *line = (const uint8_t *)map + y % scene->height * scene->width * size;
        for (size_t x = 0; x < width; x++)
            memcpy(&to[(y * width + x) * size], &line[x % scene->width * size], size);
    }
    return to;
}

void scene_repeat(struct scene *scene, uint32_t width, uint32_t height)
{
    const struct scene from = *scene;
#define REPEAT(map, size)                                                                                              \
    scene->map = repeated(from.map, &from, width, height, size);                                                       \
    free(from.map);
    SCENE_MAPS(REPEAT)
#undef REPEAT
    scene->width = width;
    scene->height = height;
}

static void *cropped(const void *map, const struct scene *scene, uint32_t top, uint32_t lines, size_t size)
{
    if (!map)
        return NULL;
    void *to = allocate((size_t)scene->width * lines, size);
    memcpy(to, (const uint8_t *)map + (size_t)top * scene->width * size, (size_t)scene->width * lines * size);
    return to;
}

struct scene *scene_part(const struct scene *scene, uint32_t top, uint32_t lines)
{
    struct scene *part = allocate(1, sizeof *part);
    *part = (struct scene){.width = scene->width, .height = lines, .grain = scene->grain, .finish = scene->finish};
#define COPY(map, size) part->map = cropped(scene->map, scene, top, lines, size);
    SCENE_MAPS(COPY)
#undef COPY
    return part;
}

static int16_t to_q15(double value)
{
    return (int16_t)fmax(-32768, fmin(32767, round(value * 32768)));
}

struct glint_vec *scene_normals_q15(const struct scene *scene)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    struct glint_vec *out = allocate(pixels, sizeof *out);
    sigset_t before;
    signals_hold_but_faults(&before); /* the first thread alone takes them */
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < pixels; i++) {
        const double *n = scene->normals[i];
        out[i] = (struct glint_vec){to_q15(n[0]), to_q15(n[1]), to_q15(n[2])};
    }
    signals_release(&before);
    return out;
}

uint16_t *scene_albedo_565(const struct scene *scene, const uint8_t color[3])
{
    const size_t pixels = (size_t)scene->width * scene->height;
    uint16_t *map = allocate(pixels, sizeof *map);
    for (size_t i = 0; i < pixels; i++)
        map[i] = format_nearest_565(scene->albedo ? &scene->albedo[3 * i] : color);
    return map;
}
