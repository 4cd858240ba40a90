/* SPDX-License-Identifier: MIT
 * ALBEDO tables. The albedo varies from pixel to pixel, so they hold what it is scaled by and what is added: by nl a level of 32,
 * by t the highlight as a word of fields. RAM: 8,584 bytes of tables, no buffers. */
#include "glint_math.h"
#include "glint_tables.h"

enum { ALBEDO_SHINES = 1 << GLINT_ALBEDO_COLUMNS_LOG };
typedef char glint_albedo_bytes[GLINT_TABLES_ALBEDO_BYTES == GLINT_ALBEDO_LEVELS + 4 * ALBEDO_SHINES ? 1 : -1];

/* The highlight's nearest levels in RGB565, as fields (GLINT_ALBEDO_FIELDS). */
static uint32_t albedo_shine(const struct glint_paint *exact, uint32_t f)
{
    static const struct glint_field fields[3] GLINT_FLASH = {{11, 31}, {21, 63}, {0, 31}};
    uint32_t word = 0;
    for (unsigned k = 0; k < 3; k++) {
        const struct glint_field field = GLINT_FLASH_STRUCT(struct glint_field, fields[k]);
        word |= glint_field_level(exact, field, k, 0, 0, f) << field.at;
    }
    return word;
}

static bool albedo_shines(const struct glint_paint *exact, uint32_t f)
{
    return albedo_shine(exact, f) != 0;
}

static void albedo_fill(struct glint_tables *tables, const struct glint_paint *exact, void *memory)
{
    const struct glint_material *m = &exact->material;
    const uint32_t ambient = m->ambient_q16[0], diffuse = m->diffuse_q16[0]; /* <= 2^16 */
    const uint32_t t_max = glint_last_t(exact, albedo_shines);
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, ALBEDO_SHINES);
    uint8_t *const levels = (uint8_t *)memory;
    uint32_t *const sums = (uint32_t *)memory + GLINT_ALBEDO_LEVELS / 4;
    tables->columns = levels + GLINT_ALBEDO_LEVELS;
    tables->colour.sums = sums;
    for (uint32_t i = 0; i < ALBEDO_SHINES; i++)
        sums[i] = albedo_shine(exact, glint_paint_f(exact, glint_column_t(t_max, tables->shift, i)));
    for (int32_t row = 0; row < GLINT_ALBEDO_LEVELS; row++) {
        const uint32_t lit = row < 128 ? diffuse * (2 * (uint32_t)row + 1) >> 3 : diffuse * 32; /* 32 D nl < 2^25 */
        levels[GLINT_ALBEDO_LEVELS - 1 - row] = (uint8_t)((ambient * 32 + lit + 32768) >> 16);
    }
    tables->dark = (uint16_t)((ambient * 32u + 32768) >> 16);
}

static enum glint_err albedo_can(const struct glint_material *m, const struct glint_output *output)
{
    for (int k = 1; k < 3; k++)
        if (m->ambient_q16[k] != m->ambient_q16[k - 1] || m->diffuse_q16[k] != m->diffuse_q16[k - 1])
            return GLINT_ERR_ARG;
    if (m->ambient_q16[0] > 65536 || m->diffuse_q16[0] > 65536 - m->ambient_q16[0])
        return GLINT_ERR_ARG;
    return glint_format_is_565(output->format) && !output->dither && !output->space ? GLINT_OK : GLINT_ERR_FORMAT;
}

/* As for COLOUR, but in Q25 and with the other sign, so that neither a shift of e nor a second table's address is needed.
 * r has few bits then; cut is such that the peak stays in its column. What r is off by, 1/64 at the most, t is off by. */
static void albedo_light(struct glint_paint *paint)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const unsigned reader = 32 - GLINT_ALBEDO_COLUMNS_LOG; /* e r >> this is the column */
    const struct glint_vec l = paint->l;
    const int32_t y_q9 = -(((int32_t)l.y + 16) >> 5), z_q9 = -(((int32_t)l.z + 16) >> 5);
    const int64_t x = l.x, y = 32 * y_q9, z = 32 * z_q9 - 32768;
    const uint32_t peak = glint_root((uint64_t)(x * x + y * y + z * z) << 20); /* Q25 */
    const uint64_t r = peak ? (((uint64_t)1 << (30 + reader - tables->shift)) + peak / 2) / peak : 0;
    paint->of.tables.y = y_q9;
    paint->of.tables.z = z_q9;
    paint->of.tables.x = -8 * (int32_t)l.x - y_q9;
    paint->of.tables.r = r == 0 ? 1 : r > UINT32_MAX ? UINT32_MAX : (uint32_t)r;
    paint->of.tables.cut =
        (int32_t)(peak - (uint32_t)(((uint64_t)tables->t_max_q30 << reader >> tables->shift) / paint->of.tables.r));
    paint->of.tables.is_frontal = paint->v.x == 0 && paint->v.y == 0 && paint->v.z == 32767;
}

/* ---- Drawn: the general way ---- */

/* d is in Q25, negative where lit, |d| < 255 2^18; e >= 0 within the highlight. */
static void albedo_raws(const struct glint_paint *paint, const uint32_t *words, struct glint_raw *raw, unsigned count)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    for (const uint32_t *end = words + count; words != end; words++, raw++) {
        const int32_t d = glint_colour_d(paint, *words);
        const uint32_t e = ((uint32_t)((int32_t)*words >> 16) << 10) - (uint32_t)paint->of.tables.cut - (uint32_t)d;
        raw->nl_q30 =
            *words >> 16 ? (int32_t)((uint32_t)(-1 - (d >> (GLINT_ALBEDO_LEVEL_SHIFT - 5))) << GLINT_ALBEDO_LEVEL_SHIFT)
                         : GLINT_RAW_NOTHING;
        raw->back = (int32_t)e < 0 ? GLINT_RAW_OUTSIDE
                                   : (e * paint->of.tables.r) >> (32 - GLINT_ALBEDO_COLUMNS_LOG) << tables->shift;
    }
}

/* glossy: with a map of gloss. */
static inline __attribute__((always_inline)) void albedo_each(const struct glint_paint *paint,
                                                              const struct glint_run *run, const struct glint_raw *raw,
                                                              unsigned count, bool glossy)
{
    unsigned at = 0;
    const struct glint_tables *tables = &paint->of.tables.filled;
    const uint16_t *albedo = (const uint16_t *)(const void *)run->albedo;
    const bool swapped = glint_is_swapped(tables);
    uint8_t *out = run->line + 2 * run->x;
    for (const struct glint_raw *end = raw + count; raw != end; raw++, out += 2, albedo++, at++)
        if (raw->nl_q30 != GLINT_RAW_NOTHING)
            glint_put_pixel(out,
                            glint_albedo_pixel(tables, raw, *albedo,
                                               glossy ? glint_gloss_part(run->gloss[at]) : GLINT_NO_GLOSS, swapped));
}

static void albedo_pixels(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raw,
                          unsigned count)
{
    albedo_each(paint, run, raw, count, false);
}

static void albedo_with_gloss(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raw,
                              unsigned count)
{
    albedo_each(paint, run, raw, count, true);
}

#define ALBEDO_USE(shiny, glossy)                                                                                      \
    {                                                                                                                  \
        GLINT_TABLES_ALBEDO, false, true, GLINT_TABLES_ALBEDO_BYTES, albedo_can, albedo_fill, albedo_light,            \
            glint_tables_check, glint_tables_draw, shiny, glossy, albedo_raws, albedo_pixels,                          \
            GLINT_TABLES_FUSED(glint_albedo_line), NULL                                                                \
    }
const struct glint_use_tables glint_use_albedo GLINT_FLASH = ALBEDO_USE(NULL, NULL);
const struct glint_use_tables glint_use_albedo_maps GLINT_FLASH = ALBEDO_USE(glint_tables_shiny, albedo_with_gloss);
