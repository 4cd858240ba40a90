/* SPDX-License-Identifier: MIT
 * The highlight functions in double precision, as printed in the paper (equation numbers are its). */
#include <math.h>
#include <string.h>

#include "base/argp.h"
#include "models/models.h"

const char *const model_names[MODEL_COUNT] = {"msh", "schlick", "blinn", "phong", "gauss", "cayley"};

double model_double(enum glint_model model, double n, double c)
{
    switch (model) {
    case GLINT_MSH: { /* (5) */
        const double d = n - n * c + 1.25 * c;
        return 2 * c / (1.25 * d * d);
    }
    case GLINT_SCHLICK: /* (2) */
        return c / (n - n * c + c);
    case GLINT_BLINN: /* (1) */
    case GLINT_PHONG:
        return pow(c, n);
    case GLINT_GAUSS: { /* (1) */
        const double x = acos(c);
        return exp(-n * x * x / 2);
    }
    case GLINT_CAYLEY: {
        if (n <= 4)
            return pow(c, n);
        const double r = fmax(0, 4 * (1 + c) - n * (1 - c)) / (4 * (1 + c) + n * (1 - c));
        return r * r * (r * r);
    }
    }
    return 0;
}

enum glint_model parse_model(const struct argp_state *state, const char *option, const char *text)
{
    for (int i = 0; i < MODEL_COUNT; i++)
        if (strcmp(text, model_names[i]) == 0)
            return (enum glint_model)i;
    refuse(state, "%s: no model '%s'; one of msh, schlick, blinn, phong, gauss, cayley", option, text);
}

void parse_models(const struct argp_state *state, const char *option, const char *text, bool given[MODEL_COUNT])
{
    const bool all = strcmp(text, "all") == 0;
    for (int i = 0; i < MODEL_COUNT; i++)
        given[i] = all;
    if (!all)
        given[parse_model(state, option, text)] = true;
}
