/* SPDX-License-Identifier: MIT
 * Normals into words and palettes. */
#include "bake/bake.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

const char *const bake_format_names[] = {"int16", "int8", "palette", NULL};

static bool has_surface(const struct scene *scene, size_t pixel)
{
    return !scene->mask || scene->mask[pixel];
}

#define BAKED_NAME(name, meaning) #name,
const char *const baked_map_names[] = {BAKED(BAKED_NAME)};
#define BAKED_MEANING(name, meaning) meaning,
const char *const baked_map_meanings[] = {BAKED(BAKED_MEANING)};

/* Edges that are soft, the way of the grain, and what a smaller scene became; a palette has none. */
static void bake_maps(struct baked *baked, const struct scene *scene)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    const uint8_t *maps[BAKED_MAPS] = {[BAKED_grain] = scene->grain_map,
                                       [BAKED_shininess] = scene->shininess,
                                       [BAKED_gloss] = scene->shininess ? scene->gloss : NULL};
    for (size_t i = 0; scene->mask && i < pixels && !maps[BAKED_coverage]; i++)
        if (scene->mask[i] && scene->mask[i] < 255)
            maps[BAKED_coverage] = scene->mask;
    for (unsigned k = 0; k < BAKED_MAPS && baked->format != BAKE_PALETTE; k++) {
        if (!maps[k])
            continue;
        baked->maps[k] = allocate(pixels, 1);
        memcpy(baked->maps[k], maps[k], pixels);
    }
}

static const struct glint_vec no_surface = {0, 0, 0};

/* A pixel without surface says how many there are from it to the right, so that a loop steps over them. */
static void add_runs(struct baked *baked)
{
    for (uint32_t y = 0; y < baked->height; y++) {
        uint32_t *line = &baked->words[(size_t)y * baked->width];
        uint32_t run = 0;
        for (uint32_t x = baked->width; x-- > 0;) {
            run = line[x] ? 0 : run + 1; /* at most SIDE_MAX */
            line[x] |= run;
        }
    }
}

static void bake_words(struct baked *baked, const struct glint_vec *normals, size_t pixels)
{
    baked->words = allocate(pixels, sizeof *baked->words);
    for (size_t i = 0; i < pixels; i++)
        baked->words[i] = glint_normals_pack(GLINT_NORMALS_INT8, &normals[i]);
    add_runs(baked);
}

static bool is_surface(struct glint_vec v)
{
    return v.x || v.y || v.z;
}

static void bake_palette(struct baked *baked, const struct glint_vec *normals, size_t pixels, uint32_t entries)
{
    struct glint_vec *drawn = allocate(pixels, sizeof *drawn);
    uint16_t *places = allocate(pixels, sizeof *places);
    size_t count = 0;
    for (size_t i = 0; i < pixels; i++)
        if (is_surface(normals[i]))
            drawn[count++] = normals[i];
    baked->normals = allocate(entries, sizeof *baked->normals);
    baked->normals[0] = no_surface;
    baked->entries = 1 + palette_choose(drawn, count, entries - 1, baked->normals + 1, places);
    baked->offsets = allocate(pixels, sizeof *baked->offsets);
    count = 0;
    for (size_t i = 0; i < pixels; i++)
        baked->offsets[i] = is_surface(normals[i]) ? (uint16_t)(2 * (1 + places[count++])) : 0;
    free(drawn);
    free(places);
}

struct baked *bake(const struct scene *scene, enum bake_format format, uint32_t entries)
{
    const size_t pixels = (size_t)scene->width * scene->height;
    struct baked *baked = allocate(1, sizeof *baked);
    *baked = (struct baked){.format = format, .width = scene->width, .height = scene->height};
    bake_maps(baked, scene);
    struct glint_vec *normals = scene_normals_q15(scene);
    for (size_t i = 0; i < pixels; i++)
        if (!has_surface(scene, i))
            normals[i] = no_surface;
    if (format == BAKE_INT16) {
        baked->normals = normals;
        return baked;
    }
    if (format == BAKE_PALETTE)
        bake_palette(baked, normals, pixels, entries);
    else
        bake_words(baked, normals, pixels);
    free(normals);
    return baked;
}

void bake_albedo(struct baked *baked, const struct scene *scene)
{
    baked->albedo = scene_albedo_565(scene, NULL);
}

void baked_free(struct baked *baked)
{
    free(baked->normals);
    free(baked->words);
    free(baked->offsets);
    free(baked->albedo);
    for (unsigned k = 0; k < BAKED_MAPS; k++)
        free(baked->maps[k]);
    free(baked);
}

size_t baked_bytes(const struct baked *baked)
{
    const size_t pixels = (size_t)baked->width * baked->height;
    size_t beside = baked->albedo ? pixels * sizeof *baked->albedo : 0;
    for (unsigned k = 0; k < BAKED_MAPS; k++)
        beside += baked->maps[k] ? pixels : 0;
    switch (baked->format) {
    case BAKE_INT16:
        return pixels * sizeof *baked->normals + beside;
    case BAKE_PALETTE:
        return baked->entries * sizeof *baked->normals + pixels * sizeof *baked->offsets;
    default:
        return pixels * sizeof *baked->words + beside;
    }
}

struct glint_vec baked_normal(const struct baked *baked, size_t pixel)
{
    switch (baked->format) {
    case BAKE_INT16:
        return baked->normals[pixel];
    case BAKE_PALETTE:
        return baked->normals[baked->offsets[pixel] / 2];
    default:
        return glint_normals_unpack(GLINT_NORMALS_INT8, baked->words[pixel]);
    }
}
