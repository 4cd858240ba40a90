/* SPDX-License-Identifier: MIT
 * The options of `glint render`, checked and with their defaults. */
#ifndef GLINT_RENDER_OPTIONS_H
#define GLINT_RENDER_OPTIONS_H

#include <argp.h>

#include "image/levels.h"
#include "image/write.h"
#include "options/shading_options.h"

struct render_options {
    struct shading_options look;
    const char *output; /* NULL: only compare */
    enum image_kind kind;
    enum widen widen;
    bool raw;     /* no image file: the pixels as they are in memory */
    bool gouraud; /* not by the library */
    bool compare, json, against_blinn;
    const char *error_map;
    enum image_kind error_map_kind;
};

/* Ends the program with one line and exit status 2 where they are wrong. */
void render_options_parse(struct render_options *options, int argc, char **argv);

#endif
