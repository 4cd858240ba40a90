/* SPDX-License-Identifier: MIT
 * A function of the general family (3), plainly as the paper prints it: what the search's ways must agree with. */
#ifndef GLINT_UNIT_FAMILY_H
#define GLINT_UNIT_FAMILY_H

#include <math.h>

#include "models/formulas.h"

static inline double family_value(const struct family *family, double n, double c)
{
    const double *a = family->a, *b = family->b;
    const double d = a[2] * pow(n, b[2]) - a[3] * pow(n * c, b[3]) + a[4] * pow(c, b[4]);
    return a[0] * pow(c, b[0]) / (a[1] * pow(d, b[1]));
}

#endif
