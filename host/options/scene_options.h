/* SPDX-License-Identifier: MIT
 * The options that name a scene. */
#ifndef GLINT_SCENE_OPTIONS_H
#define GLINT_SCENE_OPTIONS_H

#include <argp.h>

#include "scene/maps.h"

/* A child for a command's argp: sets the defaults and parses. Its input is a struct scene_options. */
extern const struct argp scene_options_argp;
/* A built-in scene or mesh; else refuses it. `option`: as it is named in messages, or NULL. */
void scene_options_choose(const struct argp_state *state, const char *option, const char *text,
                          struct scene_options *options);
/* What is said of SCENE, for a command's argp. */
#define SCENE_ARGUMENT "[SCENE]"
/* A word without an option: a built-in scene or mesh, as --scene takes it; else refuses it. */
void scene_options_argument(const struct argp_state *state, const char *text, struct scene_options *options);

#endif
