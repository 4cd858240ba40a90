/* SPDX-License-Identifier: MIT
 * Functions of the family (4) as the report shows them. */
#ifndef GLINT_PAPER_FAMILY_H
#define GLINT_PAPER_FAMILY_H

#include <jansson.h>
#include <stdio.h>

#include "models/formulas.h"

json_t *family_text(const double values[5]);                  /* exponents or coefficients, with blanks between */
void family_write(FILE *stream, const struct family *family); /* ten cells of a CSV row, each with its comma */

#endif
