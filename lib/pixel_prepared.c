/* SPDX-License-Identifier: MIT */
#include "glint_pixel_prepared.h"

typedef char glint_prepared_bytes[sizeof(struct glint_prepared) <= 200 ? 1 : -1]; /* it lies on stacks */

/* F falls as t grows, and is 0 beyond 2^30. With lobes as glint_lobe_init fills them F(t_max) > 0, so it is only lobes filled
 * otherwise that are searched for the last F > 0. */
static uint32_t prepared_find_t_end(const struct glint_shade_model *model, uint32_t n, uint32_t t_max)
{
    const uint32_t last = t_max < GLINT_T_ONE ? t_max : GLINT_T_ONE;
    if (GLINT_FLASH_POINTER(model->exact)(n, last))
        return last + 1;
    if (!GLINT_FLASH_POINTER(model->exact)(n, 0))
        return 0;
    uint32_t t = 0;
    for (uint32_t bit = GLINT_T_ONE >> 1; bit; bit >>= 1)
        if (t + bit < last && GLINT_FLASH_POINTER(model->exact)(n, t + bit))
            t += bit;
    return t + 1;
}

void glint_prepared_fill(struct glint_prepared *prepared, const struct glint_shader *shader,
                         const struct glint_shade_model *model, const struct glint_shade_format *format)
{
    const struct glint_lobe *lobe = &shader->lobe;
    struct glint_near *near = &prepared->near;
    prepared->shader = *shader;
    prepared->model = model;
    prepared->slack = GLINT_FLASH_U8(model->slack);
    prepared->apart = prepared->high = 0;
    prepared->format = format;
    near->n = lobe->n < 1 ? 1 : lobe->n > GLINT_N_MAX ? GLINT_N_MAX : lobe->n;
    near->f_max = shader->clamp_peak ? 65536 : UINT32_MAX;
    near->t_end = prepared_find_t_end(model, near->n, lobe->t_max_q30);
    if (GLINT_FLASH_POINTER(model->fold)) /* of a model whose F(0) > 0: t_end > 0 */
        GLINT_FLASH_POINTER(model->fold)(near);
    GLINT_FLASH_POINTER(format->fold)(prepared);
}

enum glint_err glint_shade_prepare_for(struct glint_prepared *prepared, const struct glint_shader *shader,
                                       const struct glint_shade_model *model, const struct glint_shade_format *format)
{
    if (!prepared || !shader || !model || !format || shader->lobe.model != GLINT_FLASH_U8(model->model))
        return GLINT_ERR_ARG;
    if (!GLINT_FLASH_POINTER(format->draws)(shader))
        return GLINT_ERR_FORMAT;
    glint_prepared_fill(prepared, shader, model, format);
    return GLINT_OK;
}

enum glint_err glint_shade_relight(struct glint_prepared *prepared, const struct glint_light *light)
{
    if (!prepared || !light)
        return GLINT_ERR_ARG;
    prepared->shader.light = *light;
    return GLINT_OK;
}

/* The pixels that the bound leaves open. */
static void prepared_finish(const struct glint_prepared *prepared, const struct glint_run *run,
                            const struct glint_sample *sample, uint32_t open)
{
    for (unsigned i = 0; open; i++, open >>= 1)
        if (open & 1)
            glint_prepared_exact(prepared, run, i, sample + i);
}

void glint_prepared_run(const struct glint_prepared *prepared, const struct glint_run *run,
                        struct glint_sample *samples, unsigned count)
{
    GLINT_FLASH_POINTER(prepared->model->run)(&prepared->near, samples, count);
    const uint32_t open = GLINT_FLASH_POINTER(prepared->format->levels)(prepared, run, samples, count);
    if (open)
        prepared_finish(prepared, run, samples, open);
}
