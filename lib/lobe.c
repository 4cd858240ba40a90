/* SPDX-License-Identifier: MIT
 * The functions that take the model as an argument, and prepared lobes; they link every model. An unknown model gives 0. */
#include "glint_lobe.h"

uint32_t glint_eval(enum glint_model model, uint32_t n, int32_t c_q16)
{
    switch (model) {
#define MODEL_CASE(number, name, function, use, grain)                                                                 \
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
#define MODEL_CASE(number, name, function, use, grain)                                                                 \
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
#define MODEL_CASE(number, name, function, use, grain)                                                                 \
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
#define MODEL_CASE(number, name, function, use, grain)                                                                 \
    case number:                                                                                                       \
        return glint_##function##_cutoff_t(n, q);
        GLINT_MODELS(MODEL_CASE)
#undef MODEL_CASE
    }
    return 0;
}

/* ---- prepared ---- */

void glint_lobe_init(struct glint_lobe *lobe, enum glint_model model, uint32_t n, unsigned q)
{
    lobe->model = (uint8_t)((unsigned)model < GLINT_MODEL_COUNT ? model : UINT8_MAX); /* unknown stays unknown */
    lobe->n = (uint16_t)glint_clamp_n(n);
    lobe->q = (uint8_t)glint_clamp_q(q);
    lobe->c_min_q16 = glint_cutoff(model, n, q);
    lobe->t_max_q30 = glint_cutoff_t(model, n, q);
}

uint32_t glint_lobe_eval(const struct glint_lobe *lobe, int32_t c_q16)
{
    if (c_q16 < (int32_t)lobe->c_min_q16)
        return 0;
    return glint_eval((enum glint_model)lobe->model, lobe->n, c_q16);
}

uint32_t glint_lobe_eval_t(const struct glint_lobe *lobe, uint32_t t_q30)
{
    if (t_q30 > lobe->t_max_q30)
        return 0;
    return glint_eval_t((enum glint_model)lobe->model, lobe->n, t_q30);
}
