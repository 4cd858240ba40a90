/* SPDX-License-Identifier: MIT
 * Inside the search: the grid, and the deviation of one function on it. */
#ifndef GLINT_SEARCH_GRID_H
#define GLINT_SEARCH_GRID_H

#include "paper/search.h"

/* All powers a search meets. */
struct grid {
    size_t angles, shininess;
    struct search_list exponents;
    const double *shininess_values;
    double *reference;       /* c^n   [angle][n] */
    double *cosine_power;    /* c^b   [b][angle] */
    double *shininess_power; /* n^b   [b][n] */
};

void grid_init(struct grid *grid, const struct search_options *options, struct search_list exponents);
void grid_free(struct grid *grid);

/* The exponents by their place in the list, and the two parameters that (4) has: coefficients that give the same
 * function give the same parameters, bit for bit where they are multiples of 1/4 and b2 is whole. */
struct candidate {
    size_t b1, b2, b3, b5;
    double scale; /* a1 / (a2 a3^b2) */
    double ratio; /* a5 / a3 */
};

/* The sum over the grid, from the angles at the peak outwards, where functions differ most; infinite as soon as it is
 * above the limit or no number. A partial sum never falls, so what is given up could not have come below the limit. */
double candidate_sum(const struct grid *grid, const struct candidate *candidate, double limit);

/* The function at one angle and some places of the list of n, and its denominator before the power b2. */
void candidate_places(const struct grid *grid, const struct candidate *candidate, size_t angle, const size_t *places,
                      size_t count, double *values, double *denominators);

#endif
