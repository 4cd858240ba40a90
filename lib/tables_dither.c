/* SPDX-License-Identifier: MIT */
#include "glint_tables_dither.h"
#include "glint_pixel.h"
#include "glint_tables_columns.h"
#include "glint_tables_field.h"

enum { DITHER_SHINES = 1 << GLINT_DITHER_COLUMNS_LOG };
typedef char glint_dither_bytes[GLINT_DITHER_SHINES + 4 * DITHER_SHINES == GLINT_TABLES_DITHER_BYTES ? 1 : -1];

static const struct glint_field dither_fields[3] GLINT_FLASH = {{23, 32, 31 * 16}, {1, 11, 63 * 16}, {12, 21, 31 * 16}};

/* The nearest sixteenths of a level, and b of them more: at most 15 above the largest level, which no field overflows by.
 * albedo NULL: black. */
static uint32_t dither_sum(const struct glint_shader *shader, const uint8_t albedo[3], uint32_t nl_q16, uint32_t f,
                           uint32_t b)
{
    uint32_t word = 0;
    for (int k = 0; k < 3; k++) {
        const struct glint_field field = GLINT_FLASH_STRUCT(struct glint_field, dither_fields[k]);
        const uint64_t value = glint_pixel_value(shader, k, albedo ? albedo[k] : 0, nl_q16, (uint64_t)65535 * f);
        word += (glint_field_level(field, value) + b) << field.at;
    }
    return word;
}

static uint32_t dither_shine(const struct glint_shader *shader, uint32_t f)
{
    return dither_sum(shader, NULL, 0, f, 0);
}

static bool dither_shines(const struct glint_shader *shader, uint32_t f)
{
    return dither_shine(shader, f) != 0;
}

/* Past the highlight a pixel is a function of nl and of its threshold alone: finished, for all sixteen. Within it, it is the sum of
 * two words with sixteenths of a level, so that it is rounded once, and as finely as the exact path does. */
void glint_dither_fill(struct glint_tables *tables, const struct glint_shader *shader, void *memory)
{
    const uint8_t *const albedo = shader->material.albedo;
    uint8_t *const bytes = (uint8_t *)memory;
    const uint32_t t_max = glint_last_t(shader, dither_shines);
    tables->colour.colours = (uint16_t *)memory;
    tables->columns = bytes + GLINT_DITHER_SHINES;
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, DITHER_SHINES);
    uint32_t *const shine = (uint32_t *)memory + GLINT_DITHER_SHINES / 4;
    for (uint32_t i = 0; i < DITHER_SHINES; i++)
        shine[i] = dither_shine(shader, glint_pixel_lobe(shader, glint_column_t(t_max, tables->shift, i)));
    for (uint16_t y = 0; y < 4; y++) {
        uint8_t *const pixels = bytes + y * GLINT_DITHER_PIXELS_PART;
        uint32_t *const sums = (uint32_t *)memory + (GLINT_DITHER_SUMS + y * GLINT_DITHER_SUMS_PART) / 4;
        for (uint32_t row = 0; row < GLINT_DITHER_ROWS; row++) {
            const uint32_t nl = row == 0 ? 0 : 512 * (row - 1); /* row 0 is dark; then nl in steps of 1/128 */
            const struct glint_surface surface = {pixels + 8 * row, 0, 0, y};
            for (uint16_t x = 0; x < 4; x++) {
                glint_pixel_store(shader, &surface, x, 0, nl, 0, albedo, 255);
                if (row > 0)
                    sums[4 * (row - 1) + x] = dither_sum(shader, albedo, nl, 0, glint_pixel_bayer(x, y));
            }
        }
    }
}
