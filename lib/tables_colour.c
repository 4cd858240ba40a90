/* SPDX-License-Identifier: MIT
 * COLOUR tables: nl leads to a row of colours, t to a column, which holds the colour's place in the row as an offset in bytes; no pixel
 * multiplies by more than a vector. RAM: 20,480 bytes of tables, no buffers. */
#include "glint_math.h"
#include "glint_tables.h"

typedef char glint_colour_bytes[GLINT_TABLES_COLOUR_BYTES ==
                                        2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS + (1 << GLINT_COLOUR_COLUMNS_LOG)
                                    ? 1
                                    : -1];

/* ---- Filled ---- */

enum { COLOUR_LAST = GLINT_COLOUR_STEPS - 1 };

/* F in 64 steps, of which the last is the peak's, f0 = F(0): 1.0 at least for n and q of the domain, so never 0; below 2^17. */
static uint32_t colour_step(uint32_t f0, uint32_t f)
{
    return (COLOUR_LAST * f + f0 / 2) / f0; /* < 2^23 */
}

static bool colour_has_step(const struct glint_paint *exact, uint32_t f)
{
    return colour_step(glint_paint_f(exact, 0), f) != 0;
}

enum { COLOUR_RUN = 8 }; /* steps at a time: samples on the stack, which is at its deepest here */
typedef char glint_colour_runs[GLINT_COLOUR_STEPS % COLOUR_RUN == 0 ? 1 : -1];

/* Pixels by the format's quick loop, which leaves few to the 64-bit sequence; F is given. */
static void colour_draw(const struct glint_paint *exact, const struct glint_run *run,
                        const struct glint_sample *samples, unsigned count)
{
    uint32_t open = GLINT_FLASH_POINTER(exact->format->levels)(exact, run, samples, count);
    for (unsigned i = 0; open; i++, open >>= 1)
        if (open & 1)
            GLINT_FLASH_POINTER(exact->format->exact)(exact, run, i, samples + i, 0);
}

/* Finished pixels, a run of steps in every row: the middle of its nl, which beyond 1 is 1. */
static void colour_fill_rows(const struct glint_paint *exact, uint32_t f0, struct glint_run *run, uint8_t *colours)
{
    struct glint_sample samples[COLOUR_RUN];
    for (; run->x < GLINT_COLOUR_STEPS; run->x += COLOUR_RUN) {
        for (unsigned i = 0; i < COLOUR_RUN; i++)
            samples[i].f_q16 = ((run->x + i) * f0 + COLOUR_LAST / 2) / COLOUR_LAST;
        for (run->y = 0; run->y < GLINT_COLOUR_ROWS; run->y++) {
            for (unsigned i = 0; i < COLOUR_RUN; i++)
                samples[i].nl_q16 = run->y < GLINT_COLOUR_ROWS / 2 ? 1024 * run->y + 512 : 65536;
            run->line = colours + 2 * GLINT_COLOUR_STEPS * (ptrdiff_t)run->y;
            colour_draw(exact, run, samples, COLOUR_RUN);
        }
    }
}

/* Two tables, so that neither axis costs a division: t leads to a column, which holds the nearest step of F as an offset in
 * bytes; nl to a row of finished pixels, in which the offset finds the colour. Columns end where F no longer reaches half
 * a step, so that their resolution goes where the highlight is. */
static void colour_fill(struct glint_tables *tables, const struct glint_paint *exact, void *memory)
{
    const uint32_t columns = (uint32_t)1 << GLINT_COLOUR_COLUMNS_LOG, t_max = glint_last_t(exact, colour_has_step);
    const uint32_t f0 = glint_paint_f(exact, 0);
    tables->colour.colours = (uint16_t *)memory; /* the 16-bit table first, for its alignment */
    uint8_t *const column = (uint8_t *)memory + 2 * GLINT_COLOUR_ROWS * GLINT_COLOUR_STEPS;
    tables->columns = column;
    tables->t_max_q30 = t_max;
    tables->shift = (uint8_t)glint_columns_shift(t_max, columns);
    for (uint32_t i = 0; i < columns; i++)
        column[i] = (uint8_t)(2 * colour_step(f0, glint_paint_f(exact, glint_column_t(t_max, tables->shift, i))));
    struct glint_run run; /* by fields: no call of memset */
    run.line = (uint8_t *)&tables->dark;
    run.x = run.left = run.y = 0;
    run.albedo = run.gloss = run.coverage = NULL;
    run.apart = 0;
    run.format = exact->format;
    run.soft = NULL;
    const struct glint_sample none = {UINT32_MAX, 0, 0};
    colour_draw(exact, &run, &none, 1);
    colour_fill_rows(exact, f0, &run, (uint8_t *)memory);
}

enum glint_err glint_colour_can(const struct glint_material *material, const struct glint_output *output)
{
    (void)material;
    return glint_format_is_565(output->format) && !(output->dither && output->space) ? GLINT_OK : GLINT_ERR_FORMAT;
}

static enum glint_err colour_can(const struct glint_material *material, const struct glint_output *output)
{
    return output->dither ? GLINT_ERR_FORMAT : glint_colour_can(material, output);
}

/* ---- Lit ---- */

/* Do the loops for a viewer in front stay inside the tables? Their row is d >> 23, and the 128 rows end at d = 2^30, N.L = 2.
 * Packed normals are at most sqrt(3) long, so that holds; a column follows from H_z = |L + V| / 2, here within 2^-6, which is far
 * from so only where the light is nearly straight behind. */
static bool colour_is_consistent(const struct glint_paint *paint, uint32_t peak)
{
    const uint32_t margin = (uint32_t)1 << 24;
    const uint32_t off = peak - ((uint32_t)paint->h.z << 15); /* Q29, modulo 2^32: |off| < 2^31.2 */
    return off + margin <= 2 * margin;
}

/* N.H |L + V| = N.L + N.z for a viewer at (0, 0, 1): one dot serves both. With m = |L + V| = peak / 2^29, 1 - N.H =
 * (peak - d - z) / m, so a column's number is (d + z - cut) 2 / m >> s = ((e >> a) r) >> 20, e = d + z - cut in Q29. */
void glint_colour_light(struct glint_paint *paint)
{
    const struct glint_tables *tables = &paint->of.tables.filled;
    const struct glint_vec l = paint->l;
    const int32_t y_q14 = ((int32_t)l.y + 1) >> 1, z_q14 = ((int32_t)l.z + 1) >> 1; /* Q14, as z */
    const int64_t x = l.x, y = 2 * y_q14, z = 2 * z_q14 + 32768;
    const uint32_t peak = glint_root((uint64_t)(x * x + y * y + z * z) << 28);          /* Q29, <= 2^30 + 2^16 */
    const uint32_t reach = (uint32_t)(((uint64_t)tables->t_max_q30 * peak) >> 30) >> 1; /* of e */
    unsigned a = 0;
    while (reach >> a >= 32768)
        a++;
    const unsigned columns_log = tables->dither ? GLINT_DITHER_COLUMNS_LOG : GLINT_COLOUR_COLUMNS_LOG;
    /* e 2^30 / peak >> s: where a = 0 <= 2^31, as s >= 5 (6 if dithered) and peak >= 2^14; else < 2^18 */
    const unsigned scale = 30 + 32 - columns_log + a - tables->shift;
    paint->of.tables.x = 128 * (int32_t)l.x - y_q14; /* Q22; v holds x, too */
    paint->of.tables.y = y_q14;
    paint->of.tables.z = z_q14;
    paint->of.tables.peak = (int32_t)peak;
    paint->of.tables.cut = (int32_t)(peak - (uint32_t)(((uint64_t)tables->t_max_q30 * peak) >> 30));
    paint->of.tables.a = (uint8_t)a;
    paint->of.tables.r = (uint32_t)(peak ? ((uint64_t)1 << scale) / peak : 0);
    paint->of.tables.is_frontal =
        paint->v.x == 0 && paint->v.y == 0 && paint->v.z == 32767 &&
        (!(l.x | l.y | l.z) || colour_is_consistent(paint, peak)); /* without a light no row is looked up */
}

/* ---- Drawn: the general way ---- */

static void colour_raws(const struct glint_paint *paint, const uint32_t *words, struct glint_raw *raws, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        raws[i] = glint_colour_raw(paint, words[i], GLINT_COLOUR_COLUMNS_LOG);
}

/* glossy: with a map of gloss. */
static inline __attribute__((always_inline)) void colour_each(const struct glint_paint *paint,
                                                              const struct glint_run *run, const struct glint_raw *raw,
                                                              unsigned count, bool glossy)
{
    unsigned at = 0;
    const struct glint_look look = glint_look_up(&paint->of.tables.filled);
    uint8_t *out = run->line + 2 * run->x;
    for (const struct glint_raw *end = raw + count; raw != end; raw++, out += 2, at++)
        if (raw->nl_q30 != GLINT_RAW_NOTHING)
            glint_put_pixel(out,
                            glint_look_pixel(&look, raw, glossy ? glint_gloss_part(run->gloss[at]) : GLINT_NO_GLOSS));
}

static void colour_pixels(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raw,
                          unsigned count)
{
    colour_each(paint, run, raw, count, false);
}

static void colour_with_gloss(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raw,
                              unsigned count)
{
    colour_each(paint, run, raw, count, true);
}

#define COLOUR_USE(shiny, glossy)                                                                                      \
    {                                                                                                                  \
        GLINT_TABLES_COLOUR, false, false, GLINT_TABLES_COLOUR_BYTES, colour_can, colour_fill, glint_colour_light,     \
            glint_tables_check, glint_tables_draw, shiny, glossy, colour_raws, colour_pixels,                          \
            GLINT_TABLES_FUSED(glint_colour_line), GLINT_TABLES_FUSED(glint_colour_fused)                              \
    }
const struct glint_use_tables glint_use_colour GLINT_FLASH = COLOUR_USE(NULL, NULL);
const struct glint_use_tables glint_use_colour_maps GLINT_FLASH = COLOUR_USE(glint_tables_shiny, colour_with_gloss);

/* ---- Dithered ---- */

/* Past the highlight a pixel is a function of nl and of its threshold alone: finished, for all sixteen
 * thresholds. Within it, it is the sum of two words with sixteenths of a level, so that it is rounded once, and as finely as the exact
 * paint does. Each line of the screen has its part of the tables, and so its own rows: lines take turns between two rows
 * (glint_dither_look_up's nudge). Phases are 2 (x mod 4): the place of a pixel among the four of a row. */
enum { DITHER_SHINES = 1 << GLINT_DITHER_COLUMNS_LOG };
typedef char glint_dither_bytes[GLINT_DITHER_SHINES + 4 * DITHER_SHINES == GLINT_TABLES_DITHER_BYTES ? 1 : -1];

static const struct glint_field dither_fields[3] GLINT_FLASH = {{23, 31 * 16}, {1, 63 * 16}, {12, 31 * 16}};

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
static inline __attribute__((always_inline)) void dither_each(const struct glint_paint *paint,
                                                              const struct glint_run *run, const struct glint_raw *raw,
                                                              unsigned count, bool glossy)
{
    unsigned at = 0;
    const struct glint_tables *tables = &paint->of.tables.filled;
    const struct glint_dither_look look = glint_dither_look_up(tables, run->y);
    const bool swapped = glint_is_swapped(tables);
    uint32_t phase = 2 * ((run->left + run->x) & 3);
    uint8_t *out = run->line + 2 * run->x;
    for (const struct glint_raw *end = raw + count; raw != end; raw++, out += 2, at++) {
        if (raw->nl_q30 != GLINT_RAW_NOTHING)
            glint_put_pixel(out,
                            glint_dither_pixel(&look, raw, phase,
                                               glossy ? glint_gloss_part(run->gloss[at]) : GLINT_NO_GLOSS, swapped));
        phase = glint_dither_next(phase);
    }
}

static void dither_pixels(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raw,
                          unsigned count)
{
    dither_each(paint, run, raw, count, false);
}

static void dither_with_gloss(const struct glint_paint *paint, const struct glint_run *run, const struct glint_raw *raw,
                              unsigned count)
{
    dither_each(paint, run, raw, count, true);
}

#define DITHER_USE(shiny, glossy)                                                                                      \
    {                                                                                                                  \
        GLINT_TABLES_COLOUR, true, false, GLINT_TABLES_DITHER_BYTES, dither_can, dither_fill, glint_colour_light,      \
            glint_tables_check, glint_tables_draw, shiny, glossy, dither_raws, dither_pixels,                          \
            GLINT_TABLES_FUSED(glint_dither_line), GLINT_TABLES_FUSED(glint_dither_fused)                              \
    }
const struct glint_use_tables glint_use_colour_dithered GLINT_FLASH = DITHER_USE(NULL, NULL);
const struct glint_use_tables glint_use_colour_dithered_maps GLINT_FLASH =
    DITHER_USE(glint_tables_shiny, dither_with_gloss);
