/* SPDX-License-Identifier: MIT
 * Scenes from the files and names that the user gave. */
#include "scene/maps.h"

#include <stdlib.h>

#include "base/memory.h"
#include "base/message.h"
#include "image/image.h"
#include "image/read.h"
#include "scene/normals.h"
#include "scene/scenes.h"

enum { SCENE_SIDE = 320 };

static struct image *read_map(const char *path)
{
    return path ? image_read(path) : NULL;
}

/* A map that goes with the scene, pixel for pixel. */
static void check_same_size(const struct image *map, const struct scene *scene, const char *what)
{
    if (map->width != scene->width || map->height != scene->height)
        fail("%s: %ux%u pixels, but %s has %ux%u; both must have the same size", map->name, map->width, map->height,
             what, scene->width, scene->height);
}

/* The picture that holds the surface, and those that go with it; NULL where there is none. */
struct scene_maps {
    struct scene_options options;
    struct image *surface, *albedo, *gloss, *mask;
};

struct scene_maps *scene_maps_read(const struct scene_options *options)
{
    struct scene_maps *maps = allocate(1, sizeof *maps);
    *maps = (struct scene_maps){*options, read_map(options->heights ? options->heights : options->normals),
                                read_map(options->albedo), read_map(options->gloss), read_map(options->mask)};
    return maps;
}

void scene_maps_free(struct scene_maps *maps)
{
    image_free(maps->surface);
    image_free(maps->albedo);
    image_free(maps->gloss);
    image_free(maps->mask);
    free(maps);
}

void scene_maps_size(const struct scene_maps *maps, uint32_t *width, uint32_t *height)
{
    *width = *height = 0;
    if (maps->surface) {
        *width = maps->surface->width;
        *height = maps->surface->height;
    }
}

static struct scene *scene_of_heights(const struct scene_maps *maps, uint32_t width, uint32_t height)
{
    const struct image *map = maps->surface;
    const bool repeats = width > map->width || height > map->height;
    return scene_from_heights(map, maps->options.scale, maps->options.wraps || repeats);
}

static struct scene *scene_of_normals(const struct scene_maps *maps)
{
    const struct image *map = maps->surface, *mask = maps->mask;
    uint8_t *drawn = NULL;
    if (mask && mask->width == map->width && mask->height == map->height)
        drawn = image_grey8(mask);
    struct scene *scene = scene_from_normals(map, maps->options.flip_y, drawn);
    free(drawn);
    return scene;
}

static void replace(uint8_t **map, uint8_t *by)
{
    free(*map);
    *map = by;
}

struct scene *scene_of_maps(const struct scene_maps *maps, uint32_t width, uint32_t height)
{
    const struct scene_options *options = &maps->options;
    if (!width) {
        width = options->width;
        height = options->height;
    }
    struct scene *scene;
    const char *what;
    if (options->heights) {
        scene = scene_of_heights(maps, width, height);
        what = "the height map";
    } else if (options->normals) {
        scene = scene_of_normals(maps);
        what = "the normal map";
    } else {
        scene = scene_draw(options->scene, width ? width : SCENE_SIDE, width ? height : SCENE_SIDE);
        what = "the scene (see --size)";
    }
    if (maps->albedo) {
        check_same_size(maps->albedo, scene, what);
        replace(&scene->albedo, image_rgb8(maps->albedo));
    }
    if (maps->gloss) {
        check_same_size(maps->gloss, scene, what);
        replace(&scene->gloss, image_grey8(maps->gloss));
    }
    if (maps->mask) {
        check_same_size(maps->mask, scene, what);
        replace(&scene->mask, image_grey8(maps->mask));
    }
    if (options->heights && !image_is_grey(maps->surface)) /* after what may fail: that is one line */
        warn("%s: this map is in colour; its brightness is the height", maps->surface->name);
    if (width && (width != scene->width || height != scene->height))
        scene_repeat(scene, width, height);
    return scene;
}

struct scene *scene_of_options(const struct scene_options *options)
{
    struct scene_maps *maps = scene_maps_read(options);
    struct scene *scene = scene_of_maps(maps, 0, 0);
    scene_maps_free(maps);
    return scene;
}
