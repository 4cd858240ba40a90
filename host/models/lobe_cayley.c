/* SPDX-License-Identifier: MIT
 * Cayley, ours. */
#include <math.h>

#include "models/models.h"

static double value(double n, double c)
{
    if (n <= 4)
        return pow(c, n);
    const double r = fmax(0, 4 * (1 + c) - n * (1 - c)) / (4 * (1 + c) + n * (1 - c));
    return r * r * (r * r);
}

const struct model_facts model_cayley = {
    .title = "Cayley",
    .long_title = "Cayley (ours)",
    .formula = "(max(0, 4(1+c) - n(1-c)) / (4(1+c) + n(1-c)))^4; c^n for n <= 4",
    .meaning = "A fraction to the fourth power: closest to Blinn, and 0 beyond its foot",
    .value = value,
    .operations = {.multiply = 4, .add = 2, .divide = 1, .more = "max"},
};
