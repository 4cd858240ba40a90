/* SPDX-License-Identifier: MIT
 * Names for written C source. */
#ifndef GLINT_BASE_C_NAMES_H
#define GLINT_BASE_C_NAMES_H

#include <argp.h>

/* For --name: a name of at most 63 letters that C, C++ and glint.h leave to programs and that means nothing yet. */
const char *parse_c_name(const struct argp_state *state, const char *text);

#endif
