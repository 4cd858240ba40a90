/* SPDX-License-Identifier: MIT
 * The paper's search program (fig. 2): functions of the family (4), a1 c^b1 / (a2 (a3 n^b3 - a3 (n c)^b3 + a5
 * c^b5)^b2), compared with Blinn's c^n by the mean absolute deviation over a grid of angles and shininess. Stage 1
 * varies the exponents b1 b2 b3 b5 with all coefficients 1 and keeps the best sets; stage 2 varies the coefficients a1
 * a2 a3 a5 for each of these and keeps the best.
 *
 * A function that is not a finite number at some point of the grid (0 / 0, an overflow, a fractional power of a
 * negative number) has no deviation and is passed over. cos 90 degrees is 6.1e-17, as computed, and not 0: negative
 * powers of c therefore take their limits from below 90 degrees. Equal deviations rank by their place in the lists,
 * first first. */
#ifndef GLINT_SEARCH_H
#define GLINT_SEARCH_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "models/formulas.h"

struct search_list {
    const double *values;
    size_t count;
};

struct search_options {
    struct search_list exponents;    /* for b1 b2 b3 b5 */
    struct search_list coefficients; /* for a1 a2 a3 a5; positive */
    struct search_list shininess;    /* n of the grid; positive */
    size_t angles;                   /* of the grid, evenly from 0 to 90 degrees; at least 2 */
    size_t best;                     /* exponent sets kept after stage 1 */
    bool quiet;                      /* no warning where it takes long */
    bool exhaustive;                 /* every sum to its end; the same rows, many times slower */
};
struct search_options search_options_paper(void); /* what the paper searched */

struct search_row {
    struct family family;
    double deviation;
};

struct search_result {
    struct search_row *first;  /* after stage 1, a = 1; both sorted by deviation, smallest first */
    struct search_row *rows;   /* after stage 2 */
    size_t first_count, count; /* options.best, or fewer where fewer are finite */
};

/* Numbers of functions compared by each stage; a double, since a wide search overflows integers. */
double search_first_size(const struct search_options *options);
double search_second_size(const struct search_options *options);

/* Runs stage 1, or both, on all cores. On a terminal the progress is shown; where a stage is going to take over a
 * minute, a line says so. */
void search_run(const struct search_options *options, int stages, struct search_result *result);
void search_free(struct search_result *result);

/* The deviation of one function of the family (4); infinite where it is not finite on the grid. */
double search_deviation(const struct search_options *options, const struct family *family);

#endif
