/* SPDX-License-Identifier: MIT
 * The options of a parser and of its children, in the order of --help. */
#ifndef GLINT_BASE_ARGP_OPTIONS_H
#define GLINT_BASE_ARGP_OPTIONS_H

#include <argp.h>
#include <stdbool.h>
#include <stddef.h>

enum { OPTIONS_MAX = 160 };
struct option_list {
    const struct argp_option *options[OPTIONS_MAX];
    int groups[OPTIONS_MAX];
    unsigned count;
};
/* Group by group: 0, 1, 2... and then negative ones; in each its heading first, and then as the tables have them. */
void options_collect(const struct argp *argp, struct option_list *list);
bool option_is_heading(const struct argp_option *option); /* of a group; it has only a text */

/* How long the first sentence of a text is, without its full stop. */
size_t options_sentence(const char *text, size_t length);

#endif
