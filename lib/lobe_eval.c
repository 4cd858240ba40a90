/* SPDX-License-Identifier: MIT
 * The functions that take the model as an argument; they link every model. An unknown model gives 0. */
#include "glint.h"
#include "glint_math_flash.h"

uint32_t glint_eval(enum glint_model model, uint32_t n, int32_t c_q16)
{
    switch (model) {
#define MODEL_CASE(number, name, function, use)                                                                        \
    case number:                                                                                                       \
        return glint_##function(n, c_q16);
        GLINT_MODELS(MODEL_CASE)
#undef MODEL_CASE
    }
    return 0;
}

uint32_t glint_eval_t(enum glint_model model, uint32_t n, uint32_t t_q30)
{
    switch (model) {
#define MODEL_CASE(number, name, function, use)                                                                        \
    case number:                                                                                                       \
        return glint_##function##_t(n, t_q30);
        GLINT_MODELS(MODEL_CASE)
#undef MODEL_CASE
    }
    return 0;
}

uint32_t glint_cutoff(enum glint_model model, uint32_t n, unsigned q)
{
    switch (model) {
#define MODEL_CASE(number, name, function, use)                                                                        \
    case number:                                                                                                       \
        return glint_##function##_cutoff(n, q);
        GLINT_MODELS(MODEL_CASE)
#undef MODEL_CASE
    }
    return 0;
}

uint32_t glint_cutoff_t(enum glint_model model, uint32_t n, unsigned q)
{
    switch (model) {
#define MODEL_CASE(number, name, function, use)                                                                        \
    case number:                                                                                                       \
        return glint_##function##_cutoff_t(n, q);
        GLINT_MODELS(MODEL_CASE)
#undef MODEL_CASE
    }
    return 0;
}
