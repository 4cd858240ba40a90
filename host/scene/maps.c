/* SPDX-License-Identifier: MIT
 * Scenes from the files and names that the user gave. */
#include "scene/maps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "image/image.h"
#include "image/read.h"
#include "scene/bevel.h"
#include "scene/curl.h"
#include "scene/filter.h"
#include "scene/normals.h"
#include "scene/scenes.h"

static unsigned times_of(const struct scene_options *options)
{
    return options->filter ? options->filter : 1;
}

/* An SVG is drawn at the size that is asked for. */
static struct image *read_map(const struct scene_options *options, const char *path)
{
    const unsigned times = times_of(options);
    return path ? image_read_sized(path, times * options->width, times * options->height) : NULL;
}

/* A map that goes with the scene, pixel for pixel. */
static void check_same_size(const struct image *map, const struct scene *scene, const char *what)
{
    if (map->width != scene->width || map->height != scene->height)
        fail("%s: %ux%u pixels, but %s has %ux%u; both must have the same size", map->name, map->width, map->height,
             what, scene->width, scene->height);
}

/* The picture that holds the surface, and its other maps; NULL where there is none. */
struct scene_maps {
    struct scene_options options;
    struct image *surface, *albedo, *gloss, *mask, *grain;
};

struct scene_maps *scene_maps_read(const struct scene_options *options)
{
    struct scene_maps *maps = allocate(1, sizeof *maps);
    *maps = (struct scene_maps){*options,
                                read_map(options, options->heights ? options->heights : options->normals),
                                read_map(options, options->albedo),
                                read_map(options, options->gloss),
                                read_map(options, options->mask),
                                read_map(options, options->grain_map)};
    return maps;
}

void scene_maps_free(struct scene_maps *maps)
{
    image_free(maps->surface);
    image_free(maps->albedo);
    image_free(maps->gloss);
    image_free(maps->mask);
    image_free(maps->grain);
    free(maps);
}

void scene_maps_size(const struct scene_maps *maps, uint32_t *width, uint32_t *height)
{
    *width = *height = 0;
    if (maps->surface) {
        *width = maps->surface->width / times_of(&maps->options);
        *height = maps->surface->height / times_of(&maps->options);
    }
}

static struct scene *scene_of_heights(const struct scene_maps *maps, uint32_t width, uint32_t height)
{
    const struct image *map = maps->surface;
    const struct scene_options *options = &maps->options;
    const unsigned times = times_of(options);
    const bool wraps =
        options->wraps || times * width > map->width || times * height > map->height; /* which repeats it */
    if (options->bevel <= 0)
        return scene_from_heights(map, options->scale, wraps);
    double *heights = bevel_heights(map, options->bevel);
    struct scene *scene = scene_from_relief(heights, map->width, map->height, options->scale, wraps);
    free(heights);
    return scene;
}

static bool cuts_out(const struct scene_options *options)
{
    return options->cut_out || options->has_backdrop;
}

static uint8_t *shape_of(const struct image *logo)
{
    const size_t pixels = (size_t)logo->width * logo->height;
    double *coverage = bevel_coverage(logo);
    uint8_t *drawn = allocate(pixels, 1);
    for (size_t i = 0; i < pixels; i++)
        drawn[i] = (uint8_t)lround(255 * coverage[i]);
    free(coverage);
    return drawn;
}

/* What is drawn, 8 bits a pixel of *from: the mask's alpha where that leaves pixels out, else its brightness; without a
 * mask the normal map's alpha, or a logo's shape. NULL: everything. */
static uint8_t *drawn_of(const struct scene_maps *maps, const struct image **from, bool *by_alpha)
{
    *from = maps->mask ? maps->mask : maps->surface;
    if (!maps->mask && maps->options.heights)
        return cuts_out(&maps->options) && maps->options.bevel > 0 ? shape_of(maps->surface) : NULL;
    if (!*from || (!maps->mask && (*from)->channels < 4)) /* grey and alpha of a normal map are x and y */
        return NULL;
    uint8_t *drawn = image_cut_out(*from);
    *by_alpha = drawn != NULL;
    return drawn || !maps->mask ? drawn : image_grey8(maps->mask);
}

static void replace(uint8_t **map, uint8_t *by)
{
    free(*map);
    *map = by;
}

static bool is_constant(const struct image *map)
{
    const size_t pixels = (size_t)map->width * map->height;
    double *grey = image_grey(map);
    size_t same = 1;
    while (same < pixels && grey[same] == grey[0])
        same++;
    free(grey);
    return same == pixels;
}

/* Maps that are used as they are, but are probably not what the user meant. */
static void say_what_looks_wrong(const struct scene_options *options, const struct image *map,
                                 const struct scene *scene)
{
    if (options->heights && options->bevel <= 0 && is_constant(map))
        warn(
            "%s: has no heights: its brightness is the same everywhere, so the surface is flat; --bevel WIDTH makes an "
            "edge from the shape of a logo",
            map->name);
    else if (options->heights && options->bevel <= 0 && !image_is_grey(map))
        warn("%s: this map is in colour; its brightness is the height", map->name);
    if (options->normals && curl_says_flipped(scene, scene->mask))
        warn("%s: green seems to point %s: the normals fit a surface better %s --flip-y", map->name,
             options->flip_y ? "up" : "down", options->flip_y ? "without" : "with");
}

static struct grain grain_of(const struct scene_options *options, const struct scene *scene)
{
    struct grain grain = options->grain;
    if (isnan(grain.at[0])) {
        grain.at[0] = scene->width / 2.;
        grain.at[1] = scene->height / 2.;
    }
    return grain;
}

uint8_t *scene_backdrop(const struct scene_options *options, uint32_t width, uint32_t height)
{
    if (!options->has_backdrop)
        return NULL;
    if (options->backdrop) {
        struct image *image = image_read_sized(options->backdrop, width, height);
        if (image->width != width || image->height != height)
            fail("%s: %ux%u pixels, but the picture has %ux%u; a background must have the picture's size", image->name,
                 image->width, image->height, width, height);
        uint8_t *rgb = image_rgb8(image);
        image_free(image);
        return rgb;
    }
    uint8_t *rgb = allocate((size_t)width * height, 3);
    for (size_t i = 0; i < (size_t)width * height; i++)
        memcpy(&rgb[3 * i], options->backdrop_color, 3);
    return rgb;
}

struct scene *scene_of_maps(const struct scene_maps *maps, uint32_t width, uint32_t height)
{
    const struct scene_options *options = &maps->options;
    const unsigned times = times_of(options);
    if (!width) {
        width = options->width;
        height = options->height;
    }
    const struct image *surface = maps->surface, *drawn_from;
    bool by_alpha = false;
    uint8_t *drawn = drawn_of(maps, &drawn_from, &by_alpha);
    struct scene *scene;
    const char *what;
    if (options->heights) {
        scene = scene_of_heights(maps, width, height);
        what = "the height map";
    } else if (options->normals) {
        const bool fits = drawn && drawn_from->width == surface->width && drawn_from->height == surface->height;
        scene = scene_from_normals(surface, options->flip_y, fits ? drawn : NULL);
        what = "the normal map";
    } else {
        scene =
            scene_draw_in(options->scene, times * (width ? width : SCENE_SIDE), times * (width ? height : SCENE_SIDE),
                          options->has_body ? options->body : NULL, cuts_out(options));
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
    if (drawn) {
        check_same_size(drawn_from, scene, what);
        replace(&scene->mask, drawn);
    }
    if (maps->grain) {
        check_same_size(maps->grain, scene, what);
        replace(&scene->grain_map, image_grey8(maps->grain));
    }
    if (by_alpha)
        warn("%s: its alpha is the mask: transparent pixels are not drawn", drawn_from->name);
    say_what_looks_wrong(options, surface, scene); /* after everything that may fail, since a failure is one line */
    if (scene->width < times || scene->height < times)
        fail("--filter %u: the surface has %ux%u pixels, fewer than become one", times, scene->width, scene->height);
    if (times > 1)
        scene_shrink(scene, times);
    if (width && (width != scene->width || height != scene->height))
        scene_repeat(scene, width, height);
    if (options->has_grain)
        scene->grain = grain_of(options, scene);
    scene->backdrop = scene_backdrop(options, scene->width, scene->height);
    if (scene->backdrop && !scene->mask)
        warn("--background: every pixel of the surface is drawn, so none is seen behind it; leave some out by --mask");
    return scene;
}

struct scene *scene_of_options(const struct scene_options *options)
{
    struct scene_maps *maps = scene_maps_read(options);
    struct scene *scene = scene_of_maps(maps, 0, 0);
    scene_maps_free(maps);
    return scene;
}
