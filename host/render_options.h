/* SPDX-License-Identifier: MIT
 * The options of `glint render`, checked and with their defaults. */
#ifndef GLINT_RENDER_OPTIONS_H
#define GLINT_RENDER_OPTIONS_H

#include "scene_options.h"
#include "shade.h"

struct render_options {
    struct scene_options scene;
    bool has_color; /* instead of an albedo */
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
