/* SPDX-License-Identifier: MIT
 * Lyon with gamma 4. */
#include <math.h>

#include "models/models.h"

static double value(double n, double c)
{
    const double base = fmax(0, 1 - n * (1 - c) / 4);
    return base * base * (base * base);
}

const struct model_facts model_lyon = {
    .title = "Lyon",
    .long_title = "Lyon 1993, gamma 4",
    .formula = "max(0, 1 - n(1-c)/4)^4",
    .meaning = "(1 - n(1 - c)/4)^4: Lyon 1993, the fewest cycles",
    .source =
        "R. F. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification, Apple Technical Report 43, 1993",
    .value = value,
    .operations = {.multiply = 3, .add = 1, .more = "max"},
};
