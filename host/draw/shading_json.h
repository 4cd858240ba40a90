/* SPDX-License-Identifier: MIT
 * A shader as JSON. */
#ifndef GLINT_DRAW_SHADING_JSON_H
#define GLINT_DRAW_SHADING_JSON_H

#include <stdio.h>

#include "draw/shading.h"

/* The fields of struct glint_shader, in its own numbers. */
void shading_print_json(const struct shading *shading, FILE *out);

#endif
