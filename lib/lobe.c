/* SPDX-License-Identifier: MIT */
#include "glint_lobe_domain.h"

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
