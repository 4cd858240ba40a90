/* SPDX-License-Identifier: MIT
 * What every command line has in common. */
#ifndef GLINT_BASE_ARGP_H
#define GLINT_BASE_ARGP_H

#include <argp.h>
#include <stdbool.h>
#include <stdio.h>

/* argp_parse with its flags. Usage errors are one line that begins with argv[0] and ends with where help is; exit 2. */
void parse_command(const struct argp *argp, unsigned flags, int argc, char **argv, void *input);

/* Where the command line is parsed: does it have an option of this parser or its children, but for the one of the name `but`? Then `name` is the
 * first one's. */
enum { OPTION_NAME_MAX = 40 };
bool option_given(const struct argp_state *state, const struct argp *of, const char *but, char name[OPTION_NAME_MAX]);

/* For an argp's help_filter: what `print` prints, as argp frees it; where there is no memory, `text`. */
char *help_text(const char *text, void (*print)(FILE *stream));

/* Given --_choices, for completion: what refuses an unknown name prints the names that there are instead, and no command
 * runs. (--_man prints the page for man, --_options the options; manual.h.) */
extern bool choices_wanted;

/* What --version prints; NULL: nothing. */
extern void (*version_print)(FILE *stream);

/* One line on standard error that ends with where help is, exit 2; where `state` is NULL, fail() (exit 1). */
_Noreturn void refuse(const struct argp_state *state, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
