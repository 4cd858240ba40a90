/* SPDX-License-Identifier: MIT
 * The highlight functions in double precision, as printed in the paper (equation numbers are its): for each model that has
 * functions of its own in glint.h, one here that is named NAME_double. */
#include <math.h>

#include "base/parse.h"
#include "models/models.h"

static double msh_double(double n, double c) /* (5) */
{
    const double d = n - n * c + 1.25 * c;
    return 2 * c / (1.25 * d * d);
}

static double schlick_double(double n, double c) /* (2) */
{
    return c / (n - n * c + c);
}

static double blinn_double(double n, double c) /* (1) */
{
    return pow(c, n);
}

static double gauss_double(double n, double c) /* (1) */
{
    const double x = acos(c);
    return exp(-n * x * x / 2);
}

static double cayley_double(double n, double c)
{
    if (n <= 4)
        return pow(c, n);
    const double r = fmax(0, 4 * (1 + c) - n * (1 - c)) / (4 * (1 + c) + n * (1 - c));
    return r * r * (r * r);
}

/* R. F. Lyon, Phong Shading Reformulation for Hardware Renderer Simplification, Apple Technical Report 43, 1993. */
static double lyon_double(double n, double c)
{
    const double base = fmax(0, 1 - n * (1 - c) / 4);
    return base * base * (base * base);
}

double model_double(enum glint_model model, double n, double c)
{
#define FORMULA(number, name, function, use) function##_double,
    static double (*const formulas[])(double n, double c) = {GLINT_MODELS(FORMULA)};
    return (unsigned)model < GLINT_MODEL_COUNT ? formulas[model](n, c) : 0;
}

#define NAME(number, name, function, use) #name,
const char *const model_names[] = {GLINT_MODELS(NAME) NULL};

enum glint_model parse_model(const struct argp_state *state, const char *option, const char *text)
{
    return (enum glint_model)parse_choice(state, option, "model", text, model_names);
}

void parse_models(const struct argp_state *state, const char *option, const char *text, bool given[GLINT_MODEL_COUNT])
{
    static const char *const choices[] = {GLINT_MODELS(NAME) "all", NULL};
    const unsigned choice = parse_choice(state, option, "model", text, choices);
    for (unsigned i = 0; i < GLINT_MODEL_COUNT; i++)
        given[i] = choice == i || choice == GLINT_MODEL_COUNT;
}
