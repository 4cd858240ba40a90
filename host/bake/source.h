/* SPDX-License-Identifier: MIT
 * Baked normals as C and C++ source. */
#ifndef GLINT_BAKE_SOURCE_H
#define GLINT_BAKE_SOURCE_H

#include <stdio.h>

#include "bake/bake.h"

/* All in one file to include: a static array, and its sizes as enumerators. */
void bake_write_c(const struct baked *baked, const char *name, FILE *out);

/* A header and a source to link: NAME is defined once, for all who include the header. `strip`: how many lines the program
 * draws at once; 0: no macros for that. `header` is the header's file name. */
void bake_write_header(const struct baked *baked, const char *name, uint32_t strip, FILE *out);
void bake_write_definitions(const struct baked *baked, const char *name, const char *header, FILE *out);

#endif
