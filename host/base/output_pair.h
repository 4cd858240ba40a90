/* SPDX-License-Identifier: MIT
 * A source and its header, written together: files get their names when all is said, standard output comes first. */
#ifndef GLINT_BASE_OUTPUT_PAIR_H
#define GLINT_BASE_OUTPUT_PAIR_H

#include "base/output.h"

struct output_pair {
    struct output *source, *header; /* NULL: none */
};
struct output_pair output_pair_open(const char *source, const char *header); /* paths, or NULL */
/* Closes the source where it is standard output: an error there is the last word. */
void output_pair_end_standard(struct output_pair *pair);
void output_pair_close(struct output_pair *pair);

#endif
