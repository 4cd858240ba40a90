/* SPDX-License-Identifier: MIT
 * Blinn and Phong, (1): one power, of other cosines. */
#include <math.h>

#include "models/models.h"

static double value(double n, double c)
{
    return pow(c, n);
}

const struct model_facts model_blinn = {
    .title = "Blinn",
    .formula = "c^n",
    .meaning = "cos^n of the angle between N and H, exactly",
    .value = value,
};

const struct model_facts model_phong = {
    .title = "Phong",
    .formula = "c^n",
    .meaning = "cos^n of the angle between V and the reflected light: a smaller spot at the same n",
    .value = value,
};
