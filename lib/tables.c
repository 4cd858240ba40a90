/* SPDX-License-Identifier: MIT
 * Tables from exact values, and lights for the loops that read them (glint.h): what all kinds have in common. */
#include "glint_math_align.h"
#include "glint_pixel.h"
#include "glint_tables_albedo.h"
#include "glint_tables_colour.h"
#include "glint_tables_dither.h"
#include "glint_tables_small.h"

size_t glint_tables_bytes(enum glint_tables_kind kind)
{
    return kind == GLINT_TABLES_COLOUR   ? GLINT_TABLES_COLOUR_BYTES
           : kind == GLINT_TABLES_SMALL  ? GLINT_TABLES_SMALL_BYTES
           : kind == GLINT_TABLES_ALBEDO ? GLINT_TABLES_ALBEDO_BYTES
                                         : 0;
}

enum glint_err glint_tables_fill(struct glint_tables *tables, enum glint_tables_kind kind,
                                 const struct glint_shader *shader, void *memory, size_t bytes)
{
    const bool dithered = kind == GLINT_TABLES_COLOUR && shader && shader->dither;
    const size_t needed = dithered ? GLINT_TABLES_DITHER_BYTES : glint_tables_bytes(kind);
    if (!tables || !shader || !memory || needed == 0 || bytes < needed || GLINT_MISALIGNED(memory, 32) ||
        shader->lobe.model == GLINT_PHONG || (kind == GLINT_TABLES_ALBEDO && !glint_albedo_can(&shader->material)))
        return GLINT_ERR_ARG;
    if (glint_pixel_check(shader) || (kind != GLINT_TABLES_SMALL && !glint_format_is_565(shader->format)) ||
        (kind == GLINT_TABLES_ALBEDO && shader->dither) || (shader->space && (kind != GLINT_TABLES_COLOUR || dithered)))
        return GLINT_ERR_FORMAT;
    const struct glint_peak peak = {shader, glint_pixel_lobe(shader, 0)};
    if (peak.f0 == 0) /* no such model */
        return GLINT_ERR_ARG;
    tables->kind = (uint8_t)kind;
    tables->format = shader->format;
    tables->dither = shader->dither;
    tables->dark = 0;
    if (dithered)
        glint_dither_fill(tables, shader, memory);
    else if (kind == GLINT_TABLES_COLOUR)
        glint_colour_fill(tables, &peak, memory);
    else if (kind == GLINT_TABLES_ALBEDO)
        glint_albedo_fill(tables, shader, memory);
    else
        glint_small_fill(tables, &peak, memory);
    return GLINT_OK;
}

enum glint_err glint_tables_light_init(struct glint_tables_light *light, const struct glint_tables *tables,
                                       const struct glint_light *from)
{
    if (!light || !tables || !from)
        return GLINT_ERR_ARG;
    light->l = from->l;
    light->h = from->h;
    light->kind = tables->kind;
    light->frontal = from->v.x == 0 && from->v.y == 0 && from->v.z == 32767;
    if (tables->kind == GLINT_TABLES_ALBEDO)
        glint_albedo_light(light, tables);
    else
        glint_colour_light(light, tables);
    return GLINT_OK;
}
