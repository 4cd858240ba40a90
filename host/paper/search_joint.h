/* SPDX-License-Identifier: MIT
 * The joint search: all exponents with all coefficients, where the paper's two stages keep only a few sets between. The
 * grid may be spread over the ranks of an MPI run; the rows do not depend on how many ranks and threads there are. */
#ifndef GLINT_SEARCH_JOINT_H
#define GLINT_SEARCH_JOINT_H

#include "paper/ranks.h"
#include "paper/search.h"

/* Limits of the lists: their tables are held in memory. */
enum { JOINT_EXPONENTS_MAX = 200, JOINT_COEFFICIENTS_MAX = 20 };

/* Exponents -4..4 and coefficients 0.25..2.5 in quarter steps: 1.2 x 10^10 functions. */
struct search_options search_options_joint(void);
double search_joint_size(const struct search_options *options);

/* Fills result->rows; options->best of them, or fewer where fewer are finite. Functions that are equal for all n and c
 * because their coefficients only scale each other count once, by the first in the order of the lists. Where `checkpoint`
 * names a file that is there, goes on from it; writes it every few seconds and at the end. Every rank returns the same
 * rows. */
void search_joint(const struct search_options *options, const struct ranks *ranks, const char *checkpoint,
                  struct search_result *result);

#endif
