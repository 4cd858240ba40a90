/* SPDX-License-Identifier: MIT */
#include "glint_tables_columns.h"
#include "glint_pixel.h"
#include "glint_tables_geometry.h"

enum { COLUMNS_SPARE = 16, LAST_STEP = GLINT_COLOUR_STEPS - 1 };
#define COLUMNS_GAP ((uint32_t)1 << 16) /* how far below 0 t may come, Q2.30, by rounding */

unsigned glint_columns_shift(uint32_t t_max_q30, uint32_t columns)
{
    unsigned s = 0;
    while ((t_max_q30 >> s) + (COLUMNS_GAP >> s) >= columns - COLUMNS_SPARE)
        s++;
    return s;
}

/* By bisection, bit by bit from the top. */
uint32_t glint_last_t(const struct glint_shader *shader, bool (*shows)(const struct glint_shader *shader, uint32_t f))
{
    uint32_t t = 0;
    for (uint32_t bit = (uint32_t)1 << 30; bit; bit >>= 1)
        if ((t | bit) <= shader->lobe.t_max_q30 && shows(shader, glint_pixel_lobe(shader, t | bit)))
            t |= bit;
    return t;
}

uint8_t glint_peak_step(const struct glint_peak *peak, uint32_t f)
{
    return (uint8_t)((LAST_STEP * f + peak->f0 / 2) / peak->f0); /* < 2^23 */
}

uint32_t glint_peak_f(const struct glint_peak *peak, uint32_t step)
{
    return (step * peak->f0 + LAST_STEP / 2) / LAST_STEP;
}

uint8_t glint_peak_step_at(const struct glint_peak *peak, uint32_t t_q30)
{
    return glint_peak_step(peak, glint_pixel_lobe(peak->shader, t_q30));
}

uint32_t glint_row_nl(uint32_t row)
{
    return row < GLINT_COLOUR_ROWS / 2 ? 1024 * row + 512 : 65536; /* 2^24 of Q30 are 1024 of Q16 */
}
