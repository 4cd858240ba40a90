/* SPDX-License-Identifier: MIT
 * The coefficients as the functions see them: the ratios a5 / a3, and for each the scales a1 / (a2 a3^b2). */
#ifndef GLINT_SEARCH_SCALES_H
#define GLINT_SEARCH_SCALES_H

#include <stdint.h>

#include "paper/search.h"

struct scale_list {
    double ratio;
    size_t count;
    struct scale {
        double scale;
        uint64_t coefficients; /* which of all ways to pick a1 a2 a3 a5 gives it, the first of several */
    } * scales;                /* rising, each once */
};

struct scales {
    size_t ratios, exponents;
    struct scale_list *lists; /* [exponent][ratio] */
};

void scales_init(struct scales *scales, const struct search_options *options);
const struct scale_list *scales_of(const struct scales *scales, size_t b2); /* b2 by its place in the list */
void scales_free(struct scales *scales);

#endif
