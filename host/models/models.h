/* SPDX-License-Identifier: MIT
 * What is known of the library's models besides its functions, a file a model: lobe_NAME.c has model_NAME, which the command's
 * comparisons, the paper's table and the page take from here. */
#ifndef GLINT_MODELS_MODELS_H
#define GLINT_MODELS_MODELS_H

#include <argp.h>
#include <stdbool.h>

#include "glint.h"

/* Arithmetic for one c where all that depends on n alone is prepared. */
struct model_operations {
    int multiply, add, divide;
    const char *more; /* what is not elementary arithmetic; NULL: nothing */
};

struct model_facts {
    const char *title, *long_title;      /* "Cayley", "Cayley (ours)"; NULL: the same */
    const char *formula;                 /* in ASCII, c^n for a power */
    const char *meaning;                 /* for who chooses: half a sentence */
    const char *source;                  /* where it was published; NULL: in the paper, or here */
    double (*value)(double n, double c); /* in double precision, as the formula is printed; c in 0..1 */
    struct model_operations operations;  /* all 0: not counted */
};

/* One for each line of GLINT_MODELS. */
#define MODEL_FACTS(number, name, function, use, grain) extern const struct model_facts model_##name;
GLINT_MODELS(MODEL_FACTS)
extern const struct model_facts *const model_facts[]; /* by enum glint_model */
extern const char *const model_names[];               /* "msh" ..., by enum glint_model; NULL at the end */

double model_double(enum glint_model model, double n, double c); /* its value; 0 for an unknown model */

/* glTF's roughness r as a shininess, by GGX's alpha: r^4 = alpha^2 = 2 / (n + 2). Infinite for 0. */
double shininess_of_roughness(double roughness);
unsigned shininess_held(double n); /* to nearest, 1..1000 */
/* Can it have a grain, that is, n_across? */
bool model_has_grain(enum glint_model model);
/* Its value with a grain, n along it and n_across across it; h_t_square: (H.T)^2, T the unit direction of the grain. */
double model_grained(enum glint_model model, double n, double n_across, double c, double h_t_square);

/* "msh, schlick, ..., ", for help. */
#define MODEL_WORD(number, name, function, use, grain) #name ", "
#define MODEL_WORDS GLINT_MODELS(MODEL_WORD)

enum glint_model parse_model(const struct argp_state *state, const char *option, const char *text);
/* One, or all. */
void parse_models(const struct argp_state *state, const char *option, const char *text, bool given[GLINT_MODEL_COUNT]);

#endif
