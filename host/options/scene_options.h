/* SPDX-License-Identifier: MIT
 * The options that name a scene. */
#ifndef GLINT_SCENE_OPTIONS_H
#define GLINT_SCENE_OPTIONS_H

#include <argp.h>

#include "scene/maps.h"

/* A child for a command's argp: sets the defaults, parses and checks. Its input is a struct scene_options, with
 * `optional` set. */
extern const struct argp scene_options_argp;
/* A built-in scene or mesh; else refuses it. `option`: as it is named in messages, or NULL. */
void scene_options_choose(const struct argp_state *state, const char *option, const char *text,
                          struct scene_options *options);
/* How many of the maps and the mesh come from standard input. */
unsigned scene_options_standard_input(const struct scene_options *options);

#endif
