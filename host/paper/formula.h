/* SPDX-License-Identifier: MIT
 * Texts of the report, which are plain ASCII in claims.json, as HTML with their mathematics set. */
#ifndef GLINT_PAPER_FORMULA_H
#define GLINT_PAPER_FORMULA_H

#include <stdio.h>

/* F_MSH and n_across have their index below, c^n and 2^(1-q) their exponent above, a1..a5 and b1..b5 their number below; n, q, c, m, k, t and F are in
 * italics, <=, >=, sqrt(, pi and a minus between blanks are signs; what stands between backquotes is code. */
void formula_put(FILE *stream, const char *text);
/* The same text where no markup may be: in an attribute or a title. */
void formula_put_plain(FILE *stream, const char *text);

#endif
