/* SPDX-License-Identifier: MIT
 * The options of `glint render`, checked and with their defaults. */
#ifndef GLINT_RENDER_OPTIONS_H
#define GLINT_RENDER_OPTIONS_H

#include "shade.h"

struct render_options {
    /* one of three */
    const char *heights, *normals, *scene;
    double scale;
    bool wraps, flip_y;
    const char *albedo, *gloss, *mask;
    bool has_color;
    uint32_t width, height; /* 0: the map's own */
    /* n = 0 and NAN coefficients: what suits the scene */
    struct shading shading;
    const char *output; /* NULL: only compare */
    enum image_kind kind;
    bool compare, json, against_blinn;
    const char *error_map;
    enum image_kind error_map_kind;
};

/* Ends the program with one line and exit status 2 where they are wrong. */
void render_options_parse(struct render_options *options, int argc, char **argv);

#endif
