/* SPDX-License-Identifier: MIT
 * Names for written C source. */
#ifndef GLINT_BASE_C_NAMES_H
#define GLINT_BASE_C_NAMES_H

#include <argp.h>

/* For --name: a name of at most 63 letters that C, C++ and glint.h leave to programs and that means nothing yet. */
const char *parse_c_name(const struct argp_state *state, const char *text);
/* Refuses a name whose capitals with `suffix` are a macro of <stdint.h>, as INT8_WIDTH is. */
void parse_c_macro(const struct argp_state *state, const char *name, const char *suffix);

#endif
