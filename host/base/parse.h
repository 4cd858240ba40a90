/* SPDX-License-Identifier: MIT
 * Values from the command line and from files. The whole text counts; an error names the option and what is allowed and
 * ends the program through refuse(). `option` as the user writes it: "-n", "--light". Where `state` is NULL the text is
 * data, not usage: `option` names where it stands, and the exit status is 1. */
#ifndef GLINT_BASE_PARSE_H
#define GLINT_BASE_PARSE_H

#include <argp.h>
#include <stdbool.h>
#include <stddef.h>

long parse_integer(const struct argp_state *state, const char *option, const char *text, long low, long high);
double parse_real(const struct argp_state *state, const char *option, const char *text, double low, double high);
/* "X,Y,Z": exactly `count` numbers. */
void parse_reals(const struct argp_state *state, const char *option, const char *text, double *values, int count,
                 double low, double high);
/* "A", "A,B,C", "A:B" (step 1), "A:B:STEP" or a mix of them by commas; `values` is malloc'd, the count returned. */
size_t parse_list(const struct argp_state *state, const char *option, const char *text, double low, double high,
                  double **values);
size_t parse_integer_list(const struct argp_state *state, const char *option, const char *text, long low, long high,
                          long **values);

/* The place of `text` in a list that ends with NULL; else refuse_unknown(). `what` the names are: "format". */
unsigned parse_choice(const struct argp_state *state, const char *option, const char *what, const char *text,
                      const char *const *names);

/* The name of a file to write, which may not be empty. */
const char *parse_output(const struct argp_state *state, const char *option, const char *text);

/* A decimal number at the beginning of the text, finite. */
bool read_real(const char *text, char **end, double *value);
/* The first line of a text file in UTF-8 may begin with such a mark. */
char *after_byte_order_mark(char *line);

#endif
