/* SPDX-License-Identifier: MIT
 * Paints of every model and every format: what a program links that does not name its own. */
#include "glint_pixel.h"
#include "glint_tables.h"

#define ANY_grained(name) &glint_use_##name##_grain,
#define ANY_plain(name) &glint_use_##name,
#define ANY_MODEL(number, name, function, use, grain) ANY_##grain(name)
static const struct glint_use_model *const any_models[] GLINT_FLASH = {GLINT_MODELS(ANY_MODEL)};
#undef ANY_MODEL
#undef ANY_grained
#undef ANY_plain
static const struct glint_use_format *const any_formats[] GLINT_FLASH = {&glint_use_rgb565, &glint_use_rgb888,
                                                                         &glint_use_grey, &glint_use_linear};

static const struct glint_use_model *any_model(uint8_t model)
{
    for (size_t i = 0; i < sizeof any_models / sizeof *any_models; i++)
        if (GLINT_FLASH_U8(GLINT_FLASH_POINTER(any_models[i])->model) == model)
            return GLINT_FLASH_POINTER(any_models[i]);
    return NULL;
}

/* The last where none of the others draws it: whether that does is asked later. */
static const struct glint_use_format *any_format(const struct glint_output *output)
{
    size_t i = 0;
    while (i + 1 < sizeof any_formats / sizeof *any_formats &&
           !GLINT_FLASH_POINTER(GLINT_FLASH_POINTER(any_formats[i])->draws)(output))
        i++;
    return GLINT_FLASH_POINTER(any_formats[i]);
}

enum glint_err glint_paint_exact(struct glint_paint *paint, const struct glint_material *material,
                                 const struct glint_output *output)
{
    const enum glint_err err = glint_paint_check(material, output, true);
    if (err)
        return err;
    return glint_paint_exact_for(paint, material, output, any_model(material->model), any_format(output));
}

enum glint_err glint_paint_tables(struct glint_paint *paint, enum glint_tables_kind kind,
                                  const struct glint_material *material, const struct glint_output *output,
                                  void *memory, size_t bytes)
{
    const enum glint_err err = glint_paint_check(material, output, true);
    if (err)
        return err;
    const struct glint_use_tables *use = kind == GLINT_TABLES_ALBEDO   ? &glint_use_albedo_maps
                                         : kind != GLINT_TABLES_COLOUR ? NULL
                                         : output->dither              ? &glint_use_colour_dithered_maps
                                                                       : &glint_use_colour_maps;
    return glint_paint_tables_for(paint, use, material, output, memory, bytes, any_model(material->model),
                                  any_format(output));
}

enum glint_err glint_paint_steps(struct glint_paint *paint, void *memory, size_t bytes)
{
    const bool is_linear = paint && paint->output.space == GLINT_LINEAR;
    return glint_paint_steps_for(paint, is_linear ? &glint_use_linear_steps : &glint_use_rgb565_steps, memory, bytes);
}
