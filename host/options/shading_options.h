/* SPDX-License-Identifier: MIT
 * What is lit and how, as the commands that draw take it: surface, maps, lights, material, pixels. */
#ifndef GLINT_SHADING_OPTIONS_H
#define GLINT_SHADING_OPTIONS_H

#include <argp.h>

#include "options/scene_options.h"
#include "draw/shading.h"

struct shading_options {
    struct scene_options scene;
    bool has_color;         /* instead of an albedo */
    bool has_light;         /* of any kind; else the usual one */
    bool has_format;        /* else RGB888, or what a device wants */
    struct shading shading; /* with gaps, which shading_of_options fills */
};

/* A child for a command's own; its input is a struct shading_options, which it fills. Wrong values are refused. */
extern const struct argp shading_options_argp;
/* What can be checked only when the format is known. */
void shading_options_check(const struct argp_state *state, const struct shading *shading);

/* The scene of maps read before; width = 0: at its own size. */
struct scene *scene_of_shading_options(const struct shading_options *options, const struct scene_maps *maps,
                                       uint32_t width, uint32_t height);
/* Completed by what suits the format and the scene. */
struct shading shading_of_options(const struct shading_options *options, enum glint_format format,
                                  const struct scene *scene);

/* ---- the lights (light_options.c); all refuse what is wrong ---- */

void check_direction(const struct argp_state *state, const char *option, const char *text, const double direction[3]);
void parse_light(const struct argp_state *state, const char *text, struct shading *shading);
void parse_point(const struct argp_state *state, const char *text, struct shading *shading);
void parse_spot(const struct argp_state *state, const char *text, struct shading *shading);
/* When all options are there: the default light, where none is given; what depends on --view. */
void check_lamps(const struct argp_state *state, struct shading *shading);

#endif
