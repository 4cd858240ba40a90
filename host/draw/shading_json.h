/* SPDX-License-Identifier: MIT
 * A material, a light and an output as JSON. */
#ifndef GLINT_DRAW_SHADING_JSON_H
#define GLINT_DRAW_SHADING_JSON_H

#include <stdio.h>

#include "draw/shading.h"

/* The fields of struct glint_material and struct glint_output, in their own numbers; of a shading_is_plain. */
void shading_print_json(const struct shading *shading, FILE *out);

#endif
