/* SPDX-License-Identifier: MIT */
#include "scene/filter.h"

#include <math.h>
#include <stdlib.h>

#include "base/memory.h"

/* A pixel of the smaller scene, as sums over those that become it, each times how much of it is drawn. */
struct sums {
    double drawn, normal[3], albedo[3], gloss, grain[2];
};

static struct sums sum(const struct scene *scene, uint32_t x, uint32_t y, unsigned times)
{
    struct sums s = {.drawn = 0};
    for (uint32_t i = 0; i < times * times; i++) {
        const size_t at = (size_t)(y * times + i / times) * scene->width + (size_t)x * times + i % times;
        const double drawn = scene->mask ? scene->mask[at] / 255. : 1;
        s.drawn += drawn;
        for (unsigned k = 0; k < 3; k++) {
            s.normal[k] += drawn * scene->normals[at][k];
            s.albedo[k] += scene->albedo ? drawn * scene->albedo[3 * at + k] : 0;
        }
        s.gloss += scene->gloss ? drawn * scene->gloss[at] : 0;
        if (scene->grain_map) { /* half a turn is the same grain, so angles are doubled to be added */
            s.grain[0] += drawn * cos(scene->grain_map[at] * M_PI / 128);
            s.grain[1] += drawn * sin(scene->grain_map[at] * M_PI / 128);
        }
    }
    return s;
}

static uint8_t *smaller(uint8_t *map, size_t bytes)
{
    return map ? allocate(bytes, 1) : NULL;
}

void scene_shrink(struct scene *scene, unsigned times)
{
    const struct scene old = *scene;
    scene->width = old.width / times;
    scene->height = old.height / times;
    const size_t pixels = (size_t)scene->width * scene->height;
    scene->normals = allocate(pixels, sizeof *scene->normals);
    scene->lengths = allocate(pixels, sizeof *scene->lengths);
    scene->albedo = smaller(old.albedo, 3 * pixels);
    scene->gloss = smaller(old.gloss, pixels);
    scene->mask = smaller(old.mask, pixels);
    scene->grain_map = smaller(old.grain_map, pixels);
    for (uint32_t y = 0; y < scene->height; y++) {
        for (uint32_t x = 0; x < scene->width; x++) {
            const size_t i = (size_t)y * scene->width + x;
            const struct sums s = sum(&old, x, y, times);
            const double length =
                sqrt(s.normal[0] * s.normal[0] + s.normal[1] * s.normal[1] + s.normal[2] * s.normal[2]);
            scene->lengths[i] = s.drawn > 0 ? fmin(1, length / s.drawn) : 1;
            for (unsigned k = 0; k < 3; k++) {
                scene->normals[i][k] = length > 0 ? s.normal[k] / length : k == 2;
                if (scene->albedo && s.drawn > 0)
                    scene->albedo[3 * i + k] = (uint8_t)lround(s.albedo[k] / s.drawn);
            }
            if (scene->gloss && s.drawn > 0)
                scene->gloss[i] = (uint8_t)lround(s.gloss / s.drawn);
            if (scene->mask)
                scene->mask[i] = (uint8_t)lround(255 * s.drawn / (times * times));
            if (scene->grain_map)
                scene->grain_map[i] = (uint8_t)lround(atan2(s.grain[1], s.grain[0]) * 128 / M_PI);
        }
    }
    for (unsigned k = 0; k < 2 && scene->grain.kind != GLINT_GRAIN_BRUSHED; k++)
        scene->grain.at[k] /= times;
    free(old.normals);
    free(old.albedo);
    free(old.gloss);
    free(old.mask);
    free(old.grain_map);
}

static uint8_t *filled(size_t pixels, const uint8_t *value, size_t bytes)
{
    uint8_t *map = allocate(pixels, bytes);
    for (size_t i = 0; i < pixels * bytes; i++)
        map[i] = value[i % bytes];
    return map;
}

void scene_soften(struct scene *scene, unsigned n, const uint8_t color[3])
{
    static const uint8_t full = 255;
    const size_t pixels = (size_t)scene->width * scene->height;
    if (!scene->lengths)
        return;
    scene->shininess = allocate(pixels, 1);
    if (!scene->gloss)
        scene->gloss = filled(pixels, &full, 1);
    if (!scene->albedo)
        scene->albedo = filled(pixels, color, 3);
    for (size_t i = 0; i < pixels; i++) {
        const double s = scene->lengths[i], wider = s * n / (s + n * (1 - s));
        scene->shininess[i] = glint_shininess_code((uint32_t)fmax(1, round(wider)));
        scene->gloss[i] = (uint8_t)lround(scene->gloss[i] * (1 + wider) / (1 + n));
        for (unsigned k = 0; k < 3; k++)
            scene->albedo[3 * i + k] = (uint8_t)lround(scene->albedo[3 * i + k] * s);
    }
    free(scene->lengths);
    scene->lengths = NULL;
}
