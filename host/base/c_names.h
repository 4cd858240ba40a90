/* SPDX-License-Identifier: MIT
 * Names for written C source. */
#ifndef GLINT_BASE_C_NAMES_H
#define GLINT_BASE_C_NAMES_H

#include <argp.h>

/* For --name: a name of at most 63 letters that C, C++, the C library and glint.h leave to programs and that means nothing yet. */
const char *parse_c_name(const struct argp_state *state, const char *text);
/* Refuses a name whose capitals with `suffix` are a macro of <stdint.h>, as INT8_WIDTH is. */
void parse_c_macro(const struct argp_state *state, const char *name, const char *suffix);

/* FILE.c is written with FILE.h beside it. */
struct c_files {
    char *header;       /* NULL: the source is one file, of any other name */
    const char *within; /* the header without its folder, as the source includes it */
    char *stem;
};
/* For `path`; where *name is NULL it becomes FILE, checked as parse_c_name and parse_c_macro do. */
void parse_c_files(const struct argp_state *state, const char *path, const char **name, const char *suffix,
                   struct c_files *files);
void c_files_free(struct c_files *files);

#endif
