/* SPDX-License-Identifier: MIT
 * Every model and every kind of pixel: what a program links that does not name its own. */
#include "glint_pixel_prepared.h"

/* An unknown model: no highlight. */
static uint32_t any_dark(uint32_t n, uint32_t t_q30)
{
    (void)n, (void)t_q30;
    return 0;
}

static void any_run_dark(const struct glint_near *near, struct glint_sample *samples, unsigned count)
{
    (void)near;
    for (unsigned i = 0; i < count; i++)
        samples[i].f_q16 = 0;
}

static const struct glint_shade_model any_unknown GLINT_FLASH = {UINT8_MAX, 0, NULL, NULL, any_run_dark, any_dark};

#define ANY_MODEL(number, name, function, use) &glint_shade_##name,
static const struct glint_shade_model *const any_models[] GLINT_FLASH = {GLINT_MODELS(ANY_MODEL)};
static const struct glint_shade_format *const any_formats[] GLINT_FLASH = {
    &glint_shade_rgb565, &glint_shade_rgb888, &glint_shade_bgr888, &glint_shade_grey, &glint_shade_linear};

enum glint_err glint_shade_prepare(struct glint_prepared *prepared, const struct glint_shader *shader)
{
    if (!prepared || !shader)
        return GLINT_ERR_ARG;
    const struct glint_shade_model *model = &any_unknown;
    for (size_t i = 0; i < sizeof any_models / sizeof *any_models; i++)
        if (GLINT_FLASH_U8(GLINT_FLASH_POINTER(any_models[i])->model) == shader->lobe.model)
            model = GLINT_FLASH_POINTER(any_models[i]);
    for (size_t i = 0; i < sizeof any_formats / sizeof *any_formats; i++) {
        const struct glint_shade_format *format = GLINT_FLASH_POINTER(any_formats[i]);
        if (GLINT_FLASH_POINTER(format->draws)(shader)) {
            glint_prepared_fill(prepared, shader, model, format);
            return GLINT_OK;
        }
    }
    return GLINT_ERR_FORMAT;
}
