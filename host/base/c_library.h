/* SPDX-License-Identifier: MIT
 * The C library's names. */
#ifndef GLINT_BASE_C_LIBRARY_H
#define GLINT_BASE_C_LIBRARY_H

#include <stdbool.h>

/* Is it a function or object of the C library, which a program or its compiler may know? */
bool is_c_library_name(const char *text);

#endif
