/* SPDX-License-Identifier: MIT
 * The options of the commands that draw pictures: those of shading_options.h, maps, a
 * mesh and the path through the library. */
#ifndef GLINT_DRAWING_OPTIONS_H
#define GLINT_DRAWING_OPTIONS_H

#include <argp.h>

/* A child of a command's argp; its input is a struct shading_options. */
extern const struct argp drawing_options_argp;

#endif
