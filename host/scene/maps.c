/* SPDX-License-Identifier: MIT
 * Scenes from the files and names that the user gave. */
#include "scene/maps.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "base/message.h"
#include "image/image.h"
#include "image/picture.h"
#include "image/read.h"
#include "scene/bevel.h"
#include "scene/curl.h"
#include "scene/filter.h"
#include "scene/logo.h"
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

static struct image *read_surface(const struct scene_options *options)
{
    struct image *image = read_map(options, options->heights ? options->heights : options->normals);
    if (!image || !(options->fit > 0))
        return image;
    const unsigned times = times_of(options);
    struct image *fitted = logo_fitted(image, times * options->width, times * options->height, options->fit);
    image_free(image);
    return fitted;
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
                                read_surface(options),
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

/* ---- a picture in parts ---- */

struct scene_lines {
    const struct scene_maps *maps;
    uint32_t width, height;         /* of the picture */
    const struct image *drawn_from; /* whose alpha or brightness says what is drawn; NULL: all is, or `shape` */
    bool by_alpha;
    bool is_xy;           /* of a normal map */
    struct image *behind; /* of --background FILE; NULL: a colour, or black */
    struct scene *whole;  /* what is made at once; NULL: lines are made as they are asked for */
    struct curl curl;     /* of a normal map's lines so far */
};

static bool cuts_out(const struct scene_options *options)
{
    return options->cut_out || options->has_backdrop;
}

/* Edges of shapes are distances over all of a picture. A scene is made smaller as a whole. */
static bool is_made_at_once(const struct scene_options *options)
{
    return options->bevel > 0 || options->filter > 1;
}

static void replace(uint8_t **map, uint8_t *by)
{
    free(*map);
    *map = by;
}

/* A map's lines; NULL for NULL. */
static uint8_t *lines_of(const struct image *map, uint8_t *(*convert)(const struct image *map), uint32_t top,
                         uint32_t count)
{
    struct image *lines = image_lines(map, top, count);
    uint8_t *out = convert(lines);
    image_free(lines);
    return out;
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

/* What a mask draws, 8 bits a pixel: the mask's alpha where that leaves pixels out, else its brightness; without a mask the normal map's
 * alpha. Grey and alpha of a normal map are x and y. */
static void find_mask(struct scene_lines *lines)
{
    const struct scene_maps *maps = lines->maps;
    const struct image *from = maps->mask ? maps->mask : maps->options.normals ? maps->surface : NULL;
    if (!from || (!maps->mask && from->channels < 4))
        return;
    lines->by_alpha = image_cuts_out(from);
    lines->drawn_from = maps->mask || lines->by_alpha ? from : NULL;
}

/* NULL: everything, but for what is cut out. */
static uint8_t *drawn_of(const struct scene_lines *lines, uint32_t top, uint32_t count)
{
    if (!lines->drawn_from)
        return NULL;
    return lines_of(lines->drawn_from, lines->by_alpha ? image_alpha8 : image_grey8, top, count);
}

/* Of what is cut out a mask draws nothing. */
static void add_mask(struct scene *scene, uint8_t *drawn)
{
    for (size_t i = 0; scene->mask && i < (size_t)scene->width * scene->height; i++)
        drawn[i] = (uint8_t)((drawn[i] * scene->mask[i] + 127) / 255);
    replace(&scene->mask, drawn);
}

/* The size of the maps, or that at which a built-in scene is drawn. */
static void source_size(const struct scene_lines *lines, uint32_t *width, uint32_t *height)
{
    const struct scene_maps *maps = lines->maps;
    const unsigned times = times_of(&maps->options);
    *width = maps->surface ? maps->surface->width : times * lines->width;
    *height = maps->surface ? maps->surface->height : times * lines->height;
}

/* Lines of the surface with its maps, as wide as these, before a scene is made smaller or repeated. */
static struct scene *surface_lines(struct scene_lines *lines, uint32_t top, uint32_t count)
{
    const struct scene_maps *maps = lines->maps;
    const struct scene_options *options = &maps->options;
    const unsigned times = times_of(options);
    uint8_t *drawn = drawn_of(lines, top, count);
    struct scene *scene;
    uint32_t width, height;
    source_size(lines, &width, &height);
    const bool repeats = options->wraps || times * lines->width > width || times * lines->height > height;
    if (options->heights && options->bevel > 0) {
        double *heights = bevel_heights(maps->surface, options->bevel);
        scene = scene_from_relief(heights, width, height, options->scale, repeats);
        scene->mask = cuts_out(options) ? shape_of(maps->surface) : NULL;
        free(heights);
    } else if (options->heights) {
        scene = scene_from_heights_lines(maps->surface, options->scale, repeats, top, count);
    } else if (options->normals) {
        scene = scene_from_normals_lines(maps->surface, lines->is_xy, options->flip_y, drawn, top, count);
        if (top < height)
            curl_add(&lines->curl, scene, drawn);
    } else {
        scene = scene_draw_lines(options->scene, width, height, options->has_body ? options->body : NULL,
                                 cuts_out(options), top, count);
    }
    if (maps->albedo)
        replace(&scene->albedo, lines_of(maps->albedo, image_rgb8, top, count));
    if (maps->gloss)
        replace(&scene->gloss, lines_of(maps->gloss, image_grey8, top, count));
    if (drawn)
        add_mask(scene, drawn);
    if (maps->grain)
        replace(&scene->grain_map, lines_of(maps->grain, image_grey8, top, count));
    return scene;
}

/* Maps that are used as they are, but are probably not what the user meant. */
static void say_what_looks_wrong(const struct scene_lines *lines)
{
    const struct scene_options *options = &lines->maps->options;
    const struct image *map = lines->maps->surface;
    if (options->heights && options->bevel <= 0 && image_is_constant(map))
        warn(
            "%s: has no heights: its brightness is the same everywhere, so the surface is flat; --bevel WIDTH makes an "
            "edge from the shape of a logo",
            map->name);
    else if (options->heights && options->bevel <= 0 && !image_is_grey(map))
        warn("%s: this map is in colour; its brightness is the height", map->name);
    if (options->normals && curl_is_flipped(&lines->curl))
        warn("%s: green seems to point %s: the normals fit a surface better %s --flip-y", map->name,
             options->flip_y ? "up" : "down", options->flip_y ? "without" : "with");
}

static struct grain grain_of(const struct scene_options *options, uint32_t width, uint32_t height)
{
    struct grain grain = options->grain;
    if (isnan(grain.at[0])) {
        grain.at[0] = width / 2.;
        grain.at[1] = height / 2.;
    }
    return grain;
}

static struct image *read_behind(const struct scene_options *options, uint32_t width, uint32_t height)
{
    if (!options->has_backdrop || !options->backdrop)
        return NULL;
    struct image *image = image_read_sized(options->backdrop, width, height);
    if (image->width != width || image->height != height)
        fail("%s: %ux%u pixels, but the picture has %ux%u; a background must have the picture's size", image->name,
             image->width, image->height, width, height);
    return image;
}

static uint8_t *backdrop_of(const struct scene_options *options, const struct image *behind, uint32_t width,
                            uint32_t top, uint32_t count)
{
    if (!options->has_backdrop)
        return NULL;
    if (behind)
        return lines_of(behind, image_rgb8, top, count);
    uint8_t *rgb = allocate((size_t)width * count, 3);
    for (size_t i = 0; i < (size_t)width * count; i++)
        memcpy(&rgb[3 * i], options->backdrop_color, 3);
    return rgb;
}

uint8_t *scene_backdrop(const struct scene_options *options, uint32_t width, uint32_t height)
{
    struct image *behind = read_behind(options, width, height);
    uint8_t *rgb = backdrop_of(options, behind, width, 0, height);
    image_free(behind);
    return rgb;
}

static void check_sizes(const struct scene_lines *lines)
{
    const struct scene_maps *maps = lines->maps;
    const struct image *const others[] = {maps->albedo, maps->gloss, lines->drawn_from, maps->grain};
    const char *what = maps->options.heights   ? "the height map"
                       : maps->options.normals ? "the normal map"
                                               : "the scene (see --size)";
    uint32_t width, height;
    source_size(lines, &width, &height);
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (others[i] && (others[i]->width != width || others[i]->height != height))
            fail("%s: %ux%u pixels, but %s has %ux%u; both must have the same size", others[i]->name, others[i]->width,
                 others[i]->height, what, width, height);
    const unsigned times = times_of(&maps->options);
    if (width < times || height < times)
        fail("--filter %u: the surface has %ux%u pixels, fewer than become one", times, width, height);
}

/* What lines of the surface become in the picture. */
static struct scene *finished(const struct scene_lines *lines, struct scene *scene, uint32_t height)
{
    const struct scene_options *options = &lines->maps->options;
    if (lines->width != scene->width || height != scene->height)
        scene_repeat(scene, lines->width, height);
    if (options->has_grain)
        scene->grain = grain_of(options, lines->width, lines->height);
    return scene;
}

struct scene_lines *scene_lines_new(const struct scene_maps *maps, uint32_t width, uint32_t height)
{
    const struct scene_options *options = &maps->options;
    struct scene_lines *lines = allocate(1, sizeof *lines);
    uint32_t map_width, map_height;
    scene_maps_size(maps, &map_width, &map_height);
    lines->maps = maps;
    lines->width = width ? width : options->width ? options->width : map_width ? map_width : SCENE_SIDE;
    lines->height = width ? height : options->width ? options->height : map_height ? map_height : SCENE_SIDE;
    if (options->normals)
        lines->is_xy = normal_map_is_xy(maps->surface);
    find_mask(lines);
    check_sizes(lines);
    if (is_made_at_once(options)) {
        uint32_t whole_width, whole_height;
        source_size(lines, &whole_width, &whole_height);
        if (!maps->surface && !picture_size_fits(whole_width, whole_height))
            fail("--filter %u: the scene is drawn with more than %d pixels; choose a smaller --filter or --size",
                 options->filter, PIXELS_MAX);
        struct scene *scene = surface_lines(lines, 0, whole_height);
        if (options->filter > 1)
            scene_shrink(scene, options->filter);
        lines->whole = finished(lines, scene, lines->height);
    }
    lines->behind = read_behind(options, lines->width, lines->height);
    return lines;
}

void scene_lines_size(const struct scene_lines *lines, uint32_t *width, uint32_t *height)
{
    *width = lines->width;
    *height = lines->height;
}

struct scene *scene_lines_make(struct scene_lines *lines, uint32_t top, uint32_t count)
{
    struct scene *scene =
        lines->whole ? scene_part(lines->whole, top, count) : finished(lines, surface_lines(lines, top, count), count);
    scene->top = top;
    scene->backdrop = backdrop_of(&lines->maps->options, lines->behind, lines->width, top, count);
    return scene;
}

/* After everything that may fail, since a failure is one line. */
void scene_lines_end(struct scene_lines *lines)
{
    const struct scene_options *options = &lines->maps->options;
    const bool leaves_out = lines->drawn_from || (options->bevel > 0 && cuts_out(options) && options->heights) ||
                            (lines->maps->options.scene && cuts_out(options));
    if (lines->by_alpha)
        warn("%s: its alpha is the mask: transparent pixels are not drawn", lines->drawn_from->name);
    say_what_looks_wrong(lines);
    if (options->has_backdrop && !leaves_out)
        warn("--background: every pixel of the surface is drawn, so none is seen behind it; leave some out by --mask");
    scene_free(lines->whole);
    image_free(lines->behind);
    free(lines);
}

struct scene *scene_of_maps(const struct scene_maps *maps, uint32_t width, uint32_t height)
{
    struct scene_lines *lines = scene_lines_new(maps, width, height);
    struct scene *scene = scene_lines_make(lines, 0, lines->height);
    scene_lines_end(lines);
    return scene;
}

struct scene *scene_of_options(const struct scene_options *options)
{
    struct scene_maps *maps = scene_maps_read(options);
    struct scene *scene = scene_of_maps(maps, 0, 0);
    scene_maps_free(maps);
    return scene;
}
