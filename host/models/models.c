/* SPDX-License-Identifier: MIT */
#include "models/models.h"

#include <math.h>

#include "base/parse.h"

#define FACTS(number, name, function, use, grain) &model_##name,
const struct model_facts *const model_facts[] = {GLINT_MODELS(FACTS)};

#define NAME(number, name, function, use, grain) #name,
const char *const model_names[] = {GLINT_MODELS(NAME) NULL};

double model_double(enum glint_model model, double n, double c)
{
    return (unsigned)model < GLINT_MODEL_COUNT ? model_facts[model]->value(n, c) : 0;
}

double shininess_of_roughness(double roughness)
{
    const double alpha = roughness * roughness;
    return 2 / (alpha * alpha) - 2;
}

unsigned shininess_held(double n)
{
    return (unsigned)fmin(fmax(round(n), 1), GLINT_N_MAX);
}

bool model_has_grain(enum glint_model model)
{
    return model == GLINT_MSH || model == GLINT_SCHLICK || model == GLINT_CAYLEY || model == GLINT_LYON ||
           model == GLINT_GGX;
}

/* n t becomes n_across t + (n - n_across) (H.T)^2 / 2, and GGX's n (1 - c^2) n_across (1 - c^2) + (n - n_across) (H.T)^2: that of another
 * n. At t = 0 there is no (H.T)^2 either. Cayley's is r^4 for every n then. */
double model_grained(enum glint_model model, double n, double n_across, double c, double h_t_square)
{
    const double of = model == GLINT_GGX ? 1 - c * c : 2 * (1 - c);
    const double here = of > 0 ? n_across + (n - n_across) * h_t_square / of : n;
    if (model != GLINT_CAYLEY)
        return model_double(model, here, c);
    const double p = 4 * (1 + c) - here * (1 - c), s = 4 * (1 + c) + here * (1 - c);
    return p > 0 ? pow(p / s, 4) : 0;
}

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
