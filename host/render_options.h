/* SPDX-License-Identifier: MIT
 * The options of `glint render`, checked and with their defaults. */
#ifndef GLINT_RENDER_OPTIONS_H
#define GLINT_RENDER_OPTIONS_H

#include <argp.h>

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

/* ---- the lights (light_options.c); all refuse what is wrong ---- */

void check_direction(const struct argp_state *state, const char *option, const char *text, const double direction[3]);
void parse_light(const struct argp_state *state, const char *text, struct shading *shading);
void parse_point(const struct argp_state *state, const char *text, struct shading *shading);
void parse_spot(const struct argp_state *state, const char *text, struct shading *shading);
/* When all options are there: the default light, where none is given; what depends on --view. */
void check_lamps(const struct argp_state *state, struct shading *shading);

#endif
