/* SPDX-License-Identifier: MIT
 * The options that name a scene (a height map, a normal map or a built-in one), and the scene that they name. */
#ifndef GLINT_SCENE_OPTIONS_H
#define GLINT_SCENE_OPTIONS_H

#include <argp.h>

#include "scene.h"

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

/* Every error ends the program through fail(). */
struct scene *scene_of_options(const struct scene_options *options);

#endif
