/* SPDX-License-Identifier: MIT
 * The options of maps and of their size, for commands that need a surface. */
#ifndef GLINT_MAP_OPTIONS_H
#define GLINT_MAP_OPTIONS_H

#include <argp.h>

#include "scene/maps.h"

/* A child of a command's argp behind scene_options_argp, which sets the defaults; its input is the same struct
 * scene_options. It refuses a command without a surface. */
extern const struct argp map_options_argp;
/* Set by a command that draws in parts: --size takes up to SIDE_MAX x SIDE_MAX pixels. */
extern bool map_options_in_parts;
/* How many of the maps and the mesh come from standard input. */
unsigned map_options_standard_input(const struct scene_options *options);

#endif
