/* SPDX-License-Identifier: MIT
 * Schlick, (2). */
#include "models/models.h"

static double value(double n, double c)
{
    return c / (n - n * c + c);
}

const struct model_facts model_schlick = {
    .title = "Schlick",
    .formula = "c / (n - nc + c)",
    .meaning = "c / (n - nc + c): the cheapest fraction, with a wide skirt",
    .value = value,
    .operations = {.multiply = 1, .add = 1, .divide = 1},
};
