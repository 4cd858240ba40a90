/* SPDX-License-Identifier: MIT
 * Manual pages and words for completion, from the tables of options that --help prints. */
#ifndef GLINT_BASE_MANUAL_H
#define GLINT_BASE_MANUAL_H

#include <argp.h>
#include <stdio.h>

/* A page for man, of the command `name` ("glint render"), whose argp is the first child of `root`. */
void manual_write(const struct argp *root, const char *name, FILE *out);
/* An option's name a line: "--mask=FILE" or "-n=N", a tab, and the first sentence of what it does. */
void manual_list_options(const struct argp *root, FILE *out);

#endif
