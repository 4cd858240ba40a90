/* SPDX-License-Identifier: MIT */
#include "glint_tables_small.h"
#include "glint_pixel.h"
#include "glint_tables_field.h"
#include "glint_tables_geometry.h"

typedef char glint_small_bytes
    [GLINT_TABLES_SMALL_BYTES >= 4 * (GLINT_SMALL_DIFFUSE + GLINT_COLOUR_STEPS) + 2 * GLINT_SMALL_SEGMENT ? 1 : -1];

/* What nl or F adds to a pixel: its channels as fields of a word. */
static uint32_t sum_word(const struct glint_shader *shader, uint32_t nl_q16, uint32_t f, bool lit)
{
    uint32_t word = 0;
    for (int k = 0; k < 3; k++) {
        const uint8_t albedo = lit ? shader->material.albedo[k] : 0;
        const uint64_t x = glint_pixel_value(shader, k, albedo, nl_q16, (uint64_t)65535 * f);
        const struct glint_field field = glint_field_of(shader->format, k);
        word |= glint_field_level(field, x) << field.at;
    }
    return word;
}

/* A pixel is the sum of two words, one by nl, one by F, so that rows and steps add up where COLOUR multiplies them. F falls
 * steeply near its peak and slowly far from it: the columns are fine near t = 0 and coarse beyond. */
void glint_small_fill(struct glint_tables *tables, const struct glint_peak *peak, void *memory)
{
    enum { SEGMENT = GLINT_SMALL_SEGMENT };
    const uint32_t t_max = peak->shader->lobe.t_max_q30;
    uint32_t *const diffuse = (uint32_t *)memory, *const specular = diffuse + GLINT_SMALL_DIFFUSE;
    uint8_t *const column = (uint8_t *)memory + 4 * (GLINT_SMALL_DIFFUSE + GLINT_COLOUR_STEPS);
    tables->colour.sums = diffuse;
    tables->columns = column;
    unsigned fine = 0;
    while (t_max >> fine >= SEGMENT << GLINT_SMALL_COARSER)
        fine++;
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)fine;
    for (uint32_t i = 0; i < 2 * SEGMENT; i++) {
        const unsigned s = i < SEGMENT ? fine : fine + GLINT_SMALL_COARSER;
        const uint32_t t = ((i % SEGMENT) << s) + ((uint32_t)1 << s >> 1);
        column[i] = glint_peak_step_at(peak, t < t_max ? t : t_max);
    }
    for (uint32_t row = 0; row < GLINT_SMALL_DIFFUSE; row++)
        diffuse[row] = sum_word(peak->shader, row ? glint_row_nl(row - 1) : 0, 0, true);
    for (uint32_t j = 0; j < GLINT_COLOUR_STEPS; j++)
        specular[j] = sum_word(peak->shader, 0, glint_peak_f(peak, j), false);
}
