/* SPDX-License-Identifier: MIT
 * The options that say where a mesh stands. */
#ifndef GLINT_VIEW_OPTIONS_H
#define GLINT_VIEW_OPTIONS_H

#include <argp.h>
#include <stdbool.h>

#include "draw/view.h"

struct view_options {
    struct view view; /* but for its size */
    bool given;       /* any of them */
    bool turned;      /* --turn */
};

/* A child for a command's argp: sets the defaults and parses. Its input is a struct view_options. */
extern const struct argp view_options_argp;
/* Checks that there is a mesh where they are given. */
void view_options_check(const struct argp_state *state, const struct view_options *options, bool has_mesh);

/* The view of this size; ends the program through fail() where the library cannot draw so. built_in: the teapot, which has a turn of its
 * own. */
struct view view_of_options(const struct view_options *options, uint32_t width, uint32_t height, bool built_in);

#endif
