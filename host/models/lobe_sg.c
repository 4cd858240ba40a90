/* SPDX-License-Identifier: MIT
 * The spherical Gaussian. */
#include <math.h>

#include "models/models.h"

static double value(double n, double c)
{
    return exp(-n * (1 - c));
}

const struct model_facts model_sg = {
    .title = "SG",
    .long_title = "Spherical Gaussian, SG",
    .formula = "exp(-n (1 - c))",
    .meaning = "exp(-n (1 - c)): the spherical Gaussian, next to Blinn",
    .value = value,
    .operations = {.multiply = 1, .add = 1, .more = "exp"},
};
