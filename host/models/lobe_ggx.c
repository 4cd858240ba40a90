/* SPDX-License-Identifier: MIT
 * GGX over its peak. */
#include "models/models.h"

static double value(double n, double c)
{
    const double e = 1 + n * (1 - c * c) / 2;
    return 1 / (e * e);
}

const struct model_facts model_ggx = {
    .title = "GGX",
    .formula = "1 / (1 + n (1 - c^2) / 2)^2",
    .meaning = "1 / (1 + n (1 - c^2) / 2)^2: the look of today's renderers, with a long tail",
    .source = "B. Walter et al., Microfacet Models for Refraction through Rough Surfaces, EGSR 2007; over its peak, "
              "alpha^2 = 2 / (n + 2)",
    .value = value,
    .operations = {.multiply = 3, .add = 2, .divide = 1},
};
