/* SPDX-License-Identifier: MIT
 * COLOUR tables with dither. Past the highlight a pixel is a function of nl and of its threshold alone: finished, for all sixteen
 * thresholds. Within it, it is the sum of two words with sixteenths of a level, so that it is rounded once, and as finely as the exact
 * paint does. Each line of the screen has its part of the tables, and so its own rows: lines take turns between two rows
 * (glint_dither_look_up's nudge). Phases are 2 (x mod 4): the place of a pixel among the four of a row. */
#include "glint_math.h"
#include "glint_tables.h"

enum { DITHER_SHINES = 1 << GLINT_DITHER_COLUMNS_LOG };
typedef char glint_dither_bytes[GLINT_DITHER_SHINES + 4 * DITHER_SHINES == GLINT_TABLES_DITHER_BYTES ? 1 : -1];

static const struct glint_field dither_fields[3] GLINT_FLASH = {{23, 32, 31 * 16}, {1, 11, 63 * 16}, {12, 21, 31 * 16}};

/* The nearest sixteenths of a level, and b of them more: at most 15 above the largest level, which no field overflows by.
 * albedo NULL: black. */
static uint32_t dither_sum(const struct glint_paint *exact, const uint8_t albedo[3], uint32_t nl_q16, uint32_t f,
                           uint32_t b)
{
    uint32_t word = 0;
    for (unsigned k = 0; k < 3; k++) {
        const struct glint_field field = GLINT_FLASH_STRUCT(struct glint_field, dither_fields[k]);
        word += (glint_field_level(exact, field, k, albedo ? albedo[k] : 0, nl_q16, f) + b) << field.at;
    }
    return word;
}

static uint32_t dither_shine(const struct glint_paint *exact, uint32_t f)
{
    return dither_sum(exact, NULL, 0, f, 0);
}

static bool dither_shines(const struct glint_paint *exact, uint32_t f)
{
    return dither_shine(exact, f) != 0;
}

static void dither_fill(struct glint_tables *tables, const struct glint_paint *exact, void *memory)
{
    const uint8_t *const albedo = exact->material.albedo;
    uint8_t *const bytes = (uint8_t *)memory;
    const uint32_t t_max = glint_last_t(exact, dither_shines);
    tables->colour.colours = (uint16_t *)memory;
    tables->columns = bytes + GLINT_DITHER_SHINES;
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, DITHER_SHINES);
    uint32_t *const shine = (uint32_t *)memory + GLINT_DITHER_SHINES / 4;
    for (uint32_t i = 0; i < DITHER_SHINES; i++)
        shine[i] = dither_shine(exact, glint_paint_f(exact, glint_column_t(t_max, tables->shift, i)));
    struct glint_run run = {NULL, 0, 0, 0, NULL, NULL, NULL, 0, exact->format, NULL};
    for (; run.y < 4; run.y++) {
        const uint32_t y = run.y;
        uint32_t *const sums = (uint32_t *)memory + (GLINT_DITHER_SUMS + y * GLINT_DITHER_SUMS_PART) / 4;
        for (uint32_t row = 0; row < GLINT_DITHER_ROWS; row++) {
            run.line = bytes + y * GLINT_DITHER_PIXELS_PART + 8 * row;
            const uint32_t nl = row == 0 ? 0 : 512 * (row - 1); /* row 0 is dark; then nl in steps of 1/128 */
            const struct glint_sample sample = {UINT32_MAX, nl, 0};
            for (unsigned x = 0; x < 4; x++) {
                GLINT_FLASH_POINTER(exact->format->exact)(exact, &run, x, &sample, 0);
                if (row > 0)
                    sums[4 * (row - 1) + x] = dither_sum(exact, albedo, nl, 0, glint_bayer_row(x, y) & 15);
            }
        }
    }
}

static enum glint_err dither_can(const struct glint_material *material, const struct glint_output *output)
{
    return output->dither ? glint_colour_can(material, output) : GLINT_ERR_FORMAT;
}

/* ---- Drawn: the general way ---- */

static void dither_raws(const struct glint_paint *paint, const uint32_t *words, struct glint_raw *raws, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        raws[i] = glint_colour_raw(paint, words[i], GLINT_DITHER_COLUMNS_LOG);
}

/* A row and a phase find a finished pixel, or, where there is a highlight, a sum to which its shine is added. */
static void dither_pixels(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raw,
                          unsigned count)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const struct glint_dither_look look = glint_dither_look_up(tables, run->y);
    const bool swapped = glint_is_swapped(tables);
    uint32_t phase = 2 * ((run->left + run->x) & 3);
    uint8_t *out = run->line + 2 * run->x;
    for (const struct glint_raw *end = raw + count; raw != end; raw++, out += 2, phase = glint_dither_next(phase))
        if (raw->nl_q30 != GLINT_RAW_NOTHING)
            glint_put_pixel(out, glint_dither_pixel(&look, raw, phase, swapped));
}

const struct glint_use_tables glint_use_colour_dithered GLINT_FLASH = {GLINT_TABLES_COLOUR,
                                                                       true,
                                                                       false,
                                                                       GLINT_TABLES_DITHER_BYTES,
                                                                       dither_can,
                                                                       dither_fill,
                                                                       glint_colour_light,
                                                                       glint_tables_check,
                                                                       glint_tables_draw,
                                                                       dither_raws,
                                                                       dither_pixels,
                                                                       GLINT_TABLES_FUSED(glint_dither_line),
                                                                       GLINT_TABLES_FUSED(glint_dither_fused)};
