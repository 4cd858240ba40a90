/* SPDX-License-Identifier: MIT
 * What all written C source has in common. */
#ifndef GLINT_BAKE_C_SOURCE_H
#define GLINT_BAKE_C_SOURCE_H

#include <stdio.h>

/* NAME in capitals, for macros; at most 63 letters, as parse_c_name sees to. */
struct c_capitals {
    char text[64];
};
struct c_capitals c_capitals(const char *name);

/* A header with its guard, which includes `header` ("<stdint.h>"), and in it declarations for C and C++. */
void c_begin_header(const char *name, const char *header, FILE *out);
void c_end_header(FILE *out);
void c_begin_externs(FILE *out);
void c_end_externs(FILE *out);

/* "const TYPE NAMESUFFIX[] = {", after `storage` ("static " or ""), aligned to words, so that a DMA or a copy by words may read
 * it. */
void c_begin_array(const char *storage, const char *type, const char *name, const char *suffix, FILE *out);

#endif
