/* SPDX-License-Identifier: MIT
 * Gauss, (1). */
#include <math.h>

#include "models/models.h"

static double value(double n, double c)
{
    const double x = acos(c);
    return exp(-n * x * x / 2);
}

const struct model_facts model_gauss = {
    .title = "Gauss",
    .formula = "exp(-n x^2 / 2)",
    .meaning = "exp(-n x^2 / 2) of the angle x",
    .value = value,
    .operations = {.multiply = 2, .more = "acos, exp"},
};
