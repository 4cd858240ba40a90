/* SPDX-License-Identifier: MIT
 * The options that name a scene (a height map, a normal map or a built-in one), and the scene that they name. */
#ifndef GLINT_SCENE_OPTIONS_H
#define GLINT_SCENE_OPTIONS_H

#include <argp.h>

#include "scene/scene.h"

struct scene_options {
    /* one of three */
    const char *heights, *normals, *scene;
    double scale;
    bool wraps, flip_y;
    const char *mask;
    uint32_t width, height;     /* 0: the map's own */
    const char *albedo, *gloss; /* for commands that take them to set; NULL: the scene's own */
};

/* A child for a command's argp: sets the defaults, parses and checks. Its input is a struct scene_options. */
extern const struct argp scene_options_argp;

/* All below end the program through fail() where something is wrong. */
struct scene *scene_of_options(const struct scene_options *options);

/* The same in two steps, for a size that is known only when the maps are: width = 0 is the options'. */
struct scene_maps;
struct scene_maps *scene_maps_read(const struct scene_options *options);
void scene_maps_free(struct scene_maps *maps);
/* Of the surface's map; 0, 0 of a built-in scene, which takes any. */
void scene_maps_size(const struct scene_maps *maps, uint32_t *width, uint32_t *height);
struct scene *scene_of_maps(const struct scene_maps *maps, uint32_t width, uint32_t height);

#endif
