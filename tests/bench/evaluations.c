/* SPDX-License-Identifier: MIT */
#include "evaluations.h"

#include "peers.h"
#include "sphere.h"

struct glint_lobe evaluation_lobe;

void evaluation_begin(uint32_t n)
{
    glint_lobe_init(&evaluation_lobe, GLINT_MSH, n, SPHERE_Q);
    peer_table_fill(n);
}

/* glint_* take c as int32_t: of the same size, in the same register. */
#define FROM_C(function, model, what)                                                                                  \
    {                                                                                                                  \
#function, what, (uint32_t(*)(uint32_t, uint32_t))function, 0, 0, TAKES_C, model                               \
    }
#define FROM_T(function, model, what)                                                                                  \
    {                                                                                                                  \
#function, what, function, 0, 0, TAKES_T, model                                                                \
    }
#define FLOAT(function, model, what)                                                                                   \
    {                                                                                                                  \
#function, what, 0, 0, function, TAKES_FLOAT, model                                                            \
    }

#define MODEL_ROWS_own(function, number)                                                                               \
    FROM_C(glint_##function, number, "exact"), FROM_T(glint_##function##_t, number, "from t"),
#define MODEL_ROWS_shared(function, number)
#define MODEL_ROWS(number, name, function, use, grain) MODEL_ROWS_##use(function, number)

const struct evaluation evaluations[] = {
    GLINT_MODELS(MODEL_ROWS){"glint_lobe_eval_t", "MSH, with its cutoff", 0, glint_lobe_eval_t, 0, TAKES_LOBE,
                             GLINT_MSH},
    FLOAT(peer_msh_float, GLINT_MSH, "float"),
    FLOAT(peer_schlick_float, GLINT_SCHLICK, "float"),
    FLOAT(peer_blinn_powf, GLINT_BLINN, "float, the C library's powf"),
    FROM_C(peer_table, GLINT_BLINN, "256 powers, the nearest below"),
#if BENCH_FIXMATH
    FROM_C(peer_msh_fixmath, GLINT_MSH, "libfixmath"),
    FROM_C(peer_schlick_fixmath, GLINT_SCHLICK, "libfixmath"),
    FROM_C(peer_blinn_fixmath, GLINT_BLINN, "libfixmath"),
#endif
    {0, 0, 0, 0, 0, 0, 0},
};
