/* SPDX-License-Identifier: MIT
 * The options of a mesh's file, for commands that read one. */
#ifndef GLINT_MESH_OPTIONS_H
#define GLINT_MESH_OPTIONS_H

#include <argp.h>

/* A child of a command's argp behind scene_options_argp, which sets the defaults; its input is the same struct
 * scene_options. */
extern const struct argp mesh_options_argp;

#endif
