/* SPDX-License-Identifier: MIT
 * --light, --point and --spot of the commands that draw. All refuse wrong values. */
#ifndef GLINT_LIGHT_OPTIONS_H
#define GLINT_LIGHT_OPTIONS_H

#include <argp.h>

#include "draw/shading.h"

void check_direction(const struct argp_state *state, const char *option, const double direction[3]);
void parse_light(const struct argp_state *state, const char *text, struct shading *shading);
void parse_point(const struct argp_state *state, const char *text, struct shading *shading);
void parse_spot(const struct argp_state *state, const char *text, struct shading *shading);
/* After all options: adds the default light if there is none, and checks what depends on --view. */
void check_lamps(const struct argp_state *state, struct shading *shading);

#endif
