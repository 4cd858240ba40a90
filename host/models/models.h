/* SPDX-License-Identifier: MIT
 * The models by name, and their formulas in double precision, as the paper prints them. */
#ifndef GLINT_MODELS_MODELS_H
#define GLINT_MODELS_MODELS_H

#include <argp.h>
#include <stdbool.h>

#include "glint.h"

double model_double(enum glint_model model, double n, double c); /* c in 0..1 */
extern const char *const model_names[];                          /* "msh" ..., by enum glint_model; NULL at the end */

/* "msh, schlick, ..., ", for help. */
#define MODEL_WORD(number, name, function, use) #name ", "
#define MODEL_WORDS GLINT_MODELS(MODEL_WORD)

enum glint_model parse_model(const struct argp_state *state, const char *option, const char *text);
/* One, or all. */
void parse_models(const struct argp_state *state, const char *option, const char *text, bool given[GLINT_MODEL_COUNT]);

#endif
