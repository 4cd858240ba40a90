/* SPDX-License-Identifier: MIT
 * Modified Schlick, (5). */
#include "models/models.h"

static double value(double n, double c)
{
    const double d = n - n * c + 1.25 * c;
    return 2 * c / (1.25 * d * d);
}

const struct model_facts model_msh = {
    .title = "MSH",
    .formula = "2c / (1.25 (n - nc + 1.25c)^2)",
    .meaning = "The paper's function (5): one division; its peak is 1.024",
    .value = value,
    .operations = {.multiply = 3, .add = 1, .divide = 1},
};
